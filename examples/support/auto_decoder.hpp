// SPDX-License-Identifier: MIT
#pragma once

#include "decoder.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace support {

/// Tells Modbus from the FC protocol, then is a decoder of that one.
///
/// A CRC beats a BCC: Modbus is believed from its first frame on, FC from its second telegram on if no CRC frame begins
/// before the end of that. Until then both read every byte, and what they find is held back; then what one found is
/// given, and the other is forgotten. What is given depends on the bytes and silences alone, not on their chunks.
///
/// After `most_held` bytes without a decision they are given as what they are in Modbus, dropped bytes, a silence is
/// assumed, and the search begins anew. At the end of what was whole one FC telegram is enough, if it began a line.
class auto_decoder final : public decoder {
public:
    static constexpr std::size_t most_held = 4096;

    using maker = std::function<std::unique_ptr<protocol_decoder>(sink)>;

    auto_decoder(maker make_modbus, maker make_fc, sink out)
        : make_modbus_{std::move(make_modbus)}, make_fc_{std::move(make_fc)}, out_{std::move(out)}
    {
        begin();
    }

    void push(drivecodec::bytes received) override
    {
        while (chosen_ == nullptr and not received.empty()) {  // one by one: it must not depend on the chunks
            for (auto* each : {&modbus_, &fc_}) { each->reader->push(received.first(1)); }
            received = received.subspan(1);
            ++held_;
            choose();
            if (chosen_ == nullptr and held_ == most_held) { give_up(); }
        }
        if (chosen_ != nullptr) { chosen_->reader->push(received); }
        give();
    }

    void silence() override
    {
        for_each([](protocol_decoder& each) { each.silence(); });
    }

    void request_timed_out() override
    {
        for_each([](protocol_decoder& each) {
            if (each.is_waiting_for_response()) { each.request_timed_out(); }
        });
    }

    void end(bool is_whole) override
    {
        if (chosen_ == nullptr) {
            auto const is_fc = is_whole and fc_.reader->found().first_begin and fc_.reader->found().is_aligned;
            chosen_          = is_fc ? &fc_ : &modbus_;
        }
        chosen_->reader->end(is_whole);
        give();
    }

    [[nodiscard]] bool is_waiting_for_response() const override
    {
        if (chosen_ != nullptr) { return chosen_->reader->is_waiting_for_response(); }
        return modbus_.reader->is_waiting_for_response() or fc_.reader->is_waiting_for_response();
    }

    [[nodiscard]] drivecodec::stream_counters counters() const override
    {
        return sum(given_up_, (chosen_ != nullptr ? *chosen_ : modbus_).reader->counters());
    }

private:
    struct candidate {
        std::unique_ptr<std::vector<traffic_item>> held;
        std::unique_ptr<protocol_decoder>          reader;
    };

    [[nodiscard]] static candidate make(maker const& make_reader)
    {
        candidate made{std::make_unique<std::vector<traffic_item>>(), nullptr};
        made.reader = make_reader([held = made.held.get()](traffic_item const& item) { held->push_back(item); });
        return made;
    }

    void begin()
    {
        modbus_ = make(make_modbus_);
        fc_     = make(make_fc_);
        held_   = 0;
    }

    template <typename Action>
    void for_each(Action act)
    {
        if (chosen_ != nullptr) {
            act(*chosen_->reader);
        } else {
            act(*modbus_.reader);
            act(*fc_.reader);
            choose();
        }
        give();
    }

    void choose()
    {
        auto const& modbus = modbus_.reader->found();
        auto const& fc     = fc_.reader->found();
        if (modbus.first_begin) {
            chosen_ = fc.second_end and *fc.second_end <= *modbus.first_begin ? &fc_ : &modbus_;
        } else if (fc.second_end and *fc.second_end <= modbus.judged) {
            chosen_ = &fc_;
        }
    }

    void give_up()
    {
        silence();
        if (chosen_ != nullptr) { return; }
        give(modbus_);
        given_up_ = sum(given_up_, modbus_.reader->counters());
        begin();
    }

    void give()
    {
        if (chosen_ != nullptr) { give(*chosen_); }
    }

    void give(candidate& from)
    {
        for (auto const& item : *from.held) { out_(item); }
        from.held->clear();
    }

    [[nodiscard]] static drivecodec::stream_counters sum(drivecodec::stream_counters a, drivecodec::stream_counters b)
    {
        a.frames += b.frames;
        a.unaligned_frames += b.unaligned_frames;
        a.dropped_runs += b.dropped_runs;
        a.dropped_bytes += b.dropped_bytes;
        a.bad_checksums += b.bad_checksums;
        a.truncated += b.truncated;
        return a;
    }

    maker                       make_modbus_;
    maker                       make_fc_;
    sink                        out_;
    candidate                   modbus_;
    candidate                   fc_;
    candidate*                  chosen_ = nullptr;
    std::size_t                 held_   = 0;
    drivecodec::stream_counters given_up_{};
};

}  // namespace support
