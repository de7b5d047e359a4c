#pragma once

#include "support/exchanges.hpp"

#include <drivecodec/modbus/server.hpp>

#include <optional>
#include <vector>

/// A device that serves every public function, and a function that is none.
namespace full_device {

using namespace drivecodec::modbus;
using drivecodec::bytes;
using drivecodec::error;
using drivecodec::message_length;
using drivecodec::mutable_bytes;

inline constexpr std::array<device_object, 3> identity{{
    {.id = device_object_id::vendor_name, .value = vectors::read_coils_request},
    {.id = device_object_id::product_code, .value = vectors::read_coils_response},
    {.id = device_object_id::major_minor_revision, .value = vectors::exception_response},
}};

struct device {
    std::array<std::uint16_t, 300> words{};
    std::array<bool, 2200>         bits{};
    std::array<std::uint8_t, 4>    id{0x41, 0x42, 0xFF, 0x07};
    unsigned                       asked = 0;

    /// Every answer is an exception, if there is one.
    std::optional<exception_code> broken{};

    static constexpr auto no_such_address = exception_code::illegal_data_address;

    template <typename T>
    answer<T> give(T value)
    {
        ++asked;
        if (broken) { return *broken; }
        return value;
    }

    register_view first_words(std::size_t count) const { return std::span<std::uint16_t const>{words}.first(count); }

    answer<coil_view> read_bits(std::size_t first, std::size_t count)
    {
        if (first + count > bits.size()) { return no_such_address; }
        return give(coil_view{std::span<bool const>{bits}.subspan(first, count)});
    }
    answer<register_view> read_words(std::size_t first, std::size_t count)
    {
        if (first + count > words.size()) { return no_such_address; }
        return give(register_view{std::span<std::uint16_t const>{words}.subspan(first, count)});
    }
    answer<done> write_words(std::size_t first, auto const& values)
    {
        if (first + values.size() > words.size()) { return no_such_address; }
        for (std::size_t i = 0; i < values.size(); ++i) { words[first + i] = values[i]; }
        return give(done{});
    }
    answer<done> write_bits(std::size_t first, auto const& states)
    {
        if (first + states.size() > bits.size()) { return no_such_address; }
        for (std::size_t i = 0; i < states.size(); ++i) { bits[first + i] = states[i]; }
        return give(done{});
    }

    auto operator()(read_coils::request const& r) { return read_bits(r.range.first(), r.range.count()); }
    auto operator()(read_discrete_inputs::request const& r) { return read_bits(r.range.first(), r.range.count()); }
    auto operator()(read_holding_registers::request const& r) { return read_words(r.range.first(), r.range.count()); }
    auto operator()(read_input_registers::request const& r) { return read_words(r.range.first(), r.range.count()); }
    auto operator()(write_single_coil::request const& r) { return write_bits(r.address, std::array{r.value}); }
    auto operator()(write_single_register::request const& r) { return write_words(r.address, std::array{r.value}); }
    auto operator()(read_exception_status::request const&) { return give(std::uint8_t{0x6D}); }
    answer<diagnostics::response> operator()(diagnostics::request const& r)
    {
        ++asked;
        if (broken) { return *broken; }
        if (r.sub_function() == diagnostic::return_bus_message_count) { return *r.reply_with(first_words(1)); }
        return r.reply();
    }
    auto operator()(get_comm_event_counter::request const&)
    {
        return give(get_comm_event_counter::response{.busy = true, .event_count = 0x0108});
    }
    answer<get_comm_event_log::response> operator()(get_comm_event_log::request const&)
    {
        ++asked;
        if (broken) { return *broken; }
        return *get_comm_event_log::response::make(false, 0x0108, 0x0121, id);
    }
    auto operator()(write_multiple_coils::request const& r) { return write_bits(r.block.first(), r.block.values()); }
    auto operator()(write_multiple_registers::request const& r) { return write_words(r.block.first(), r.block.values()); }
    answer<report_server_id::response> operator()(report_server_id::request const&)
    {
        ++asked;
        if (broken) { return *broken; }
        return *report_server_id::response::make(id);
    }
    answer<read_file_record::response> operator()(read_file_record::request const& r)
    {
        ++asked;
        if (broken) { return *broken; }
        records.clear();
        for (auto const range : r.records()) { records.push_back(*file_values::make(first_words(range.count()))); }
        return *read_file_record::response::make(std::span<file_values const>{records});
    }
    auto operator()(write_file_record::request const&) { return give(done{}); }
    answer<done> operator()(mask_write_register::request const& r)
    {
        return write_words(r.address, std::array{r.apply(words[r.address % words.size()])});
    }
    answer<register_view> operator()(read_write_multiple_registers::request const& r)
    {
        if (auto const written = write_words(r.write_block.first(), r.write_block.values()); not written) {
            return written.error();
        }
        return read_words(r.read_range.first(), r.read_range.count());
    }
    answer<read_fifo_queue::response> operator()(read_fifo_queue::request const&)
    {
        ++asked;
        if (broken) { return *broken; }
        return *read_fifo_queue::response::make(first_words(31));
    }
    answer<canopen_general_reference::response> operator()(canopen_general_reference::request const& r)
    {
        ++asked;
        if (broken) { return *broken; }
        return *canopen_general_reference::response::make(r.payload());
    }
    answer<read_device_identification::response> operator()(read_device_identification::request const& r)
    {
        ++asked;
        if (broken) { return *broken; }
        return read_device_identification::answer(r, device_conformity::basic_and_specific, identity);
    }

    std::vector<file_values> records{};
};

//=== a function of one's own ===//

/// | 41 | count | ... answered by | 41 | count | count bytes ... |
struct my_function {
    static constexpr auto        code = static_cast<function_code>(0x41);
    static constexpr char const* name = "my_function";

    struct response {
        using function = my_function;
        bytes data;

        [[nodiscard]] constexpr std::size_t           wire_size() const noexcept { return 2 + data.size(); }
        [[nodiscard]] static constexpr message_length length(bytes pdu) noexcept
        {
            return pdu.size() < 2 ? message_length::at_least(2) : message_length::exactly(2U + pdu[1]);
        }
        [[nodiscard]] static constexpr error check(bytes pdu) noexcept
        {
            if (auto const fault = check_head(pdu, code, 2, 2); not fault.ok()) { return fault; }
            return check_size(pdu, 2U + pdu[1]);
        }
        [[nodiscard]] static constexpr response read(bytes pdu) noexcept { return {pdu.subspan(2)}; }
        constexpr void                          write(mutable_bytes out) const noexcept
        {
            out[0] = to_byte(code);
            out[1] = static_cast<std::uint8_t>(data.size());
            drivecodec::copy_bytes(data, out.subspan(2));
        }
    };
    struct request {
        using function = my_function;
        std::uint8_t count;

        [[nodiscard]] static constexpr std::size_t    wire_size() noexcept { return 2; }
        [[nodiscard]] static constexpr message_length length(bytes) noexcept { return message_length::exactly(2); }
        [[nodiscard]] static constexpr error          check(bytes pdu) noexcept { return check_fixed(pdu, code, 2); }
        [[nodiscard]] static constexpr request        read(bytes pdu) noexcept { return {pdu[1]}; }
        constexpr void                                write(mutable_bytes out) const noexcept
        {
            out[0] = to_byte(code);
            out[1] = count;
        }
        [[nodiscard]] constexpr error matches(response const& given) const noexcept
        {
            return expect_equal(given.data.size() == count, 1);
        }
    };
};
static_assert(function<my_function>);

}  // namespace full_device
