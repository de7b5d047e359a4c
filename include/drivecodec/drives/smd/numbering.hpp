// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/result.hpp>

// How registers are numbered. smd manual, section 2.3 C, and section 7, which writes 4xxxx only.

namespace drivecodec::smd {

namespace compile_error {
// Declared, never defined, not constexpr: calling one is how a consteval function says no. Its name is the text.
void smd_registers_are_numbered_from_0_to_255();
void modbus_registers_are_numbered_from_1_to_256_one_more_than_smd_registers();
void references_are_30001_to_30256_and_40001_to_40256();
}  // namespace compile_error

/// One register, in each of its numberings:
///
///     smd register      #24     what is sent; from 0, and this library's everywhere
///     Modbus register   #25     one greater
///     4xxxx reference   40025   functions 03, 06 and 16
///     3xxxx reference   30025   function 04, which this drive treats as 03
///
/// Made by saying which numbering a number is of. From 0 to 255, as section 3.3 has them; #0 is described nowhere.
class register_number {
public:
    static constexpr std::uint16_t last_smd = 255;

    //=== constants ===//

    [[nodiscard]] static consteval register_number from_smd(long long number)
    {
        auto const made = make_from_smd(number);
        if (not made) { compile_error::smd_registers_are_numbered_from_0_to_255(); }
        return *made;
    }
    [[nodiscard]] static consteval register_number from_modbus(long long number)
    {
        auto const made = make_from_modbus(number);
        if (not made) { compile_error::modbus_registers_are_numbered_from_1_to_256_one_more_than_smd_registers(); }
        return *made;
    }
    /// 4xxxx or 3xxxx.
    [[nodiscard]] static consteval register_number from_reference(long long number)
    {
        auto const made = make_from_reference(number);
        if (not made) { compile_error::references_are_30001_to_30256_and_40001_to_40256(); }
        return *made;
    }

    //=== numbers known only at run time. Errors: `bad_address` at 0 ===//

    [[nodiscard]] static constexpr result<register_number> make_from_smd(long long number) noexcept
    {
        if (number < 0 or number > last_smd) { return error{errc::bad_address, 0}; }
        return register_number{static_cast<std::uint16_t>(number)};
    }
    [[nodiscard]] static constexpr result<register_number> make_from_modbus(long long number) noexcept
    {
        return make_counted_from(1, number);
    }
    /// 4xxxx or 3xxxx.
    [[nodiscard]] static constexpr result<register_number> make_from_reference(long long number) noexcept
    {
        return make_counted_from(number >= first_holding ? first_holding : first_input, number);
    }

    //=== in each numbering ===//

    [[nodiscard]] constexpr std::uint16_t smd() const noexcept { return smd_; }
    [[nodiscard]] constexpr std::uint16_t modbus() const noexcept { return counted_from(1); }
    [[nodiscard]] constexpr std::uint16_t holding_reference() const noexcept { return counted_from(first_holding); }
    [[nodiscard]] constexpr std::uint16_t input_reference() const noexcept { return counted_from(first_input); }

    friend constexpr bool operator==(register_number, register_number) noexcept = default;

private:
    static constexpr std::uint16_t first_holding = 40001;
    static constexpr std::uint16_t first_input   = 30001;

    constexpr explicit register_number(std::uint16_t smd) noexcept : smd_{smd} {}

    [[nodiscard]] static constexpr result<register_number> make_counted_from(long long first, long long number) noexcept
    {
        if (number < first) { return error{errc::bad_address, 0}; }  // before the difference, which might be too great
        return make_from_smd(number - first);
    }
    [[nodiscard]] constexpr std::uint16_t counted_from(std::uint16_t first) const noexcept
    {
        return static_cast<std::uint16_t>(first + smd_);
    }

    std::uint16_t smd_;
};

}  // namespace drivecodec::smd
