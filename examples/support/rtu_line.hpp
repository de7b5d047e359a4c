// SPDX-License-Identifier: MIT
#pragma once

#include "support/arguments.hpp"

#include <drivecodec/modbus.hpp>
#include <drivecodec/text/modbus.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace support {

namespace modbus = drivecodec::modbus;
namespace rtu    = modbus::rtu;

/// Modbus RTU, as `line_server` and `line_client` speak it.
struct rtu_line {
    using frame   = rtu::frame;
    using reader  = rtu::reader;
    using address = rtu::server_address;

    static constexpr std::size_t max_size = rtu::max_adu_size;

    std::uint32_t         baud   = 19200;
    rtu::character_format format = rtu::format_8e1;

    static constexpr auto usage         = R"(  --baud N          (19200)
  --format 8E1      data bits, parity, stop bits (8E1))";
    static constexpr auto usual_silence = "3.5 characters";

    [[nodiscard]] bool take(std::string const& word, arguments& rest)
    {
        auto const value = [&] { return rest.next("the value of " + word); };
        if (word == "--baud") {
            baud = to<std::uint32_t>(value(), 1);
        } else if (word == "--format") {
            format = to_format(value());
        } else {
            return false;
        }
        return true;
    }

    /// What ends a frame, in microseconds.
    [[nodiscard]] std::uint32_t silence() const { return timing().inter_frame(); }
    [[nodiscard]] std::uint32_t time_of_longest() const { return timing().frame_time(max_size); }

    [[nodiscard]] static reader reader_of(address own) { return reader{rtu::expecting::either, own}; }
    [[nodiscard]] static reader reader_of_responses() { return reader{rtu::expecting::response}; }

    [[nodiscard]] static frame request(drivecodec::bytes raw)
    {
        return {.raw = raw, .direction = modbus::direction::request, .aligned = true};
    }
    [[nodiscard]] static frame response(drivecodec::bytes raw)
    {
        return {.raw = raw, .direction = modbus::direction::response, .aligned = true};
    }
    [[nodiscard]] static std::string_view describe(frame const& found, std::span<char> out)
    {
        return rtu::describe(found, out);
    }

private:
    [[nodiscard]] rtu::timing timing() const { return *rtu::timing::make(baud, format); }
};

}  // namespace support
