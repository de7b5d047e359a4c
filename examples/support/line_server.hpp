// SPDX-License-Identifier: MIT
#pragma once

#include "support/arguments.hpp"
#include "support/serial_port.hpp"

#include <drivecodec/text/core.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

// The server's side of a line: frames in, replies out, until a signal says stop.

namespace support {

/// Ctrl-C and `kill` end `line_server::run`.
class stop_signal {
public:
    static void listen()
    {
        struct sigaction action{};
        action.sa_handler = [](int) { arrived = 1; };  // without SA_RESTART: a signal ends the wait for bytes
        sigaction(SIGINT, &action, nullptr);
        sigaction(SIGTERM, &action, nullptr);
    }
    [[nodiscard]] static bool has_arrived() { return arrived != 0; }

private:
    static inline std::sig_atomic_t volatile arrived = 0;
};

/// What the command lines of all servers have in common. `Line` is what is spoken, as rtu_line or fc_line.
template <typename Line>
struct line_options {
    std::string                  device;  // empty: a pseudo-terminal
    std::string                  link;
    std::string                  log;
    Line                         line;
    std::optional<std::uint32_t> silence;  // microseconds
    bool                         verbose = false;

    [[nodiscard]] static std::string usage()
    {
        return std::string{R"(
  --device PATH     a serial device; without it, a pseudo-terminal is opened and its path printed
  --link PATH       a symbolic link to the device
)"} + Line::usage
               + R"(
  --silence N       microseconds that end a frame ()"
               + Line::usual_silence + R"(); more for adapters that deliver bytes in lumps
  --log FILE        writes every frame as a line of hex digits
  --verbose         prints every frame in words)";
    }

    /// Takes the option `word` if it is one of these.
    [[nodiscard]] bool take(std::string const& word, arguments& rest)
    {
        auto const value = [&] { return rest.next("the value of " + word); };
        if (line.take(word, rest)) { return true; }
        if (word == "--device") {
            device = value();
        } else if (word == "--link") {
            link = value();
        } else if (word == "--log") {
            log = value();
        } else if (word == "--silence") {
            silence = to<std::uint32_t>(value(), 1);
        } else if (word == "--verbose") {
            verbose = true;
        } else {
            return false;
        }
        return true;
    }
};

/// A symbolic link that is gone when the program is.
class symbolic_link {
public:
    symbolic_link(std::filesystem::path from, std::filesystem::path const& to) : from_{std::move(from)}
    {
        if (from_.empty()) { return; }
        if (std::filesystem::is_symlink(from_)) { std::filesystem::remove(from_); }
        std::filesystem::create_symlink(to, from_);
    }
    symbolic_link(symbolic_link const&)            = delete;
    symbolic_link(symbolic_link&&)                 = delete;
    symbolic_link& operator=(symbolic_link const&) = delete;
    symbolic_link& operator=(symbolic_link&&)      = delete;
    ~symbolic_link()
    {
        std::error_code ignored;
        if (not from_.empty()) { std::filesystem::remove(from_, ignored); }
    }

private:
    std::filesystem::path from_;
};

/// Carries frames between a line and a device, which has
///
///   bytes answer(Line::frame const&, mutable_bytes room)  the reply to a frame on the line, or nothing
///   void  hear(drivecodec::dropped_bytes const&)          noise
///   void  go_on()                                         called again and again, at least every `idle` microseconds
template <typename Line>
class line_server {
public:
    using frame = typename Line::frame;

    /// Opens the line, links to it and prints its path. Throws std::system_error if it cannot.
    line_server(line_options<Line> const& given, typename Line::address own)
        : port_{open(given)}, link_{given.link, port_.name()}, silence_{given.silence.value_or(given.line.silence())},
          verbose_{given.verbose}, reader_{Line::reader_of(own)}
    {
        if (not given.log.empty()) { log_.open(given.log); }
        std::cout << port_.name() << std::endl;
    }

    /// Until a signal stops it. Throws std::system_error if the device is gone.
    template <typename Device>
    void run(Device& device, std::uint32_t idle = 100'000)
    {
        while (not stop_signal::has_arrived()) {
            auto const count = port_.read(reader_.prepare(), is_silent_ ? idle : silence_);
            if (not count) { fail(port_.name()); }
            if (*count > 0) {
                is_silent_ = false;
                reader_.commit(*count);
            } else if (not is_silent_) {
                is_silent_ = true;
                reader_.silence();
            }
            device.go_on();
            while (auto const item = reader_.next()) {
                if (auto const* found = item.frame()) {
                    show("<- ", *found);
                    reply_ = device.answer(*found, room_);
                }
                if (auto const* noise = item.dropped()) {
                    show(*noise);
                    device.hear(*noise);
                }
            }
            // A reply waits for the silence that ends the request. Whoever sends meanwhile does not wait for it.
            if (is_silent_ and not reply_.empty()) { send(); }
        }
    }

    [[nodiscard]] auto const& counters() const noexcept { return reader_.counters(); }

private:
    [[nodiscard]] static serial_port open(line_options<Line> const& given)
    {
        auto port = given.device.empty() ? serial_port::pseudo_terminal()
                                         : serial_port::open(given.device, given.line.baud, given.line.format);
        if (not port) { fail(given.device); }
        return std::move(*port);
    }

    [[noreturn]] static void fail(std::string const& path)
    {
        throw std::system_error{errno, std::generic_category(), path};
    }

    void send()
    {
        show("-> ", Line::response(reply_));
        if (not port_.write_all(std::exchange(reply_, {}))) { fail(port_.name()); }
    }

    void show(char const* way, frame const& found)
    {
        write_log(found.raw);
        if (not verbose_) { return; }
        std::array<char, 1200> text{};
        std::cout << way << Line::describe(found, text) << std::endl;
    }

    void show(drivecodec::dropped_bytes const& noise)
    {
        write_log(noise.raw);
        if (not verbose_) { return; }
        std::cout << "   " << noise.raw.size() << " bytes dropped: " << to_string(noise.reason) << std::endl;
    }

    void write_log(drivecodec::bytes raw)
    {
        if (not log_.is_open()) { return; }
        std::array<char, 3 * Line::max_size> digits{};
        log_ << drivecodec::text_writer{digits}.hex(raw).view() << std::endl;
    }

    serial_port                              port_;
    symbolic_link                            link_;
    std::uint32_t                            silence_;
    bool                                     verbose_;
    bool                                     is_silent_ = true;
    std::ofstream                            log_;
    typename Line::reader                    reader_;
    std::array<std::uint8_t, Line::max_size> room_{};
    drivecodec::bytes                        reply_{};  // waits to be sent
};

}  // namespace support
