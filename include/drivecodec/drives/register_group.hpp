// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/holding_register.hpp>
#include <drivecodec/modbus/functions/write_multiple_registers.hpp>

namespace drivecodec::drives {

/// The place of `Register` in a list of registers; their number if it is not there.
template <typename Register, auto... Registers>
inline constexpr std::size_t index_of = [] {
    std::size_t index = 0;
    static_cast<void>(((Registers.address() == Register::address() or ++index == 0) or ...));  // never 0: goes on
    return index;
}();

/// The 16 bits of a value for each of `Registers`. Errors: those of the first `make_write` that fails, at its place in
/// the list; `words` is then not to be used.
template <auto... Registers>
[[nodiscard]] constexpr error make_words(modbus::register_array<sizeof...(Registers)>& words,
                                         typename decltype(Registers)::value_type... values) noexcept
{
    error       fault{};
    std::size_t index = 0;

    auto const take = [&](auto const& written) {
        if (not written and fault.ok()) { fault = written.error().moved_by(index); }
        if (written) { words.words[index] = written->value; }
        ++index;
    };
    (take(Registers.make_write(values)), ...);
    return fault;
}

/// Registers with adjacent addresses, in their order: read or written with one request.
template <typename Read, typename Write, auto First, auto... Others>
struct register_group {
    static constexpr std::size_t count = 1 + sizeof...(Others);

    using write_request = typename Write::template basic_request<modbus::register_array<count>>;

    static_assert(
        [] {
            auto next = First.address();
            return ((++next == Others.address()) and ...);
        }(),
        "registers of one request must have adjacent addresses, in ascending order, without a gap");

    /// A count that the drive does not allow does not compile.
    [[nodiscard]] static consteval typename Read::request read()
    {
        return {.range = {First.address(), static_cast<int>(count)}};
    }

    /// The value of one of them in a response to `read`. Precondition: the response is as long as was asked for.
    template <typename Register>
    [[nodiscard]] static constexpr auto value(Register, modbus::register_view values) noexcept
    {
        constexpr auto index = index_of<Register, First, Others...>;
        static_assert(index < count, "this register is not one of the group");
        return Register::value(values[index]);
    }

    /// Constant values, one for each register: refused by the compiler if a register cannot take its value.
    [[nodiscard]] static consteval write_request write(typename decltype(First)::value_type first,
                                                       typename decltype(Others)::value_type... others)
    {
        return {.block = {First.address(), {{First.write(first).value, Others.write(others).value...}}}};
    }

    /// Values known only at run time. Errors: those of each register's `make_write`, at its place in the group.
    [[nodiscard]] static constexpr result<write_request>
    make_write(typename decltype(First)::value_type first, typename decltype(Others)::value_type... others) noexcept
    {
        modbus::register_array<count> words{};
        auto const                    fault = make_words<First, Others...>(words, first, others...);
        if (not fault.ok()) { return fault; }
        return write_request::make(First.address(), words);
    }
};

}  // namespace drivecodec::drives
