// SPDX-License-Identifier: MIT
#pragma once

#include "bus_view.hpp"
#include "line_options.hpp"

#include <memory>
#include <ostream>
#include <string>

namespace support {

struct bus_monitor_options {
    line_options line;
    bus_drives   drives;
    bus_look     look;
    bool         is_quiet = false;  ///< Writes no traffic.
    bool         json     = false;
};

/// Hears a line, writes what is said on it, and counts.
class bus_monitor final : public ear {
public:
    /// Both live as long as it.
    bus_monitor(bus_monitor_options const& chosen, std::ostream& out)
        : chosen_{chosen}, out_{out}, view_{chosen.look, chosen.drives}, decoder_{make_decoder()},
          ear_{*decoder_, time_out()}
    {
        chosen_.drives.for_each_address([&](std::uint8_t address) { statistics_.expect(address); });
        if (chosen_.line.request_first) { decoder_->request_timed_out(); }
    }

    void hear(drivecodec::bytes received, std::optional<timestamp> now) override
    {
        note(now);
        arrivals_.add(received.size(), now);
        ear_.hear(received, now);
    }

    void hear_nothing(std::optional<timestamp> now) override
    {
        note(now);
        ear_.hear_nothing(now);
    }

    [[nodiscard]] bool is_waiting_for_response() const override { return ear_.is_waiting_for_response(); }

    /// No more bytes come. `is_whole`: these were all there are, not what was heard until someone stopped listening.
    void end(bool is_whole)
    {
        decoder_->silence();
        decoder_->end(is_whole);
    }

    void write_table() const
    {
        if (chosen_.json) {
            for (auto const& [address, counters] : statistics_.rows()) { out_ << json_of(address, counters) << '\n'; }
            out_ << to_json(decoder_->counters()) << '\n';
        } else {
            out_ << view_.headline(decoder_->counters(), statistics_.protocol()) << view_.table(statistics_);
        }
    }

    [[nodiscard]] bus_statistics const& statistics() const { return statistics_; }
    [[nodiscard]] bool                  has_written() const { return has_written_; }

    /// Of the stream reader.
    [[nodiscard]] drivecodec::stream_counters counters() const { return decoder_->counters(); }

    /// In all that was shown.
    [[nodiscard]] std::uint64_t shown_bytes() const { return shown_bytes_; }

    /// Nothing was dropped, and every request answered.
    [[nodiscard]] bool is_healthy() const
    {
        auto const total = statistics_.total();
        return total.dropped_bytes == 0 and total.silences == 0;
    }

private:
    [[nodiscard]] std::uint64_t time_out() const { return std::uint64_t{chosen_.line.timeout} * 1000; }

    [[nodiscard]] std::unique_ptr<decoder> make_decoder()
    {
        auto const  how    = chosen_.json ? style::json : style::content;
        auto const& drives = chosen_.drives;
        return support::make_decoder(
            chosen_.line,
            {.how = how, .explain = [&](auto const& heard, auto asked) { return drives.explain(heard, asked); }},
            {.how = how, .explain = [&](auto const& heard) { return drives.explain(heard); }},
            [this](traffic_item const& item) { give(item); });
    }

    void note(std::optional<timestamp> now)
    {
        view_.pass(now);
        if (now) { last_ = now; }
    }

    void give(traffic_item const& item)
    {
        auto const when = arrivals_.take(item.size);
        shown_bytes_ += item.size;
        auto const event = statistics_.add(item, when);
        if (chosen_.is_quiet) { return; }
        auto shown = when.begin;
        if (item.kind == traffic::unanswered and item.until == silence_until::time_out and event.asked) {
            shown = *event.asked + time_out();
        } else if (not shown) {
            shown = last_;
        }
        out_ << (chosen_.json ? json_of(item, event, shown) + '\n' : view_.line(item, event, shown));
        has_written_ = true;
    }

    [[nodiscard]] std::string json_of(traffic_item const& item, bus_event const& event,
                                      std::optional<timestamp> when) const
    {
        json_object more;
        if (item.kind == traffic::unanswered) { more.add("unanswered", event.address.value_or(0)); }
        if (when) { more.add("time", *when); }
        if (event.response_time) { more.add("response_time", *event.response_time); }
        if (event.address and not chosen_.drives.name_of(*event.address).empty()) {
            more.add("drive", chosen_.drives.name_of(*event.address));
        }
        auto const extra = more.text();
        if (item.kind == traffic::unanswered) { return extra; }
        auto line = with_meaning(item, true);
        if (extra.size() > 2) { line = line.substr(0, line.size() - 1) + ',' + extra.substr(1); }
        return line;
    }

    [[nodiscard]] std::string json_of(std::uint8_t address, bus_counters const& counters) const
    {
        json_object row;
        row.add("statistics", address);
        if (auto const name = chosen_.drives.name_of(address); not name.empty()) { row.add("drive", name); }
        row.add("requests", counters.requests);
        row.add("replies", counters.replies);
        row.add("refusals", counters.refusals);
        row.add("silences", counters.silences);
        row.add("unclear", counters.unclear);
        row.add("bad_checksums", counters.bad_checks);
        row.add("dropped_bytes", counters.dropped_bytes);
        if (not counters.times.empty()) {
            row.add("least_response_time", counters.times.least());
            row.add("mean_response_time", counters.times.mean());
            row.add("most_response_time", counters.times.most());
        }
        return row.text();
    }

    bus_monitor_options const& chosen_;
    std::ostream&              out_;
    bus_view                   view_;
    arrival_times              arrivals_;
    bus_statistics             statistics_;
    std::optional<timestamp>   last_;
    std::uint64_t              shown_bytes_ = 0;
    bool                       has_written_ = false;
    std::unique_ptr<decoder>   decoder_;
    timed_ear                  ear_;
};

}  // namespace support
