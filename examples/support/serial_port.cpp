// SPDX-License-Identifier: MIT
#include "serial_port.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <string_view>

#include <fcntl.h>
#include <sys/select.h>
#include <termios.h>
#include <unistd.h>

namespace support {

namespace {

struct baud_row {
    std::uint32_t baud;
    speed_t       speed;
};
constexpr baud_row baud_rows[] = {
    {300, B300},     {600, B600},     {1200, B1200},   {2400, B2400},     {4800, B4800},
    {9600, B9600},   {19200, B19200}, {38400, B38400}, {57600, B57600},   {115200, B115200},
    {230400, B230400},
#ifdef B460800
    {460800, B460800},
#endif
#ifdef B921600
    {921600, B921600},
#endif
};

std::optional<speed_t> speed_of(std::uint32_t baud)
{
    for (auto const& row : baud_rows) {
        if (row.baud == baud) { return row.speed; }
    }
    return std::nullopt;
}

/// Every byte passes as it is, at once.
termios raw_settings(character_format format)
{
    using drivecodec::modbus::rtu::parity;
    using drivecodec::modbus::rtu::stop_bits;

    termios settings{};
    settings.c_cflag = CS8 | CREAD | CLOCAL;
    if (format.stop_bits == stop_bits::two) { settings.c_cflag |= CSTOPB; }
    if (format.parity != parity::none) {
        settings.c_iflag |= INPCK;
        settings.c_cflag |= PARENB;
    }
    if (format.parity == parity::odd) { settings.c_cflag |= PARODD; }
    settings.c_cc[VMIN]  = 1;
    settings.c_cc[VTIME] = 0;
    return settings;
}

bool is_pseudo_terminal(int descriptor)
{
    auto const* name = ttyname(descriptor);
    return name != nullptr and std::string_view{name}.starts_with("/dev/pts/");
}

bool configure(int descriptor, speed_t speed, character_format format)
{
    auto settings = raw_settings(format);
    if (cfsetispeed(&settings, speed) != 0 or cfsetospeed(&settings, speed) != 0) { return false; }
    // A pseudo-terminal has no parity bit; a C library that looks whether it was set reports an error.
    if (is_pseudo_terminal(descriptor)) { settings.c_cflag &= ~static_cast<tcflag_t>(PARENB | PARODD); }
    return tcsetattr(descriptor, TCSANOW, &settings) == 0;
}

bool wait_readable(int descriptor, std::optional<std::uint32_t> timeout)
{
    fd_set wanted;
    FD_ZERO(&wanted);
    FD_SET(descriptor, &wanted);
    timespec limit{};
    if (timeout) {
        limit.tv_sec  = static_cast<time_t>(*timeout / 1'000'000);
        limit.tv_nsec = static_cast<long>(*timeout % 1'000'000) * 1000;
    }
    return pselect(descriptor + 1, &wanted, nullptr, nullptr, timeout ? &limit : nullptr, nullptr) > 0;
}

}  // namespace

file_descriptor::~file_descriptor()
{
    if (is_open()) { ::close(number_); }
}

std::optional<serial_port> serial_port::open(std::string const& path, std::uint32_t baud, character_format format)
{
    return open(path, baud, format, O_RDWR);
}

std::optional<serial_port> serial_port::open_to_listen(std::string const& path, std::uint32_t baud,
                                                       character_format format)
{
    return open(path, baud, format, O_RDONLY);
}

std::optional<serial_port> serial_port::open(std::string const& path, std::uint32_t baud, character_format format,
                                             int access)
{
    auto const speed = speed_of(baud);
    if (not speed) {
        errno = EINVAL;
        return std::nullopt;
    }
    // Without O_NONBLOCK, opening a device may wait for a modem's carrier.
    file_descriptor device{::open(path.c_str(), access | O_NOCTTY | O_CLOEXEC | O_NONBLOCK)};
    if (not device.is_open() or not configure(device.number(), *speed, format)) { return std::nullopt; }
    if (fcntl(device.number(), F_SETFL, 0) != 0) { return std::nullopt; }
    return serial_port{std::move(device), file_descriptor{}, path};
}

std::optional<serial_port> serial_port::pseudo_terminal()
{
    file_descriptor ours{posix_openpt(O_RDWR | O_NOCTTY)};
    if (not ours.is_open() or grantpt(ours.number()) != 0 or unlockpt(ours.number()) != 0) { return std::nullopt; }
    auto const* name = ptsname(ours.number());
    if (name == nullptr) { return std::nullopt; }
    std::string     path{name};
    file_descriptor theirs{::open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)};
    if (not theirs.is_open() or not configure(theirs.number(), B115200, {})) { return std::nullopt; }
    return serial_port{std::move(ours), std::move(theirs), std::move(path)};
}

std::optional<std::size_t> serial_port::read(mutable_bytes into, std::optional<std::uint32_t> timeout)
{
    errno = 0;
    if (not wait_readable(descriptor_.number(), timeout)) {
        if (errno == 0 or errno == EINTR) { return 0; }
        return std::nullopt;
    }
    auto const count = ::read(descriptor_.number(), into.data(), into.size());
    if (count > 0) { return static_cast<std::size_t>(count); }
    if (count < 0 and (errno == EINTR or errno == EAGAIN)) { return 0; }
    return std::nullopt;
}

bool serial_port::write_all(bytes from)
{
    while (not from.empty()) {
        auto const count = ::write(descriptor_.number(), from.data(), from.size());
        if (count < 0 and errno == EINTR) { continue; }
        if (count <= 0) { return false; }
        from = from.subspan(static_cast<std::size_t>(count));
    }
    tcdrain(descriptor_.number());
    return true;
}

void serial_port::discard_input()
{
    tcflush(descriptor_.number(), TCIFLUSH);
}

}  // namespace support
