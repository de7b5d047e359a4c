// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/file_values.hpp>
#include <drivecodec/modbus/messages/records_message.hpp>

namespace drivecodec::modbus {

/// Read File Record (20), MODBUS Application Protocol V1.1b3, 6.14.
struct read_file_record {
    static constexpr auto        code = function_code::read_file_record;
    static constexpr char const* name = "read_file_record";

    /// Of the request, 6.14. The response: at least one register, and what fits in a PDU.
    static constexpr std::size_t min_byte_count          = 7;
    static constexpr std::size_t max_byte_count          = 245;
    static constexpr std::size_t min_response_byte_count = 4;
    static constexpr std::size_t max_response_byte_count = max_pdu_size - layout::records_message::records;

    class request;
    class response;
};

/// The values of each range asked for, in the same order.
class read_file_record::response : public records_message<read_file_record, record_list<file_values>,
                                                          min_response_byte_count, max_response_byte_count> {
    using base =
        records_message<read_file_record, record_list<file_values>, min_response_byte_count, max_response_byte_count>;

public:
    /// Errors: `bad_quantity` at the byte count: no values, or more than fit in a PDU.
    [[nodiscard]] static constexpr result<response> make(record_list<file_values> values_to_send) noexcept
    {
        auto const made = base::make(values_to_send);
        if (not made) { return made.error(); }
        return response{*made};
    }

    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        namespace at = layout::records_message;
        if (pdu.size() >= at::records and layout::function.load(pdu) == to_byte(code)
            and at::byte_count.load(pdu) % 2 != 0) {
            return {errc::bad_length, at::byte_count.begin};
        }
        return base::check(pdu);
    }

    [[nodiscard]] static constexpr response read(bytes pdu) noexcept { return response{base::read(pdu)}; }

private:
    constexpr explicit response(base const& message) noexcept : base{message} {}
};

/// Asks for up to 35 ranges, of which the values fit in one response.
class read_file_record::request
    : public records_message<read_file_record, record_list<file_record_range>, min_byte_count, max_byte_count> {
    using base = records_message<read_file_record, record_list<file_record_range>, min_byte_count, max_byte_count>;

public:
    /// Errors: `bad_quantity` at the byte count: no range, too many ranges, or values that no response can carry.
    [[nodiscard]] static constexpr result<request> make(record_list<file_record_range> ranges) noexcept
    {
        auto const made = base::make(ranges);
        if (not made) { return made.error(); }
        if (not check_total(*made).ok()) {
            return error{errc::bad_quantity, layout::records_message::byte_count.begin};
        }
        return request{*made};
    }

    /// `bad_quantity` at the length of the range whose values no longer fit in the response.
    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        auto const fault = base::check(pdu);
        return fault.ok() ? check_total(base::read(pdu)) : fault;
    }

    [[nodiscard]] static constexpr request read(bytes pdu) noexcept { return request{base::read(pdu)}; }

    /// Does the response have as many values for each range as this asked for?
    [[nodiscard]] constexpr error matches(response const& given) const noexcept
    {
        std::size_t offset = layout::records_message::records;
        auto        values = given.records().begin();
        for (auto const range : records()) {
            if (values == given.records().end()) {
                return expect_equal(false, layout::records_message::byte_count.begin);
            }
            auto const record = *values;
            if (record.values.size() != range.count()) { return expect_equal(false, offset); }
            offset += record.wire_size();
            ++values;
        }
        return expect_equal(values == given.records().end(), layout::records_message::byte_count.begin);
    }

private:
    constexpr explicit request(base const& message) noexcept : base{message} {}

    [[nodiscard]] static constexpr error check_total(base const& message) noexcept
    {
        std::size_t offset = layout::records_message::records;
        std::size_t total  = 0;
        for (auto const range : message.records()) {
            total += layout::file_values::values + registers::wire_size(range.count());
            if (total > max_response_byte_count) {
                return {errc::bad_quantity, offset + layout::file_record_range::length.begin};
            }
            offset += file_record_range::wire_size();
        }
        return {};
    }
};

}  // namespace drivecodec::modbus
