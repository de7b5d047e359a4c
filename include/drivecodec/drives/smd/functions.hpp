// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/status_block.hpp>
#include <drivecodec/drives/smd/table.hpp>
#include <drivecodec/modbus/function_set.hpp>
#include <drivecodec/modbus/functions/read_registers.hpp>
#include <drivecodec/modbus/functions/write_multiple_registers.hpp>
#include <drivecodec/modbus/functions/write_single_register.hpp>

namespace drivecodec::smd {

namespace compile_error {
// Declared, never defined, not constexpr: calling it is how a consteval function says no. Its name is the text.
void the_smd_reads_one_register_or_6_at_24_or_4_at_c99();
}  // namespace compile_error

/// Of C99, which is read as a whole, wherever a version has it: registers that have these numbers of their own, as c06
/// in PV400, are not what follows.
inline constexpr std::uint16_t software_version_words = 4;
template <version Version>
inline constexpr std::uint16_t software_version_address = address_of("C99", Version);

/// What can be asked for with one read: one register, or the two exceptions. smd manual, section 2.3, D.
class read_range {
public:
    using addressed = modbus::registers;

    static constexpr std::uint16_t max_count = status_block::word_count;

    consteval read_range(int first, int count)
        : first_{static_cast<std::uint16_t>(first)}, count_{static_cast<std::uint16_t>(count)}
    {
        if (first < 0 or first > modbus::last_address or count < 0 or not check(first_, count_).ok()) {
            compile_error::the_smd_reads_one_register_or_6_at_24_or_4_at_c99();
        }
    }

    /// Errors: those of `check`.
    [[nodiscard]] static constexpr result<read_range> make(std::uint16_t first, std::uint16_t count) noexcept
    {
        if (auto const fault = check(first, count); not fault.ok()) { return fault; }
        return from_checked(first, count);
    }

    /// Errors: `bad_quantity` at 2, where it is on the wire. With which exception the drive answers, the manual does
    /// not say.
    [[nodiscard]] static constexpr error check(std::uint16_t first, std::uint16_t count) noexcept
    {
        auto const is_status = first == status_block::address and count == status_block::word_count;
        auto const is_version =
            (first == software_version_address<pv400> or first == software_version_address<pv507>)and count
            == software_version_words;
        return count == 1 or is_status or is_version ? error{} : error{errc::bad_quantity, 2};
    }

    /// Precondition: check(first, count).ok().
    [[nodiscard]] static constexpr read_range from_checked(std::uint16_t first, std::uint16_t count) noexcept
    {
        return read_range{first, count, checked{}};
    }

    [[nodiscard]] constexpr std::uint16_t first() const noexcept { return first_; }
    [[nodiscard]] constexpr std::uint16_t count() const noexcept { return count_; }

    friend constexpr bool operator==(read_range, read_range) noexcept = default;

private:
    struct checked {};
    constexpr read_range(std::uint16_t first, std::uint16_t count, checked) noexcept : first_{first}, count_{count} {}

    std::uint16_t first_;
    std::uint16_t count_;
};

/// The request of both functions that read: as any other on the wire, but of a `read_range`.
template <typename Function>
struct read_request {
    using function = Function;
    using message  = modbus::range_message<Function, read_range>;

    read_range range;

    [[nodiscard]] static constexpr std::size_t                wire_size() noexcept { return message::wire_size(); }
    [[nodiscard]] static constexpr drivecodec::message_length length(bytes pdu) noexcept
    {
        return message::length(pdu);
    }

    /// Errors: those of any request, `bad_quantity` at its offset in the PDU.
    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        if (auto const fault = message::check(pdu); not fault.ok()) { return fault; }
        auto const range = message::read(pdu).range;
        return read_range::check(range.first(), range.count()).moved_by(modbus::layout::range_message::first.begin);
    }

    [[nodiscard]] static constexpr read_request read(bytes pdu) noexcept { return {.range = message::read(pdu).range}; }
    constexpr void                              write(mutable_bytes out) const noexcept { whole().write(out); }

    [[nodiscard]] constexpr bool asks_for(modbus::register_view values) const noexcept
    {
        return whole().asks_for(values);
    }
    template <typename Values>
    [[nodiscard]] constexpr decltype(auto) exactly(Values const& values) const noexcept
    {
        return (values);
    }
    [[nodiscard]] constexpr error matches(typename Function::response const& given) const noexcept
    {
        return whole().matches(given);
    }

    friend constexpr bool operator==(read_request const&, read_request const&) noexcept = default;

private:
    [[nodiscard]] constexpr message whole() const noexcept { return {.range = range}; }
};

/// 03.
struct read_holding_registers {
    static constexpr auto        code = modbus::function_code::read_holding_registers;
    static constexpr char const* name = "read_holding_registers";

    using request = read_request<read_holding_registers>;
    template <typename Values>
    using basic_response = modbus::values_response<read_holding_registers, Values, read_range::max_count>;
    using response       = basic_response<modbus::register_view>;
};

/// 04, which the drive treats as 03.
struct read_input_registers {
    static constexpr auto        code = modbus::function_code::read_input_registers;
    static constexpr char const* name = "read_input_registers";

    using request = read_request<read_input_registers>;
    template <typename Values>
    using basic_response = modbus::values_response<read_input_registers, Values, read_range::max_count>;
    using response       = basic_response<modbus::register_view>;
};

/// 06, and 16 for the same: a single register.
using write_single_register    = modbus::write_single_register;
using write_multiple_registers = modbus::basic_write_multiple_registers<1>;

/// All that the drive serves, and nothing of it as a broadcast.
using functions =
    modbus::function_set<read_holding_registers, read_input_registers, write_single_register, write_multiple_registers>;

}  // namespace drivecodec::smd
