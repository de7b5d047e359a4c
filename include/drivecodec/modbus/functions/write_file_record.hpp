// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/file_record.hpp>
#include <drivecodec/modbus/messages/echo_of.hpp>
#include <drivecodec/modbus/messages/records_message.hpp>

namespace drivecodec::modbus {

/// Write File Record (21), MODBUS Application Protocol V1.1b3, 6.15. The response repeats the request.
struct write_file_record {
    static constexpr auto        code     = function_code::write_file_record;
    static constexpr char const* name     = "write_file_record";
    static constexpr bool        is_write = true;

    static constexpr std::size_t min_byte_count = 9;
    static constexpr std::size_t max_byte_count = 251;

    template <typename Records>
    class basic_request;
    using request  = basic_request<record_list<file_record>>;
    using response = echo_of<request>;

    /// A constant request for one record, checked by the compiler: `of(4, 7, {0x06AF, 0x04BE, 0x100D})`.
    template <std::size_t N>
    [[nodiscard]] static consteval auto of(int file, int record, std::uint16_t const (&words)[N]);
};

template <typename Records>
class write_file_record::basic_request
    : public records_message<write_file_record, Records, min_byte_count, max_byte_count> {
    using base = records_message<write_file_record, Records, min_byte_count, max_byte_count>;

public:
    using base::base;

    /// Errors: `bad_quantity` at the byte count: no record, or more than fit in a PDU.
    [[nodiscard]] static constexpr result<basic_request> make(Records records_to_send) noexcept
    {
        auto const made = base::make(records_to_send);
        if (not made) { return made.error(); }
        return basic_request{*made};
    }

    [[nodiscard]] static constexpr basic_request read(bytes pdu) noexcept { return basic_request{base::read(pdu)}; }

    /// What a server says when it has done this: the first `echo_size()` bytes of the request, which are all.
    [[nodiscard]] constexpr std::size_t            echo_size() const noexcept { return this->wire_size(); }
    [[nodiscard]] constexpr echo_of<basic_request> reply() const noexcept { return {*this}; }

    /// Does the response repeat every record?
    [[nodiscard]] constexpr error matches(basic_request const& given) const noexcept
    {
        return expect_equal(given == *this, layout::records_message::records);
    }

private:
    constexpr explicit basic_request(base const& message) noexcept : base{message} {}
};

template <std::size_t N>
consteval auto write_file_record::of(int file, int record, std::uint16_t const (&words)[N])
{
    using one = basic_file_record<register_array<N>>;
    return basic_request<one>{one{file, record, {std::to_array(words)}}};
}

}  // namespace drivecodec::modbus
