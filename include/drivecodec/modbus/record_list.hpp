// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/codec.hpp>
#include <drivecodec/core/message_length.hpp>

namespace drivecodec::modbus {

/// A part of a PDU that may stand several times, one behind the other: a codec that tells its own length.
template <typename T>
concept record = codec<T> and requires(bytes front) {
    { T::length(front) } noexcept -> std::same_as<message_length>;
};

/// Records, borrowed: as they lie on the wire, or as host objects that are to be sent. Iterated without a copy of the
/// whole; `*iterator` is one record by value, whose own payload still borrows.
template <record Record>
class record_list {
public:
    class iterator;

    constexpr record_list() noexcept = default;

    /// Host objects: an array, a span.
    template <borrowable_by<Record, record_list> Records>
    constexpr record_list(Records const& records) noexcept : record_list{std::span<Record const>{records}, host{}}
    {}

    /// Precondition: check(wire).ok().
    [[nodiscard]] static constexpr record_list of_wire(bytes wire) noexcept { return record_list{wire, wired{}}; }

    /// Is `wire` one valid record behind the other, to its last byte? A record that passes the end is `bad_length`.
    [[nodiscard]] static constexpr error check(bytes wire) noexcept
    {
        for (std::size_t offset = 0; offset < wire.size();) {
            auto const rest = wire.subspan(offset);
            auto const size = Record::length(rest);
            if (size.size() > rest.size()) { return {errc::bad_length, offset}; }
            if (auto const fault = Record::check(rest.first(size.size())); not fault.ok()) {
                return fault.moved_by(offset);
            }
            offset += size.size();
        }
        return {};
    }

    [[nodiscard]] constexpr iterator begin() const noexcept
    {
        return host_ ? iterator{records_} : iterator{bytes{wire_, extent_}};
    }
    [[nodiscard]] constexpr iterator end() const noexcept
    {
        return host_ ? iterator{records_ + extent_} : iterator{bytes{wire_ + extent_, 0}};
    }

    [[nodiscard]] constexpr bool empty() const noexcept { return extent_ == 0; }

    /// How many records. Walks them.
    [[nodiscard]] constexpr std::size_t size() const noexcept
    {
        std::size_t count = 0;
        for (auto it = begin(); not(it == end()); ++it) { ++count; }
        return count;
    }

    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
    {
        if (not host_) { return extent_; }
        std::size_t size = 0;
        for (std::size_t i = 0; i < extent_; ++i) { size += records_[i].wire_size(); }
        return size;
    }

    /// Precondition: out.size() == wire_size().
    constexpr void write(mutable_bytes out) const noexcept
    {
        if (not host_) { return copy_bytes({wire_, extent_}, out); }
        for (std::size_t i = 0; i < extent_; ++i) {
            auto const size = records_[i].wire_size();
            records_[i].write(out.first(size));
            out = out.subspan(size);
        }
    }

    friend constexpr bool operator==(record_list const& a, record_list const& b) noexcept
    {
        auto left  = a.begin();
        auto right = b.begin();
        for (; not(left == a.end()) and not(right == b.end()); ++left, ++right) {
            if (not(*left == *right)) { return false; }
        }
        return left == a.end() and right == b.end();
    }

private:
    struct host {};
    constexpr record_list(std::span<Record const> records, host) noexcept
        : records_{records.data()}, extent_{saturate_16(records.size())}, host_{true}
    {}
    struct wired {};
    constexpr record_list(bytes wire, wired) noexcept : wire_{wire.data()}, extent_{saturate_16(wire.size())} {}

    union {
        std::uint8_t const* wire_ = nullptr;
        Record const*       records_;
    };
    std::uint16_t extent_ = 0;      // bytes of wire_, or elements of records_
    bool          host_   = false;  // records_ is active, not wire_
};

template <record Record>
class record_list<Record>::iterator {
public:
    using difference_type = std::ptrdiff_t;
    using value_type      = Record;

    constexpr iterator() noexcept = default;
    constexpr explicit iterator(bytes rest) noexcept : rest_{rest} {}
    constexpr explicit iterator(Record const* at) noexcept : at_{at}, host_{true} {}

    [[nodiscard]] constexpr Record operator*() const noexcept
    {
        return host_ ? *at_ : Record::read(rest_.first(Record::length(rest_).size()));
    }

    constexpr iterator& operator++() noexcept
    {
        if (host_) {
            ++at_;
        } else {
            rest_ = rest_.subspan(Record::length(rest_).size());
        }
        return *this;
    }
    constexpr iterator operator++(int) noexcept
    {
        auto const before = *this;
        ++*this;
        return before;
    }

    friend constexpr bool operator==(iterator const& a, iterator const& b) noexcept
    {
        return a.host_ ? a.at_ == b.at_ : a.rest_.size() == b.rest_.size();
    }

private:
    bytes         rest_{};
    Record const* at_   = nullptr;
    bool          host_ = false;
};

}  // namespace drivecodec::modbus
