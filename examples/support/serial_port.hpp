// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/bytes.hpp>
#include <drivecodec/modbus/rtu/timing.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

// POSIX only: a serial device or a pseudo-terminal, bytes as they are. What fails leaves its reason in `errno`.

namespace support {

using drivecodec::bytes;
using drivecodec::mutable_bytes;
using drivecodec::modbus::rtu::character_format;

/// A file descriptor that is closed once.
class file_descriptor {
public:
    file_descriptor() noexcept = default;
    explicit file_descriptor(int number) noexcept : number_{number} {}
    file_descriptor(file_descriptor&& other) noexcept : number_{std::exchange(other.number_, -1)} {}
    file_descriptor& operator=(file_descriptor&& other) noexcept
    {
        std::swap(number_, other.number_);
        return *this;
    }
    file_descriptor(file_descriptor const&)            = delete;
    file_descriptor& operator=(file_descriptor const&) = delete;
    ~file_descriptor();

    [[nodiscard]] int  number() const noexcept { return number_; }
    [[nodiscard]] bool is_open() const noexcept { return number_ >= 0; }

private:
    int number_ = -1;
};

class serial_port {
public:
    /// Opens a serial device, or the named end of a pseudo-terminal. `errno` is EINVAL for an unknown baud rate.
    [[nodiscard]] static std::optional<serial_port> open(std::string const& path, std::uint32_t baud,
                                                         character_format format = {});

    /// The same, of which nothing can be written: for who only listens.
    [[nodiscard]] static std::optional<serial_port> open_to_listen(std::string const& path, std::uint32_t baud,
                                                                   character_format format = {});

    /// Makes a pseudo-terminal, a line without wires: this is one end, and whoever opens `name()` is at the other.
    /// It stays usable when the other end is closed and opened again.
    [[nodiscard]] static std::optional<serial_port> pseudo_terminal();

    /// The path of the device; of a pseudo-terminal, the one that the other program opens.
    [[nodiscard]] std::string const& name() const noexcept { return name_; }

    /// Waits up to `timeout` microseconds, without end if there is none, for bytes; gives how many came.
    ///
    /// 0: none came in time, or a signal arrived, so that a loop can see whether it is to stop. Nothing: the device is
    /// gone or the other end closed.
    [[nodiscard]] std::optional<std::size_t> read(mutable_bytes into, std::optional<std::uint32_t> timeout = {});

    /// Writes all of it and waits until it is on the line. False: the device is gone.
    [[nodiscard]] bool write_all(bytes from);

    /// Forgets what arrived and was not read.
    void discard_input();

private:
    serial_port(file_descriptor descriptor, file_descriptor other_end, std::string name) noexcept
        : descriptor_{std::move(descriptor)}, other_end_{std::move(other_end)}, name_{std::move(name)}
    {}

    [[nodiscard]] static std::optional<serial_port> open(std::string const& path, std::uint32_t baud,
                                                         character_format format, int access);

    file_descriptor descriptor_;
    file_descriptor other_end_;  // held open, else a pseudo-terminal hangs up when its user leaves
    std::string     name_;
};

}  // namespace support
