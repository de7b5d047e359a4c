// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/decimal.hpp>
#include <drivecodec/modbus/rtu/timing.hpp>

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

// The words of a command line.

namespace support {

/// The user wrote something that the program does not understand; `what()` tells them.
struct usage_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The command line was understood, but this value cannot be sent or shown so; `what()` tells the user why.
struct value_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The user wrote --help: wants the usage, and nothing to be done.
struct help_wanted {};

/// A whole number, decimal or 0x..., between `lowest` and `highest`.
[[nodiscard]] inline long long to_number(std::string const& word, long long lowest, long long highest)
{
    std::size_t used   = 0;
    long long   number = 0;
    try {
        auto const is_hex = word.find("0x") != std::string::npos or word.find("0X") != std::string::npos;
        number            = std::stoll(word, &used, is_hex ? 16 : 10);
    } catch (std::logic_error const&) {
        used = 0;
    }
    if (used == 0 or used != word.size() or number < lowest or number > highest) {
        throw usage_error{"'" + word + "' is not a number from " + std::to_string(lowest) + " to "
                          + std::to_string(highest)};
    }
    return number;
}

template <typename Number>
[[nodiscard]] Number to(std::string const& word, long long lowest = std::numeric_limits<Number>::min(),
                        long long highest = std::numeric_limits<Number>::max())
{
    return static_cast<Number>(to_number(word, lowest, highest));
}

[[nodiscard]] inline drivecodec::decimal to_decimal(std::string_view word)
{
    auto const value = drivecodec::parse_decimal(word);
    if (not value) { throw value_error{"'" + std::string{word} + "' is not a number such as 41.2"}; }
    return *value;
}

/// A register's value: 0 to 65535, or as a signed number -32768 to 32767.
[[nodiscard]] inline std::uint16_t to_register(std::string const& word)
{
    return static_cast<std::uint16_t>(to_number(word, -32768, 65535));
}

/// As one writes it on a drive's display: 8E1, 8O1, 8N1, 8N2.
[[nodiscard]] inline drivecodec::modbus::rtu::character_format to_format(std::string_view word)
{
    using namespace drivecodec::modbus::rtu;
    static constexpr struct {
        std::string_view name;
        character_format format;
    } rows[] = {{"8E1", format_8e1}, {"8O1", format_8o1}, {"8N1", format_8n1}, {"8N2", format_8n2}};
    for (auto const& row : rows) {
        if (word == row.name) { return row.format; }
    }
    throw usage_error{"'" + std::string{word} + "' is not a character format such as 8E1"};
}

/// The words, taken one by one from the front.
class arguments {
public:
    /// Throws `help_wanted` if one of them is --help.
    arguments(int count, char const* const* words) : words_(words + (count > 0 ? 1 : 0), words + count)
    {
        for (auto const& word : words_) {
            if (word == "--help") { throw help_wanted{}; }
        }
    }

    [[nodiscard]] bool empty() const noexcept { return at_ == words_.size(); }

    /// The next word; `what` tells the user what is missing if there is none.
    std::string next(std::string_view what)
    {
        if (empty()) { throw usage_error{std::string{what} + " is missing"}; }
        return words_[at_++];
    }

    /// Takes the next word if it is an option.
    [[nodiscard]] bool is_option() const { return not empty() and words_[at_].starts_with("--"); }

private:
    std::vector<std::string> words_;
    std::size_t              at_ = 0;
};

/// An option that is written `--name value` or `--name=value`.
class option {
public:
    explicit option(arguments& words) : words_{words}, word_{words.next("")}, equals_{word_.find('=')} {}

    [[nodiscard]] std::string name() const { return word_.substr(0, equals_); }

    /// Takes it.
    [[nodiscard]] std::string value()
    {
        return equals_ == std::string::npos ? words_.next("the value of " + name()) : word_.substr(equals_ + 1);
    }

    /// Throws if there is a value.
    void has_no_value() const
    {
        if (equals_ != std::string::npos) { refuse(); }
    }

    [[noreturn]] void refuse() const { throw usage_error{"there is no option " + word_}; }

private:
    arguments&  words_;
    std::string word_;
    std::size_t equals_;
};

}  // namespace support
