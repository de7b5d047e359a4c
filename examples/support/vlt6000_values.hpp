// SPDX-License-Identifier: MIT
#pragma once

#include "support/arguments.hpp"

#include <drivecodec/fc.hpp>
#include <drivecodec/text/vlt6000.hpp>
#include <drivecodec/vlt6000.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

// Values of a VLT 6000's parameters on a command line. Of many, the manual does not state how they are transferred:
// then the user has to.

namespace support {

namespace fc      = drivecodec::fc;
namespace vlt6000 = drivecodec::vlt6000;

/// How a value is transferred, and which; what is not given is the manual's, or nobody's.
struct vlt6000_value_options {
    std::optional<fc::data_type> type;
    std::optional<int>           scale;
    std::uint8_t                 index = 0;
    fc::storage                  where = fc::storage::ram;

    static constexpr auto usage = R"(  --index N         the element of an array, as 615
  --eeprom          writes to RAM and to EEPROM, which wears out
  --scale N         the conversion index: -1 if 1000 stands for 100.0
  --as TYPE         word, double-word, signed-word or signed-double-word
                    where the manual does not state scale or type, or the drive has others
)";

    [[nodiscard]] bool take(std::string const& word, arguments& rest)
    {
        auto const value = [&] { return rest.next("the value of " + word); };
        if (word == "--index") {
            index = to<std::uint8_t>(value());
        } else if (word == "--eeprom") {
            where = fc::storage::ram_and_eeprom;
        } else if (word == "--scale") {
            scale = to<int>(value(), -7, 6);
        } else if (word == "--as") {
            type = to_type(value());
        } else {
            return false;
        }
        return true;
    }

private:
    [[nodiscard]] static fc::data_type to_type(std::string const& name)
    {
        static constexpr struct {
            std::string_view name;
            fc::data_type    type;
        } rows[] = {{"word", fc::data_type::unsigned_16},
                    {"double-word", fc::data_type::unsigned_32},
                    {"signed-word", fc::data_type::integer_16},
                    {"signed-double-word", fc::data_type::integer_32}};
        for (auto const& row : rows) {
            if (row.name == name) { return row.type; }
        }
        throw usage_error{"'" + name + "' is not a type such as word"};
    }
};

/// Is the value transferred as it is, because it is no quantity? A number without a unit, of which the manual prints the
/// limits, counts something.
[[nodiscard]] inline bool is_code(vlt6000::parameter_row const* row)
{
    if (row == nullptr) { return false; }
    auto const is_count = row->unit == drivecodec::unit::none and row->limits.is_known;
    return row->kind == vlt6000::kind::choice or row->kind == vlt6000::kind::bits or is_count;
}

/// As the manual and the user state it.
[[nodiscard]] inline vlt6000::transfer transfer_of(vlt6000::parameter_row const* row,
                                                   vlt6000_value_options const&  given)
{
    auto how = row == nullptr ? vlt6000::transfer{} : vlt6000::transfer::of(*row);
    if (given.type) {
        how.width     = fc::width_of(*given.type);
        how.data_type = *given.type;
    }
    if (given.scale) { how.conversion_index = static_cast<std::int8_t>(*given.scale); }
    if (not how.conversion_index and is_code(row)) { how.conversion_index = std::int8_t{0}; }
    return how;
}

/// `202 output_frequency_high_limit 100.0 Hz`. Throws a value_error where `--as` is not what the drive gives.
[[nodiscard]] inline std::string explain_value(fc::parameter_response const& given, vlt6000_value_options const& asked)
{
    std::array<char, 1200>  room{};
    drivecodec::text_writer text{room};
    auto const*             row = vlt6000::find(given.number());
    auto const              how = transfer_of(row, asked);
    if ((asked.type or asked.scale) and not is_code(row)) {
        auto const number = vlt6000::number_in(given, how);
        if (not number) {
            throw value_error{"PWE is " + std::to_string(given.pwe) + ", of which --as has to tell width and sign"};
        }
        auto const exponent = *how.conversion_index + (row == nullptr ? 0 : row->unit_prefix);
        auto const unit     = row == nullptr ? drivecodec::unit::none : row->unit;
        vlt6000::write_title(text, given.number());
        text.put(' ');
        write_quantity(text, {*number, static_cast<std::int8_t>(exponent)},
                       how.conversion_index ? unit : drivecodec::unit::none);
    } else {
        write_text(text, vlt6000::parameter_value{given.number(), given.pwe});
    }
    if (not how.conversion_index) {
        text.put(", as transferred in a ").put(given.reply() == fc::ak_reply::word ? "word" : "double word");
        text.put(": the manual does not state the scale");
    }
    return std::string{text.view_with_ellipsis()};
}

/// PWE for a value. Throws a value_error where it is not known how it is transferred, or the manual says that it cannot
/// be written.
[[nodiscard]] inline std::uint32_t to_pwe(std::uint16_t number, drivecodec::decimal value, vlt6000::transfer const& how)
{
    auto const  name = std::to_string(number);
    auto const* row  = vlt6000::find(number);
    if (row != nullptr and not row->is_writable()) {
        throw value_error{"the manual says that " + name + " cannot be written over the bus"};
    }
    if (not how.width) {
        throw value_error{"the manual does not state whether " + name
                          + " is a word or a double word: say --as, and ask the drive with read"};
    }
    if (not how.conversion_index) {
        throw value_error{"the manual does not state the scale of " + name + ": say --scale, such as 0"};
    }
    auto const prefix = row == nullptr ? 0 : row->unit_prefix;
    auto const scaled = value.scaled_to(*how.conversion_index + prefix);
    if (not scaled) { throw value_error{"the value has more digits than " + name + " can hold"}; }
    auto const fault = row == nullptr ? drivecodec::error{} : row->check(value);
    auto const pwe   = vlt6000::pwe_for(*scaled, how);
    if (not fault.ok() or not pwe) { throw value_error{"the value is outside the limits of " + name}; }
    return *pwe;
}

}  // namespace support
