// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/messages/bare_request.hpp>

namespace drivecodec::modbus {

namespace layout::
    report_server_id_response {  // | function | byte count | server ID ... | run indicator | additional ...
inline constexpr u8_at<1>    byte_count{};
inline constexpr std::size_t data = byte_count.end;
}  // namespace layout::report_server_id_response

/// Report Server ID (17), MODBUS Application Protocol V1.1b3, 6.13.
///
/// How long the server ID is, the device decides and the frame does not say: the response gives the bytes, and
/// `split` parts them for a caller who knows the device.
struct report_server_id {
    static constexpr auto        code = function_code::report_server_id;
    static constexpr char const* name = "report_server_id";

    static constexpr std::size_t max_data_size = max_pdu_size - layout::report_server_id_response::data;

    using request = bare_request<report_server_id>;
    class response;

    /// The bytes of a response of a device whose server ID has a known length.
    struct identity {
        static constexpr std::uint8_t on  = 0xFF;
        static constexpr std::uint8_t off = 0x00;

        bytes        server_id;
        std::uint8_t run_indicator;  ///< `on`, `off`; what else a device sends survives.
        bytes        additional_data;
    };
};

class report_server_id::response {
public:
    using function = report_server_id;

    /// `data` is server ID, run indicator, additional data: at least one byte. Errors: `bad_quantity` at the byte
    /// count.
    [[nodiscard]] static constexpr result<response> make(bytes data_to_send) noexcept
    {
        if (data_to_send.empty() or data_to_send.size() > max_data_size) {
            return error{errc::bad_quantity, layout::report_server_id_response::byte_count.begin};
        }
        return response{data_to_send};
    }

    [[nodiscard]] constexpr bytes data() const noexcept { return data_; }

    /// The parts, if the device's server ID has `id_size` bytes.
    ///
    /// Errors: `bad_length` at the byte count if there are too few bytes for that ID and the run indicator.
    [[nodiscard]] constexpr result<identity> split(std::size_t id_size) const noexcept
    {
        if (data_.size() <= id_size) {
            return error{errc::bad_length, layout::report_server_id_response::byte_count.begin};
        }
        return identity{.server_id       = data_.first(id_size),
                        .run_indicator   = data_.data()[id_size],
                        .additional_data = data_.subspan(id_size + 1)};
    }

    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
    {
        return layout::report_server_id_response::data + data_.size();
    }

    [[nodiscard]] static constexpr message_length length(bytes pdu) noexcept
    {
        namespace at = layout::report_server_id_response;
        if (pdu.size() < at::data) { return message_length::at_least(at::data); }
        return message_length::exactly(at::data + at::byte_count.load(pdu));
    }

    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        namespace at = layout::report_server_id_response;
        if (auto const fault = check_head(pdu, code, at::data, at::data + 1); not fault.ok()) { return fault; }
        std::size_t const size = at::byte_count.load(pdu);
        if (size == 0 or size > max_data_size) { return {errc::bad_quantity, at::byte_count.begin}; }
        return check_size(pdu, at::data + size);
    }

    [[nodiscard]] static constexpr response read(bytes pdu) noexcept
    {
        return response{pdu.subspan(layout::report_server_id_response::data)};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::report_server_id_response;
        layout::function.store(out, to_byte(code));
        at::byte_count.store(out, static_cast<std::uint8_t>(data_.size()));
        copy_bytes(data_, out.subspan(at::data));
    }

    friend constexpr bool operator==(response const& a, response const& b) noexcept
    {
        return same_bytes(a.data_, b.data_);
    }

private:
    constexpr explicit response(bytes data) noexcept : data_{data} {}

    bytes data_;
};

}  // namespace drivecodec::modbus
