// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus.hpp>

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

// What a device behind a Modbus server holds.

namespace support {

namespace modbus = drivecodec::modbus;

/// Registers or coils at the addresses 0 to size - 1. What lies beyond is the exception "illegal data address".
template <typename Value>
class table {
public:
    explicit table(std::size_t size) : values_{std::make_unique<Value[]>(size)}, size_{size} {}

    [[nodiscard]] std::size_t      size() const noexcept { return size_; }
    [[nodiscard]] std::span<Value> all() const noexcept { return {values_.get(), size_}; }

    [[nodiscard]] modbus::answer<std::span<Value>> part(std::size_t first, std::size_t count) const noexcept
    {
        if (first + count > size_) { return modbus::exception_code::illegal_data_address; }
        return all().subspan(first, count);
    }

    /// The values as `View`, a register_view or coil_view, ready to be sent.
    template <typename View>
    [[nodiscard]] modbus::answer<View> read(std::size_t first, std::size_t count) const noexcept
    {
        auto const found = part(first, count);
        if (not found) { return found.error(); }
        return View{*found};
    }

    template <typename View>
    [[nodiscard]] modbus::answer<modbus::done> write(std::size_t first, View const& values) noexcept
    {
        auto const found = part(first, values.size());
        if (not found) { return found.error(); }
        auto to = found->begin();
        for (auto const value : values) { *to++ = value; }
        return modbus::done{};
    }

private:
    std::unique_ptr<Value[]> values_;  // not a vector: vector<bool> has no bools
    std::size_t              size_;
};

struct data_model {
    struct sizes {
        std::size_t holding_registers = 1000;
        std::size_t input_registers   = 1000;
        std::size_t coils             = 1000;
        std::size_t discrete_inputs   = 1000;
        std::size_t files             = 4;
    };

    explicit data_model(sizes const& wanted)
        : holding_registers{wanted.holding_registers}, input_registers{wanted.input_registers}, coils{wanted.coils},
          discrete_inputs{wanted.discrete_inputs}
    {
        for (std::size_t i = 0; i < wanted.files; ++i) {
            files.emplace_back(modbus::file_record_range::last_record + 1U);
        }
    }

    table<std::uint16_t> holding_registers;
    table<std::uint16_t> input_registers;
    table<bool>          coils;
    table<bool>          discrete_inputs;

    /// Files 1, 2, ...; each has the records 0 to 9999.
    std::vector<table<std::uint16_t>> files;

    /// The last values written to holding register 0, the oldest first: a FIFO queue with the pointer address 0.
    std::vector<std::uint16_t> queue;

    static constexpr std::uint16_t queue_address = 0;

    void enqueue(std::uint16_t value)
    {
        if (queue.size() == modbus::read_fifo_queue::max_count) { queue.erase(queue.begin()); }
        queue.push_back(value);
    }

    /// Some inputs live, as far as there are so many: input registers 0 and 1 are the milliseconds since the start (32
    /// bits, high word first), 2 counts the requests, 3 is a triangle wave; discrete input 0 toggles every second.
    void refresh(std::uint16_t requests)
    {
        using namespace std::chrono;
        auto const elapsed = duration_cast<milliseconds>(steady_clock::now() - start_).count();
        auto const uptime  = modbus::to_registers(static_cast<std::uint32_t>(elapsed), modbus::word_order::abcd);
        auto const wave    = static_cast<std::uint16_t>(elapsed % 2000 < 1000 ? elapsed % 1000 : 1000 - elapsed % 1000);

        std::uint16_t const live[] = {uptime[0], uptime[1], requests, wave};
        for (std::size_t i = 0; i < std::size(live) and i < input_registers.size(); ++i) {
            input_registers.all()[i] = live[i];
        }
        if (discrete_inputs.size() > 0) { discrete_inputs.all()[0] = elapsed / 1000 % 2 != 0; }
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace support
