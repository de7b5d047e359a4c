// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/xd1000/registers.hpp>

// The communication scanner: up to four registers written and four read with one request of function 23, wherever their
// addresses are. xD1000 manual, "Integrated communication scanner". Inputs go from the drive to the client, outputs
// from the client to the drive.

namespace drivecodec::xd1000 {

inline constexpr std::size_t scanner_words = 4;

/// Which register each word is copied from or to, by address; 0 is none. Without arguments, as the drive leaves the
/// factory. A word that is none keeps its place: the one behind it is still the one behind it.
class scanner_configuration {
public:
    using addresses     = std::array<std::uint16_t, scanner_words>;
    using write_request = write_multiple_registers::basic_request<modbus::register_array<scanner_words>>;

    constexpr scanner_configuration() noexcept = default;

    /// Errors: `bad_address` for a register that the manual does not have, `read_only` for an output that cannot be
    /// written. The offset is the word's: 0 to 3 for inputs, 4 to 7 for outputs.
    [[nodiscard]] static constexpr result<scanner_configuration> make(addresses const& inputs,
                                                                      addresses const& outputs) noexcept
    {
        for (std::size_t i = 0; i < scanner_words; ++i) {
            if (inputs[i] != 0 and find(inputs[i]) == nullptr) { return error{errc::bad_address, i}; }
        }
        for (std::size_t i = 0; i < scanner_words; ++i) {
            auto const* row = find(outputs[i]);
            if (outputs[i] != 0 and row == nullptr) { return error{errc::bad_address, scanner_words + i}; }
            if (outputs[i] != 0 and not row->is_writable()) { return error{errc::read_only, scanner_words + i}; }
        }
        return scanner_configuration{inputs, outputs};
    }

    /// As it was read from the drive, whatever it holds: a drive has more registers than its manual names.
    /// Errors: `bad_quantity` if they are not four words each, at 0 for inputs, at 4 for outputs.
    [[nodiscard]] static constexpr result<scanner_configuration> decode(modbus::register_view inputs,
                                                                        modbus::register_view outputs) noexcept
    {
        if (inputs.size() != scanner_words) { return error{errc::bad_quantity, 0}; }
        if (outputs.size() != scanner_words) { return error{errc::bad_quantity, scanner_words}; }
        return scanner_configuration{{inputs[0], inputs[1], inputs[2], inputs[3]},
                                     {outputs[0], outputs[1], outputs[2], outputs[3]}};
    }

    [[nodiscard]] constexpr addresses const& inputs() const noexcept { return inputs_; }
    [[nodiscard]] constexpr addresses const& outputs() const noexcept { return outputs_; }

    //=== ask the drive how it is set up, for `decode` ===//

    [[nodiscard]] static consteval read_holding_registers::request read_inputs()
    {
        return registers<nma1, nma2, nma3, nma4>::read();
    }
    [[nodiscard]] static consteval read_holding_registers::request read_outputs()
    {
        return registers<nca1, nca2, nca3, nca4>::read();
    }

    //=== set up the drive: while the motor stands ===//

    /// 705.0 to 705.3.
    [[nodiscard]] constexpr write_request write_inputs() const noexcept { return write(nma1.address(), inputs_); }
    /// 706.0 to 706.3.
    [[nodiscard]] constexpr write_request write_outputs() const noexcept { return write(nca1.address(), outputs_); }

    //=== exchange ===//

    /// Writes `values` to the outputs, from the first on, and reads all inputs that are in use; values go to 708.0 and
    /// on, inputs come from 707.0 and on. Errors, as those of the request: `bad_quantity` for none or more than four
    /// values, or if no input is in use.
    [[nodiscard]] constexpr result<read_write_multiple_registers::request>
    exchange(modbus::register_view values) const noexcept
    {
        auto const range = read_write_multiple_registers::range_to_read::make(
            nm1.address(), static_cast<std::uint16_t>(words_in_use(inputs_)));
        if (not range) { return range.error(); }
        return read_write_multiple_registers::request::make(*range, nc1.address(), values);
    }

