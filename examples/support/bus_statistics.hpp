// SPDX-License-Identifier: MIT
#pragma once

#include "arrival_times.hpp"
#include "traffic_item.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>

// Who said what how often on a line, and how long it took.

namespace support {

/// In microseconds.
class response_times {
public:
    void add(std::uint64_t time)
    {
        least_ = count_ == 0 ? time : std::min(least_, time);
        most_  = std::max(most_, time);
        total_ += time;
        ++count_;
    }

    void add(response_times const& others)
    {
        if (others.count_ == 0) { return; }
        least_ = count_ == 0 ? others.least_ : std::min(least_, others.least_);
        most_  = std::max(most_, others.most_);
        total_ += others.total_;
        count_ += others.count_;
    }

    [[nodiscard]] bool          empty() const { return count_ == 0; }
    [[nodiscard]] std::uint64_t least() const { return least_; }
    [[nodiscard]] std::uint64_t most() const { return most_; }

    /// Precondition: not empty.
    [[nodiscard]] std::uint64_t mean() const { return total_ / count_; }

private:
    std::uint64_t count_ = 0, least_ = 0, most_ = 0, total_ = 0;
};

struct bus_counters {
    std::uint64_t  requests      = 0;
    std::uint64_t  replies       = 0;
    std::uint64_t  refusals      = 0;
    std::uint64_t  silences      = 0;  ///< Requests without either.
    std::uint64_t  unclear       = 0;  ///< Frames of which nothing tells whether they are requests.
    std::uint64_t  bad_checks    = 0;
    std::uint64_t  dropped_bytes = 0;
    response_times times;

    void add(bus_counters const& others)
    {
        requests += others.requests;
        replies += others.replies;
        refusals += others.refusals;
        silences += others.silences;
        unclear += others.unclear;
        bad_checks += others.bad_checks;
        dropped_bytes += others.dropped_bytes;
        times.add(others.times);
    }
};

/// What an item is to the line, beside itself.
struct bus_event {
    std::optional<std::uint8_t>  address{};           ///< Whose row it counts for; nothing: the line's.
    std::optional<std::uint64_t> response_time{};     ///< Of a reply, in microseconds, where it is known.
    std::optional<timestamp>     asked{};             ///< When the last request ended.
    bool                         is_damaged = false;  ///< Of what was not answered: bytes were dropped meanwhile.
};

/// Counts items, which come in order, for the addresses to or from which they are.
///
/// Dropped bytes are those of the slave that is to reply; else of the one to or from which a damaged frame seems to be,
/// if that was heard or expected; else they are the line's.
class bus_statistics {
public:
    /// Gives it a row before it is heard.
    void expect(std::uint8_t address) { rows_[address]; }

    bus_event add(traffic_item const& item, arrival_times::span when)
    {
        bus_event event{.address = item.address, .asked = asked_};
        if (not item.protocol.empty()) { protocol_ = item.protocol; }
        switch (item.kind) {
        case traffic::request:
            ++row(item).requests;
            asked_      = when.end;
            is_damaged_ = false;
            break;
        case traffic::reply: ++row(item).replies; break;
        case traffic::refusal: ++row(item).refusals; break;
        case traffic::unclear: ++row(item).unclear; break;
        case traffic::unanswered:
            ++row(item).silences;
            event.is_damaged = is_damaged_;
            break;
        case traffic::dropped: event.address = add_dropped(item); break;
        }
        // Bytes that were read at once are of one time, which tells nothing.
        if (item.is_answer and asked_ and when.begin and *when.begin > *asked_) {
            event.response_time = *when.begin - *asked_;
            row(item).times.add(*event.response_time);
        }
        return event;
    }

    [[nodiscard]] std::map<std::uint8_t, bus_counters> const& rows() const { return rows_; }

    /// Bytes that are nobody's.
    [[nodiscard]] bus_counters const& line() const { return line_; }

    /// Of the last frame; empty if there was none.
    [[nodiscard]] std::string_view protocol() const { return protocol_; }

    [[nodiscard]] bus_counters total() const
    {
        auto sum = line_;
        for (auto const& [address, counters] : rows_) { sum.add(counters); }
        return sum;
    }

private:
    [[nodiscard]] bus_counters& row(traffic_item const& item) { return rows_[item.address.value_or(0)]; }

    std::optional<std::uint8_t> add_dropped(traffic_item const& item)
    {
        auto const is_known = item.seems_from and rows_.contains(*item.seems_from);
        auto const whose    = item.address ? item.address : is_known ? item.seems_from : std::nullopt;
        auto&      counters = whose ? rows_[*whose] : line_;
        counters.dropped_bytes += item.size;
        counters.bad_checks += item.is_bad_check ? 1 : 0;
        is_damaged_ = true;
        return whose;
    }

    std::map<std::uint8_t, bus_counters> rows_;
    bus_counters                         line_;
    std::string_view                     protocol_;
    std::optional<timestamp>             asked_;
    bool                                 is_damaged_ = false;  // since the last request
};

}  // namespace support
