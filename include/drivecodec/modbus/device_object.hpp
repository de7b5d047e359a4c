// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/message.hpp>

namespace drivecodec::modbus {

/// Objects of the device identification that the specification names; the others are the device's.
/// MODBUS Application Protocol V1.1b3, 6.21.
enum class device_object_id : std::uint8_t {
    vendor_name           = 0x00,
    product_code          = 0x01,
    major_minor_revision  = 0x02,
    vendor_url            = 0x03,
    product_name          = 0x04,
    model_name            = 0x05,
    user_application_name = 0x06,
};

/// What is asked for: a stream of all objects of a category, or one object.
enum class read_device_id_code : std::uint8_t {
    basic    = 1,  ///< Objects 00 to 02.
    regular  = 2,  ///< Objects 00 to 7F.
    extended = 3,  ///< All objects.
    specific = 4,  ///< One object.
};

/// How much a device can identify itself. Any other number is a value without a name.
enum class device_conformity : std::uint8_t {
    basic_stream          = 0x01,
    regular_stream        = 0x02,
    extended_stream       = 0x03,
    basic_and_specific    = 0x81,
    regular_and_specific  = 0x82,
    extended_and_specific = 0x83,
};

/// Does a device of this conformity also give single objects?
[[nodiscard]] constexpr bool has_specific_objects(device_conformity conformity) noexcept
{
    return (static_cast<unsigned>(conformity) & 0x80U) != 0;
}

/// The last object that may be asked for with this code, as far as a device of this conformity goes.
[[nodiscard]] constexpr device_object_id last_object_id(read_device_id_code code, device_conformity conformity) noexcept
{
    auto const asked  = static_cast<unsigned>(code);
    auto const offers = static_cast<unsigned>(conformity) & 0x7FU;
    auto const level  = asked < offers ? asked : offers;
    if (code == read_device_id_code::specific or level >= 3) { return device_object_id{0xFF}; }
    return level == 2 ? device_object_id{0x7F} : device_object_id::major_minor_revision;
}

namespace layout::device_object {  // | object id | length | value ...
inline constexpr u8_at<0>    id{};
inline constexpr u8_at<1>    length{};
inline constexpr std::size_t value = length.end;
}  // namespace layout::device_object

/// One object of the identification: an ASCII text for the standard ones, else what the device defines.
struct device_object {
    device_object_id id;
    bytes            value;  ///< At most 255 bytes fit its length, and 244 a response.

    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
    {
        return layout::device_object::value + value.size();
    }

    [[nodiscard]] static constexpr message_length length(bytes wire) noexcept
    {
        namespace at = layout::device_object;
        if (wire.size() < at::value) { return message_length::at_least(at::value); }
        return message_length::exactly(at::value + at::length.load(wire));
    }

    [[nodiscard]] static constexpr error check(bytes wire) noexcept { return check_size(wire, length(wire).size()); }

    [[nodiscard]] static constexpr device_object read(bytes wire) noexcept
    {
        namespace at = layout::device_object;
        return {.id = static_cast<device_object_id>(at::id.load(wire)), .value = wire.subspan(at::value)};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::device_object;
        at::id.store(out, static_cast<std::uint8_t>(id));
        at::length.store(out, static_cast<std::uint8_t>(value.size()));
        copy_bytes(value, out.subspan(at::value));
    }

    friend constexpr bool operator==(device_object const& a, device_object const& b) noexcept
    {
        return a.id == b.id and same_bytes(a.value, b.value);
    }
};

}  // namespace drivecodec::modbus