    /// The 16 bits of the register `address` among the inputs of an answer. Errors, at 0: `bad_address` if it is not
    /// mapped or the answer does not go as far.
    [[nodiscard]] constexpr result<std::uint16_t> input(std::uint16_t         address,
                                                        modbus::register_view answer) const noexcept
    {
        for (std::size_t i = 0; i < scanner_words and i < answer.size(); ++i) {
            if (inputs_[i] == address and address != 0) { return answer[i]; }
        }
        return error{errc::bad_address, 0};
    }

    /// The same as what it is: `input(rfrd, answer)`.
    template <typename Register>
    [[nodiscard]] constexpr auto input(Register, modbus::register_view answer) const noexcept
        -> result<typename Register::value_type>
    {
        auto const raw = input(Register::address(), answer);
        if (not raw) { return raw.error(); }
        return Register::value(*raw);
    }

    friend constexpr bool operator==(scanner_configuration const&, scanner_configuration const&) noexcept = default;

private:
    constexpr scanner_configuration(addresses const& inputs, addresses const& outputs) noexcept
        : inputs_{inputs}, outputs_{outputs}
    {}

    [[nodiscard]] static constexpr std::size_t words_in_use(addresses const& words) noexcept
    {
        auto count = scanner_words;
        while (count > 0 and words[count - 1] == 0) { --count; }
        return count;
    }

    [[nodiscard]] static constexpr write_request write(std::uint16_t first, addresses const& words) noexcept
    {
        using block = decltype(write_request::block);
        return {.block = block::from_checked(first, {words})};
    }

    addresses inputs_{eta.address(), rfrd.address(), 0, 0};
    addresses outputs_{cmd.address(), lfrd.address(), 0, 0};
};

template <auto... Registers>
struct outputs {};
template <auto... Registers>
struct inputs {};

/// A scanner of which the compiler knows the registers: `scanner<outputs<cmd, lfrd, cmi>, inputs<eta, rfrd, eti>>`.
template <typename Outputs = outputs<cmd, lfrd>, typename Inputs = inputs<eta, rfrd>>
struct scanner;

template <auto... Out, auto... In>
struct scanner<outputs<Out...>, inputs<In...>> {
    static_assert(sizeof...(Out) >= 1 and sizeof...(Out) <= scanner_words, "the scanner has one to four output words");
    static_assert(sizeof...(In) >= 1 and sizeof...(In) <= scanner_words, "the scanner has one to four input words");
    static_assert((Out.row.is_writable() and ...), "an output of the scanner must be a register that can be written");

    using request = read_write_multiple_registers::basic_request<modbus::register_array<sizeof...(Out)>>;

    /// What the drive is to be set up with.
    [[nodiscard]] static constexpr scanner_configuration configuration() noexcept
    {
        return *scanner_configuration::make({In.address()...}, {Out.address()...});
    }

    /// Constant values, one for each output: refused by the compiler if a register cannot take its value.
    [[nodiscard]] static consteval request exchange(typename decltype(Out)::value_type... values)
    {
        return with({{Out.write(values).value...}});
    }

    /// Values known only at run time. Errors: those of each register's `make_write`, at its place among the outputs.
    [[nodiscard]] static constexpr result<request> make_exchange(typename decltype(Out)::value_type... values) noexcept
    {
        modbus::register_array<sizeof...(Out)> words{};
        auto const                             fault = drives::make_words<Out...>(words, values...);
        if (not fault.ok()) { return fault; }
        return with(words);
    }

    /// The value of one of the inputs in an answer. Precondition: the answer is as long as was asked for.
    template <typename Register>
    [[nodiscard]] static constexpr typename Register::value_type value(Register, modbus::register_view answer) noexcept
    {
        constexpr auto index = drives::index_of<Register, In...>;
        static_assert(index < sizeof...(In), "this register is not among the inputs of the scanner");
        return Register::value(answer[index]);
    }

private:
    [[nodiscard]] static constexpr request with(modbus::register_array<sizeof...(Out)> const& words) noexcept
    {
        using range = read_write_multiple_registers::range_to_read;
        using block = typename request::block_to_write;
        return {.read_range  = range::from_checked(nm1.address(), sizeof...(In)),
                .write_block = block::from_checked(nc1.address(), words)};
    }
};

}  // namespace drivecodec::xd1000
