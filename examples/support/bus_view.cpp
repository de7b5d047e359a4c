// SPDX-License-Identifier: MIT
#include "bus_view.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>

namespace support {

namespace {

namespace colour {
constexpr std::string_view none;
constexpr std::string_view bold    = "\033[1m";
constexpr std::string_view dim     = "\033[2m";
constexpr std::string_view red     = "\033[1;31m";
constexpr std::string_view green   = "\033[32m";
constexpr std::string_view yellow  = "\033[1;33m";
constexpr std::string_view magenta = "\033[35m";
constexpr std::string_view cyan    = "\033[36m";
constexpr std::string_view off     = "\033[0m";
}  // namespace colour

std::string right(std::string_view text, std::size_t width)
{
    return std::string(width - std::min(width, text.size()), ' ').append(text);
}

std::string left(std::string_view text, std::size_t width)
{
    return std::string{text}.append(width - std::min(width, text.size()), ' ');
}

/// `12.3` of 12345 with one digit behind the point: rounded.
std::string decimal(std::uint64_t thousandths, unsigned digits)
{
    std::array<char, 40> room{};
    auto const           drop   = digits == 1 ? 100U : 1U;
    auto const           scaled = thousandths / drop + (thousandths % drop * 2 >= drop and drop > 1 ? 1 : 0);
    auto const           unit   = 1000 / drop;
    static_cast<void>(std::snprintf(room.data(), room.size(), "%llu.%0*llu",
                                    static_cast<unsigned long long>(scaled / unit), static_cast<int>(digits),
                                    static_cast<unsigned long long>(scaled % unit)));
    return room.data();
}

struct look_of_kind {
    std::string_view mark;
    std::string_view colour;
};

look_of_kind look_of(traffic kind)
{
    switch (kind) {
    case traffic::request: return {"->", colour::cyan};
    case traffic::reply: return {"<-", colour::green};
    case traffic::refusal: return {"<!", colour::yellow};
    case traffic::unclear: return {"<>", colour::none};
    case traffic::unanswered: return {"--", colour::red};
    case traffic::dropped: return {"xx", colour::magenta};
    }
    return {};
}

std::string text_of(traffic_item const& item, bus_event const& event)
{
    if (item.is_reply() and not item.is_answer) { return item.text + "  (no request heard)"; }
    if (item.kind != traffic::unanswered) { return item.text; }
    auto text = std::string{event.is_damaged ? "no whole reply" : "no reply"};
    switch (item.until) {
    case silence_until::next_frame: break;
    case silence_until::time_out: text += " in time"; break;
    case silence_until::end: text += " before the end"; break;
    }
    return text;
}

constexpr std::size_t time_width     = 12;
constexpr std::size_t address_width  = 3;
constexpr std::size_t response_width = 10;
constexpr std::size_t least_content  = 40;  // a line is longer than wished before its last column is narrower

}  // namespace

std::vector<std::string> wrap(std::string_view text, std::size_t width)
{
    std::vector<std::string> lines;
    while (text.size() > width) {
        auto const blank = text.substr(0, width + 1).find_last_of(' ');
        auto const cut   = blank == std::string_view::npos or blank == 0 ? width : blank;
        auto       part  = text.substr(0, cut);
        part             = part.substr(0, part.find_last_not_of(' ') + 1);
        if (not part.empty()) { lines.emplace_back(part); }
        auto const next = text.find_first_not_of(' ', cut);
        if (next == std::string_view::npos) { return lines; }
        text.remove_prefix(next);
    }
    lines.emplace_back(text);
    return lines;
}

std::string time_text(timestamp since_begin, timestamp absolute, bool is_absolute)
{
    constexpr timestamp first_time_of_day = 1'000'000'000;  // seconds
    constexpr timestamp last_time_of_day  = 100'000'000'000;
    auto const          time              = is_absolute ? absolute : since_begin;
    auto const          seconds           = time / 1'000'000;
    if (not is_absolute or seconds < first_time_of_day or seconds > last_time_of_day) {
        return decimal(time / 1000, 3);
    }
    auto const           now = static_cast<std::time_t>(seconds);
    std::tm              parts{};
    std::array<char, 40> room{};
    if (localtime_r(&now, &parts) == nullptr) { return {}; }
    auto const size = std::strftime(room.data(), room.size(), "%H:%M:%S", &parts);
    return std::string{room.data(), size} + decimal(time / 1000 % 1000, 3).substr(1);
}

std::string response_text(std::uint64_t microseconds)
{
    constexpr std::uint64_t in_seconds = 10'000'000;
    if (microseconds >= in_seconds) { return '+' + decimal(microseconds / 1000, 1) + " s"; }
    return '+' + decimal(microseconds, 1) + " ms";
}

std::string bus_view::painted(std::string_view text, std::string_view colour) const
{
    if (not look_.has_colours or colour.empty() or text.empty()) { return std::string{text}; }
    return std::string{colour}.append(text).append(colour::off);
}

void bus_view::pass(std::optional<timestamp> now)
{
    if (not now) { return; }
    if (not begin_) { begin_ = now; }
    last_ = std::max(last_, *now);
}

std::string bus_view::line(traffic_item const& item, bus_event const& event, std::optional<timestamp> when) const
{
    auto const look  = look_of(item.kind);
    auto const names = drives_.longest_name();

    std::string out;
    std::size_t used = 0;
    auto const  put  = [&](std::string const& column, std::string_view colour, std::size_t gap) {
        auto const begin = std::min(column.find_first_not_of(' '), column.size());
        auto const end   = column.find_last_not_of(' ') + 1;
        out.append(column, 0, begin);
        if (begin < end) {
            out.append(painted(std::string_view{column}.substr(begin, end - begin), colour)).append(column, end);
        }
        out.append(gap, ' ');
        used += column.size() + gap;
    };
    if (begin_) {
        auto const since = when and *when > *begin_ ? *when - *begin_ : 0;
        put(right(when ? time_text(since, *when, look_.is_absolute) : "", time_width), colour::dim, 2);
    }
    auto const is_to_all = event.address == 0;
    put(right(not event.address ? "-"
              : is_to_all       ? "all"
                                : std::to_string(*event.address),
              address_width),
        colour::bold, names == 0 ? 2 : 1);
    if (names != 0) { put(left(event.address ? drives_.name_of(*event.address) : "", names), colour::bold, 2); }
    put(std::string{look.mark}, look.colour, 2);
    if (begin_) {
        put(right(event.response_time ? response_text(*event.response_time) : "", response_width), look.colour, 2);
    }

    auto const room  = std::max(look_.width, used + least_content) - used;
    auto const write = [&](std::string_view text, std::string_view colour) {
        for (auto const& part : wrap(text, room)) { out += painted(part, colour) + '\n' + std::string(used, ' '); }
    };
    auto const is_usual = item.kind == traffic::request or (item.kind == traffic::reply and item.is_answer);
    write(text_of(item, event), is_usual ? colour::none : look.colour);
    if (not item.meaning.empty()) { write(item.meaning, colour::dim); }
    out.resize(out.size() - used);
    return out;
}

std::string bus_view::headline(drivecodec::stream_counters const& counted, std::string_view protocol) const
{
    auto const counted_as = [](std::uint32_t number, std::string_view what) {
        return std::to_string(number).append(" ").append(what).append(number == 1 ? "" : "s");
    };
    auto text = counted_as(counted.frames, "frame");
    if (not protocol.empty()) { text.append(" of ").append(protocol); }
    if (begin_ and last_ > *begin_) { text += " in " + decimal((last_ - *begin_) / 1000, 1) + " s"; }
    if (counted.dropped_bytes != 0) { text += ", " + counted_as(counted.dropped_bytes, "dropped byte"); }
    return painted(text, colour::bold) + '\n';
}

std::string bus_view::table(bus_statistics const& statistics) const
{
    constexpr std::size_t count_width = 10;
    auto const            names       = drives_.longest_name();
    auto const            total       = statistics.total();
    auto const            has_times   = not total.times.empty();

    auto const head = [&](std::string_view address, std::string_view name) {
        return right(address, 9) + (names == 0 ? "" : "  " + left(name, std::max<std::size_t>(names, 5)));
    };
    auto heading = head("address", "drive");
    for (auto const* const title : {"requests", "replies", "refused", "no reply", "bad sum", "dropped"}) {
        heading += right(title, count_width);
    }
    if (total.unclear != 0) { heading += right("unclear", count_width); }
    if (has_times) {
        for (auto const* const title : {"min ms", "mean ms", "max ms"}) { heading += right(title, count_width); }
    }
    auto text = painted(heading, colour::bold) + '\n';

    auto const add = [&](std::string const& begin, bus_counters const& counters) {
        text += begin;
        auto const put = [&](std::uint64_t number, std::string_view if_any) {
            auto const column = right(std::to_string(number), count_width);
            text += painted(column, number == 0 ? colour::dim : if_any);
        };
        put(counters.requests, colour::none);
        put(counters.replies, colour::none);
        put(counters.refusals, colour::yellow);
        put(counters.silences, colour::red);
        put(counters.bad_checks, colour::magenta);
        put(counters.dropped_bytes, colour::magenta);
        if (total.unclear != 0) { put(counters.unclear, colour::none); }
        if (has_times) {
            auto const& times = counters.times;
            auto const  ms    = [&](std::uint64_t time) { return times.empty() ? "-" : decimal(time, 1); };
            text += right(ms(times.least()), count_width) + right(ms(times.empty() ? 0 : times.mean()), count_width)
                    + right(ms(times.most()), count_width);
        }
        text += '\n';
    };
    for (auto const& [address, counters] : statistics.rows()) {
        add(head(address == 0 ? "all" : std::to_string(address), drives_.name_of(address)), counters);
    }
    if (statistics.line().dropped_bytes != 0) { add(head("-", ""), statistics.line()); }
    if (statistics.rows().size() + (statistics.line().dropped_bytes != 0 ? 1 : 0) > 1) { add(head("sum", ""), total); }
    return text;
}

}  // namespace support
