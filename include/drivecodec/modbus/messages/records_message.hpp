// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/message.hpp>
#include <drivecodec/modbus/record_list.hpp>

namespace drivecodec::modbus {

namespace layout::records_message {  // | function | byte count | record | record | ...
inline constexpr u8_at<1>    byte_count{};
inline constexpr std::size_t records = byte_count.end;
}  // namespace layout::records_message

/// Records behind a byte count: requests and responses of functions 20 and 21. At least one record; `MaxBytes` in all.
///
/// Every object satisfies that. `Records` is a list of records or, for a constant message, one record of a fixed size.
template <typename Function, typename Records, std::size_t MinBytes, std::size_t MaxBytes>
class records_message {
public:
    using function = Function;

    constexpr explicit records_message(Records only_one) noexcept
        requires fixed_size<Records>
        : records_{only_one}
    {
        static_assert(Records::wire_size() <= MaxBytes, "the record does not fit in a PDU");
    }

    /// Errors: `bad_quantity` at the byte count: no record, or more than fit in a PDU.
    [[nodiscard]] static constexpr result<records_message> make(Records records_to_send) noexcept
    {
        auto const size = records_to_send.wire_size();
        if (size < MinBytes or size > MaxBytes) {
            return error{errc::bad_quantity, layout::records_message::byte_count.begin};
        }
        return records_message{records_to_send, checked{}};
    }

    [[nodiscard]] constexpr Records const& records() const noexcept { return records_; }

    [[nodiscard]] static constexpr std::size_t wire_size() noexcept
        requires fixed_size<Records>
    {
        return layout::records_message::records + Records::wire_size();
    }
    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
        requires(not fixed_size<Records>)
    {
        return layout::records_message::records + records_.wire_size();
    }

    [[nodiscard]] static constexpr message_length length(bytes pdu) noexcept
    {
        namespace at = layout::records_message;
        if (pdu.size() < at::records) { return message_length::at_least(at::records); }
        return message_length::exactly(at::records + at::byte_count.load(pdu));
    }

    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        namespace at     = layout::records_message;
        auto const fault = check_head(pdu, Function::code, at::records, at::records + MinBytes);
        if (not fault.ok()) { return fault; }
        std::size_t const size = at::byte_count.load(pdu);
        if (size < MinBytes or size > MaxBytes) { return {errc::bad_quantity, at::byte_count.begin}; }
        if (auto const wrong_size = check_size(pdu, at::records + size); not wrong_size.ok()) { return wrong_size; }
        return Records::check(pdu.subspan(at::records)).moved_by(at::records);
    }

    [[nodiscard]] static constexpr records_message read(bytes pdu) noexcept
    {
        return {Records::of_wire(pdu.subspan(layout::records_message::records)), checked{}};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::records_message;
        layout::function.store(out, to_byte(Function::code));
        at::byte_count.store(out, static_cast<std::uint8_t>(records_.wire_size()));
        records_.write(out.subspan(at::records));
    }

    friend constexpr bool operator==(records_message const&, records_message const&) noexcept = default;

protected:
    struct checked {};
    constexpr records_message(Records records, checked) noexcept : records_{records} {}

private:
    Records records_;
};

}  // namespace drivecodec::modbus
