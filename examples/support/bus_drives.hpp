// SPDX-License-Identifier: MIT
#pragma once

#include "known_drives.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace support {

/// Which drive has which address, and what it is called.
class bus_drives {
public:
    /// `5=smd`, or with a name of one's own `5=smd:pump 3`. Throws a usage_error for anything else.
    void add(std::string const& word)
    {
        auto const equals = word.find('=');
        if (equals == std::string::npos) { throw usage_error{"'" + word + "' is no drive such as 5=smd"}; }
        auto const  address = to<std::uint8_t>(word.substr(0, equals), 1, 247);
        auto const  drive   = word.substr(equals + 1);
        auto const  colon   = std::min(drive.find(':'), drive.size());
        auto const& known   = to_drive(drive.substr(0, colon));
        auto        name    = colon + 1 < drive.size() ? drive.substr(colon + 1) : std::string{known.name};
        std::ranges::replace_if(
            name, [](char c) { return c < ' ' or c > '~'; }, '?');
        drives_[address] = {std::move(name), known.make_explainer()};
    }

    /// Empty if it has none.
    [[nodiscard]] std::string_view name_of(std::uint8_t address) const
    {
        auto const found = drives_.find(address);
        return found != drives_.end() ? std::string_view{found->second.name} : std::string_view{};
    }

    [[nodiscard]] std::size_t longest_name() const
    {
        std::size_t longest = 0;
        for (auto const& [address, drive] : drives_) { longest = std::max(longest, drive.name.size()); }
        return longest;
    }

    void for_each_address(auto act) const
    {
        for (auto const& [address, drive] : drives_) { act(address); }
    }

    /// What a frame means to the drive that it is to or from.
    [[nodiscard]] std::string explain(drivecodec::modbus::rtu::frame const& heard, drivecodec::bytes asked) const
    {
        auto const found = drives_.find(heard.address());
        return found != drives_.end() and found->second.explainer.modbus ? found->second.explainer.modbus(heard, asked)
                                                                         : std::string{};
    }
    [[nodiscard]] std::string explain(drivecodec::fc::frame const& heard) const
    {
        auto const to    = heard.address();
        auto const found = to.is_broadcast() ? drives_.end() : drives_.find(to.number());
        return found != drives_.end() and found->second.explainer.fc ? found->second.explainer.fc(heard)
                                                                     : std::string{};
    }

private:
    struct named_drive {
        std::string     name;
        drive_explainer explainer;
    };

    std::map<std::uint8_t, named_drive> drives_;
};

}  // namespace support
