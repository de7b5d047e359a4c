// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/registers.hpp>
#include <drivecodec/drives/smd/software_version.hpp>

// The parameters by code, each where its version has it:
//
//     rtu::encode(5, smd::C12<smd::pv507>.write(5.0_s))
//     smd::C14<smd::pv400>.value(2)

namespace drivecodec::smd {

/// The three characters of a parameter's code, as a template argument.
struct parameter_code {
    char letters[4]{};

    consteval parameter_code(char const (&code)[4]) : letters{code[0], code[1], code[2], code[3]} {}

    [[nodiscard]] constexpr std::string_view view() const noexcept { return {letters, 3}; }
};

namespace detail {

template <parameter_code Code, version Version>
struct located {
    static constexpr bool is_known   = address_of(Code.view(), pv507) != absent;  // which has all
    static constexpr bool is_present = address_of(Code.view(), Version) != absent;

    static_assert(is_known, "the smd manual has no parameter of this code; codes are case sensitive");
    static_assert(is_present or not is_known, "this version of the smd does not have this parameter");

    /// Of one that there is, so that nothing else is wrong.
    static constexpr std::uint16_t address = address_of(is_present ? Code.view() : "C01", Version);
};

/// What the value of a parameter is: what the table says, unless it has a type of its own.
template <parameter_code Code, version Version>
struct value_of {
    using type = drives::number_in<table<Version>, located<Code, Version>::address>;
};
using drives::value_is;

// clang-format off
template <version V> struct value_of<"C01", V> : value_is<control_mode> {};
template <version V> struct value_of<"C02", V> : value_is<load_defaults> {};
template <version V> struct value_of<"CE1", V> : value_is<digital_input_function> {};
template <version V> struct value_of<"CE2", V> : value_is<digital_input_function> {};
template <version V> struct value_of<"CE3", V> : value_is<digital_input_function> {};
template <version V> struct value_of<"C08", V> : value_is<output_function> {};
template <version V> struct value_of<"C14", V> : value_is<operating_mode> {};
template <version V> struct value_of<"C18", V> : value_is<chopper_frequency> {};
template <version V> struct value_of<"C31", V> : value_is<analog_input_deadband> {};
template <version V> struct value_of<"C34", V> : value_is<analog_input> {};
template <version V> struct value_of<"C90", V> : value_is<input_voltage> {};
template <version V> struct value_of<"c11", V> : value_is<analog_output> {};
template <version V> struct value_of<"c17", V> : value_is<output_function> {};
template <version V> struct value_of<"c25", V> : value_is<serial_format> {};
template <version V> struct value_of<"c42", V> : value_is<start_condition> {};
template <version V> struct value_of<"c60", V> : value_is<fault_mode> {};
template <version V> struct value_of<"c61", V> : value_is<fault> {};
template <version V> struct value_of<"c62", V> : value_is<fault> {};
template <version V> struct value_of<"c63", V> : value_is<fault> {};
template <version V> struct value_of<"c70", V> : value_is<trip_reset> {};
template <version V> struct value_of<"d38", V> : value_is<pi_enable> {};
template <version V> struct value_of<"n20", V> : value_is<power_up_state> {};
template <version V> struct value_of<"n22", V> : value_is<serial_timeout_action> {};
// clang-format on

template <parameter_code Code, version Version>
[[nodiscard]] consteval auto parameter_of()
{
    constexpr auto address = located<Code, Version>::address;
    if constexpr (drives::find(table<Version>, address)->type == drives::raw_type::text) {
        return software_version_parameter<Version>{};
    } else {
        using value = typename value_of<Code, Version>::type;
        return drives::holding_register<table<Version>, address, read_holding_registers, value>{};
    }
}

}  // namespace detail

/// The parameter of this code, in a version that has it: `parameter<"C12", pv507>`.
template <parameter_code Code, version Version>
inline constexpr auto parameter = detail::parameter_of<Code, Version>();

// The same as a name. What each is called is in the table.
// clang-format off
template <version V> inline constexpr auto C01 = parameter<"C01", V>;
template <version V> inline constexpr auto C02 = parameter<"C02", V>;
template <version V> inline constexpr auto CE1 = parameter<"CE1", V>;
template <version V> inline constexpr auto CE2 = parameter<"CE2", V>;
template <version V> inline constexpr auto CE3 = parameter<"CE3", V>;
template <version V> inline constexpr auto C08 = parameter<"C08", V>;
template <version V> inline constexpr auto C09 = parameter<"C09", V>;
template <version V> inline constexpr auto C10 = parameter<"C10", V>;
template <version V> inline constexpr auto C11 = parameter<"C11", V>;
template <version V> inline constexpr auto C12 = parameter<"C12", V>;
template <version V> inline constexpr auto C13 = parameter<"C13", V>;
template <version V> inline constexpr auto C14 = parameter<"C14", V>;
template <version V> inline constexpr auto C15 = parameter<"C15", V>;
template <version V> inline constexpr auto C16 = parameter<"C16", V>;
template <version V> inline constexpr auto C17 = parameter<"C17", V>;
template <version V> inline constexpr auto C18 = parameter<"C18", V>;
template <version V> inline constexpr auto C21 = parameter<"C21", V>;
template <version V> inline constexpr auto C22 = parameter<"C22", V>;
template <version V> inline constexpr auto C24 = parameter<"C24", V>;
template <version V> inline constexpr auto C31 = parameter<"C31", V>;
template <version V> inline constexpr auto C34 = parameter<"C34", V>;
template <version V> inline constexpr auto C36 = parameter<"C36", V>;
template <version V> inline constexpr auto C37 = parameter<"C37", V>;
template <version V> inline constexpr auto C38 = parameter<"C38", V>;
template <version V> inline constexpr auto C39 = parameter<"C39", V>;
template <version V> inline constexpr auto C46 = parameter<"C46", V>;
template <version V> inline constexpr auto C50 = parameter<"C50", V>;
template <version V> inline constexpr auto C52 = parameter<"C52", V>;
template <version V> inline constexpr auto C53 = parameter<"C53", V>;
template <version V> inline constexpr auto C54 = parameter<"C54", V>;
template <version V> inline constexpr auto C56 = parameter<"C56", V>;
template <version V> inline constexpr auto C59 = parameter<"C59", V>;
template <version V> inline constexpr auto C70 = parameter<"C70", V>;
template <version V> inline constexpr auto C71 = parameter<"C71", V>;
template <version V> inline constexpr auto C90 = parameter<"C90", V>;
template <version V> inline constexpr auto C94 = parameter<"C94", V>;
template <version V> inline constexpr auto C99 = parameter<"C99", V>;
template <version V> inline constexpr auto c01 = parameter<"c01", V>;
template <version V> inline constexpr auto c03 = parameter<"c03", V>;
template <version V> inline constexpr auto c06 = parameter<"c06", V>;
template <version V> inline constexpr auto c08 = parameter<"c08", V>;
template <version V> inline constexpr auto c11 = parameter<"c11", V>;
template <version V> inline constexpr auto c17 = parameter<"c17", V>;
template <version V> inline constexpr auto c20 = parameter<"c20", V>;
template <version V> inline constexpr auto c25 = parameter<"c25", V>;
template <version V> inline constexpr auto c38 = parameter<"c38", V>;
template <version V> inline constexpr auto c40 = parameter<"c40", V>;
template <version V> inline constexpr auto c42 = parameter<"c42", V>;
template <version V> inline constexpr auto c60 = parameter<"c60", V>;
template <version V> inline constexpr auto c61 = parameter<"c61", V>;
template <version V> inline constexpr auto c62 = parameter<"c62", V>;
template <version V> inline constexpr auto c63 = parameter<"c63", V>;
template <version V> inline constexpr auto c70 = parameter<"c70", V>;
template <version V> inline constexpr auto c71 = parameter<"c71", V>;
template <version V> inline constexpr auto c78 = parameter<"c78", V>;
template <version V> inline constexpr auto c79 = parameter<"c79", V>;
template <version V> inline constexpr auto c81 = parameter<"c81", V>;
template <version V> inline constexpr auto c82 = parameter<"c82", V>;
template <version V> inline constexpr auto c86 = parameter<"c86", V>;
template <version V> inline constexpr auto c87 = parameter<"c87", V>;
template <version V> inline constexpr auto d25 = parameter<"d25", V>;
template <version V> inline constexpr auto d38 = parameter<"d38", V>;
template <version V> inline constexpr auto d46 = parameter<"d46", V>;
template <version V> inline constexpr auto d47 = parameter<"d47", V>;
template <version V> inline constexpr auto n20 = parameter<"n20", V>;
template <version V> inline constexpr auto n22 = parameter<"n22", V>;
template <version V> inline constexpr auto n23 = parameter<"n23", V>;
// clang-format on

}  // namespace drivecodec::smd
