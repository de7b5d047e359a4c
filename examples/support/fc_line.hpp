// SPDX-License-Identifier: MIT
#pragma once

#include "support/arguments.hpp"

#include <drivecodec/fc.hpp>
#include <drivecodec/text/fc.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace support {

namespace fc = drivecodec::fc;

/// The FC protocol, as `line_server` and `line_client` speak it.
struct fc_line {
    using frame   = fc::frame;
    using reader  = fc::reader;
    using address = fc::address;

    static constexpr std::size_t max_size = fc::max_telegram_size;

    std::uint32_t baud = 9600;

    static constexpr auto format        = drivecodec::modbus::rtu::format_8e1;  // always
    static constexpr auto usage         = "  --baud N          (9600)";
    static constexpr auto usual_silence = "3 characters";

    [[nodiscard]] bool take(std::string const& word, arguments& rest)
    {
        if (word != "--baud") { return false; }
        baud = to<std::uint32_t>(rest.next("the value of " + word), 1);
        return true;
    }

    /// What ends a telegram, in microseconds.
    [[nodiscard]] std::uint32_t silence() const { return fc::timing::make(baud)->silence(); }
    [[nodiscard]] std::uint32_t time_of_longest() const { return fc::timing::make(baud)->telegram_limit(max_size); }

    [[nodiscard]] static reader reader_of(address own) { return reader{fc::expecting::either, own}; }
    [[nodiscard]] static reader reader_of_responses() { return reader{fc::expecting::response}; }

    [[nodiscard]] static frame request(drivecodec::bytes raw)
    {
        return {.raw = raw, .direction = fc::direction::request, .aligned = true};
    }
    [[nodiscard]] static frame response(drivecodec::bytes raw)
    {
        return {.raw = raw, .direction = fc::direction::response, .aligned = true};
    }
    [[nodiscard]] static std::string_view describe(frame const& found, std::span<char> out)
    {
        return fc::describe(found, out);
    }
};

/// The words of both programs' command lines that say which slave is meant.
struct fc_address_options {
    fc::address_format format = fc::address_format::short_1_to_31;
    std::uint8_t       number = 1;

    static constexpr auto usage = R"(  --address N       of the drive, 1 to 31, or to 126 in the long format (1)
  --address-format short|long
                    (short, but long for addresses above 31))";

    [[nodiscard]] bool take(std::string const& word, arguments& rest)
    {
        auto const value = [&] { return rest.next("the value of " + word); };
        if (word == "--address") {
            number = to<std::uint8_t>(value(), 1, fc::address::last_long);
        } else if (word == "--address-format") {
            auto const name = value();
            if (name != "short" and name != "long") { throw usage_error{"'" + name + "' is neither short nor long"}; }
            format           = name == "long" ? fc::address_format::long_1_to_126 : fc::address_format::short_1_to_31;
            is_format_given_ = true;
        } else {
            return false;
        }
        return true;
    }

    /// Throws a usage_error for an address that the format does not have.
    [[nodiscard]] fc::address address() const
    {
        auto const is_long = not is_format_given_ and number > fc::address::last_short;
        auto const made    = fc::address::make(is_long ? fc::address_format::long_1_to_126 : format, number);
        if (not made) { throw usage_error{"the short address format ends at 31"}; }
        return *made;
    }

private:
    bool is_format_given_ = false;
};

}  // namespace support
