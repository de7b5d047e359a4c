// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/fc.hpp>
#include <drivecodec/vlt6000.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>
#include <system_error>

// The parameters of a simulated VLT 6000 that can be set: in RAM, in EEPROM, and in four setups.

namespace support {

namespace fc      = drivecodec::fc;
namespace vlt6000 = drivecodec::vlt6000;

/// One of them, in the numbers that are transferred.
struct vlt6000_setting {
    std::uint16_t number;
    fc::data_type type;
    std::int32_t  min;
    std::int32_t  max;
    std::int32_t  factory;
    bool          only_at_standstill = false;
};

namespace detail {

using enum fc::data_type;

inline constexpr auto any_double_word = std::numeric_limits<std::int32_t>::max();

/// Where the manual states data type, conversion index, limits or factory setting, they are the manual's. All others
/// are this simulator's choice, of which a real drive need not have a single one: its own guide tells.
inline constexpr std::array vlt6000_settings{
    vlt6000_setting{1, unsigned_8, 0, 1, 0},
    vlt6000_setting{2, unsigned_8, 0, 4, 1},                // 0 is the factory setup
    vlt6000_setting{4, unsigned_8, 0, 1, 0},                // 1 is multi-setup
    vlt6000_setting{5, integer_32, 0, 99'999'900, 10'000},  // index -2
    vlt6000_setting{6, unsigned_8, 0, 40, 1},
    vlt6000_setting{7, unsigned_8, 1, 27, 1},
    vlt6000_setting{8, unsigned_8, 1, 27, 2},
    vlt6000_setting{9, unsigned_8, 1, 27, 3},
    vlt6000_setting{10, unsigned_8, 1, 27, 4},
    vlt6000_setting{100, unsigned_8, 0, 1, 0, true},
    vlt6000_setting{102, unsigned_32, 0, 500'000, 4'000, true},  // W
    vlt6000_setting{103, unsigned_16, 200, 500, 400, true},      // V
    vlt6000_setting{104, unsigned_16, 24, 1'000, 50, true},      // Hz
    vlt6000_setting{105, unsigned_32, 1, 100'000, 850, true},    // A, index -2
    vlt6000_setting{106, unsigned_16, 100, 60'000, 1'440, true},
    vlt6000_setting{114, unsigned_16, 0, 100, 50},   // %
    vlt6000_setting{115, unsigned_16, 0, 600, 100},  // s, index -1
    vlt6000_setting{117, unsigned_8, 0, 8, 4},
    vlt6000_setting{201, unsigned_16, 0, 1'200, 0},          // Hz, index -1
    vlt6000_setting{202, unsigned_16, 0, 1'200, 500},        // Hz, index -1
    vlt6000_setting{204, integer_32, 0, 1'000'000, 0},       // Hz, index -3
    vlt6000_setting{205, integer_32, 0, 1'000'000, 50'000},  // Hz, index -3
    vlt6000_setting{206, unsigned_16, 1, 3'600, 10},         // s
    vlt6000_setting{207, unsigned_16, 1, 3'600, 10},         // s
    vlt6000_setting{209, unsigned_16, 0, 1'200, 100},        // Hz, index -1
    vlt6000_setting{211, integer_16, -10'000, 10'000, 0},    // %, index -2; as 212 to 214
    vlt6000_setting{212, integer_16, -10'000, 10'000, 0},
    vlt6000_setting{213, integer_16, -10'000, 10'000, 0},
    vlt6000_setting{214, integer_16, -10'000, 10'000, 0},
    vlt6000_setting{215, unsigned_16, 1, 1'000, 110},  // A, index -1
    vlt6000_setting{323, unsigned_8, 0, 26, 0},        // 26 is control word bits 11/12
    vlt6000_setting{326, unsigned_8, 0, 26, 0},
    vlt6000_setting{412, unsigned_8, 0, 60, 60},                             // s
    vlt6000_setting{413, integer_32, -any_double_word, any_double_word, 0},  // index -3
    vlt6000_setting{414, integer_32, -any_double_word, any_double_word, 100'000},
    vlt6000_setting{415, unsigned_8, 0, 40, 0},
    vlt6000_setting{500, unsigned_8, 0, 2, 0, true},
    vlt6000_setting{501, unsigned_8, 0, 126, 1},
    vlt6000_setting{502, unsigned_8, 0, 5, 5},
    vlt6000_setting{503, unsigned_8, 0, 3, 3},
    vlt6000_setting{504, unsigned_8, 0, 3, 3},
    vlt6000_setting{505, unsigned_8, 0, 3, 3},
    vlt6000_setting{506, unsigned_8, 0, 3, 0},
    vlt6000_setting{507, unsigned_8, 0, 3, 3},
    vlt6000_setting{508, unsigned_8, 0, 3, 3},
    vlt6000_setting{535, unsigned_16, 0, 0x4000, 0},
    vlt6000_setting{536, unsigned_16, 0, 0x4000, 0},
    vlt6000_setting{555, unsigned_16, 1, 65'534, 1},  // s
    vlt6000_setting{556, unsigned_8, 0, 5, 0},
};
static_assert(drivecodec::strictly_ascending(vlt6000_settings, &vlt6000_setting::number));

}  // namespace detail

/// What the drive remembers. Parameters 100 to 499 are there four times, once per setup; reads and writes are of the
/// active one. The factory setup cannot be written.
class vlt6000_settings {
public:
    static constexpr auto const& table = detail::vlt6000_settings;

    /// With a file, EEPROM outlives the program. Throws std::system_error for one that is not its own.
    explicit vlt6000_settings(std::string file) : file_{std::move(file)}
    {
        for (auto& setup : eeprom_) {
            for (std::size_t i = 0; i < table.size(); ++i) { setup[i] = table[i].factory; }
        }
        load();
        power_on();
    }

    /// What was only in RAM is lost.
    void power_on() { ram_ = eeprom_; }

    void select(vlt6000::setup wanted) { setup_ = static_cast<std::size_t>(wanted); }

    [[nodiscard]] bool is_factory_setup() const { return ram_[0][index_of(2)] == 0; }

    /// The number that is transferred. Precondition: the parameter is in the table.
    [[nodiscard]] std::int32_t get(std::uint16_t number) const
    {
        auto const i = index_of(number);
        return is_per_setup(number) and is_factory_setup() ? table[i].factory : ram_[setup_of(number)][i];
    }

    /// At the panel: what is set here does not ask for access.
    void set(std::uint16_t number, std::int32_t value)
    {
        ram_[setup_of(number)][index_of(number)] = eeprom_[setup_of(number)][index_of(number)] = value;
    }

    [[nodiscard]] fc::parameter_answer read(std::uint16_t number) const
    {
        auto const is_word = fc::width_of(find(number)->type) == fc::width::word;
        auto const bits    = static_cast<std::uint32_t>(get(number));
        return {is_word ? fc::ak_reply::word : fc::ak_reply::double_word, is_word ? bits & 0xFFFFU : bits};
    }

    /// The value as it then is, or why not: no bus access, another width than the parameter's, the factory setup, a
    /// motor that runs, limits, in this order. Precondition: the parameter is in the table.
    [[nodiscard]] fc::parameter_answer write(fc::parameter_request const& asked, bool is_running)
    {
        using enum fc::parameter_error;
        auto const  number = asked.number();
        auto const& row    = *find(number);
        if (vlt6000::find(number)->access == vlt6000::access::panel_only) { return no_bus_access; }
        auto const value = asked.value(row.type);
        if (not value and value.error().code() == drivecodec::errc::bad_value) { return data_type_does_not_match; }
        if (is_factory_setup() and is_per_setup(number)) { return factory_setup_selected; }
        if (row.only_at_standstill and is_running) { return not_possible_in_present_mode; }
        if (not value or *value < row.min or *value > row.max) { return value_exceeds_limits; }
        auto const wanted = static_cast<std::int32_t>(*value);
        if (not are_ascending(number, wanted)) { return value_exceeds_limits; }

        ram_[setup_of(number)][index_of(number)] = wanted;
        using enum fc::ak_command;
        if (asked.command() == write_word_to_eeprom or asked.command() == write_double_word_to_eeprom) {
            eeprom_[setup_of(number)][index_of(number)] = wanted;
            save();
        }
        return read(number);
    }

    [[nodiscard]] static vlt6000_setting const* find(std::uint16_t number)
    {
        return drivecodec::find_row(table, &vlt6000_setting::number, number);
    }

private:
    using memory = std::array<std::array<std::int32_t, table.size()>, 4>;

    [[nodiscard]] static std::size_t index_of(std::uint16_t number)
    {
        return static_cast<std::size_t>(find(number) - table.data());
    }
    [[nodiscard]] static bool is_per_setup(std::uint16_t number) { return number >= 100 and number < 500; }
    [[nodiscard]] std::size_t setup_of(std::uint16_t number) const { return is_per_setup(number) ? setup_ : 0; }

    /// A lower limit stays below its upper one.
    [[nodiscard]] bool are_ascending(std::uint16_t number, std::int32_t value) const
    {
        for (auto const lower : std::array<std::uint16_t, 3>{201, 204, 413}) {
            auto const upper = static_cast<std::uint16_t>(lower + 1);
            if (number == lower and value >= get(upper)) { return false; }
            if (number == upper and value <= get(lower)) { return false; }
        }
        return true;
    }

    /// Lines of setup, number and value.
    void load()
    {
        std::ifstream file{file_};
        unsigned      setup  = 0;
        std::uint16_t number = 0;
        std::int32_t  value  = 0;
        while (file >> setup >> number >> value) {
            auto const* row = find(number);
            if (setup >= eeprom_.size() or row == nullptr or value < row->min or value > row->max) { break; }
            eeprom_[setup][index_of(number)] = value;
        }
        if (file.is_open() and not file.eof()) { throw_error(EINVAL); }
    }

    void save() const
    {
        if (file_.empty()) { return; }
        std::ofstream file{file_};
        for (std::size_t setup = 0; setup < eeprom_.size(); ++setup) {
            for (std::size_t i = 0; i < table.size(); ++i) {
                if (eeprom_[setup][i] == table[i].factory) { continue; }
                file << setup << ' ' << table[i].number << ' ' << eeprom_[setup][i] << '\n';
            }
        }
        if (not file.flush()) { throw_error(EIO); }
    }

    [[noreturn]] void throw_error(int code) const { throw std::system_error{code, std::generic_category(), file_}; }

    std::string file_;  // empty: none
    memory      eeprom_{};
    memory      ram_{};
    std::size_t setup_ = 0;
};

}  // namespace support
