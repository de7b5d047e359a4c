// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/xd1000/functions.hpp>

// Who the drive is: function 43/14. xD1000 manual, "Read Device Identification".

namespace drivecodec::xd1000 {

/// What to ask: the three objects of the basic category, from the first on.
inline constexpr read_device_identification::request identify{modbus::read_device_id_code::basic};

/// What the drive says of its conformity: regular, though it has the basic objects only.
inline constexpr auto conformity = modbus::device_conformity::regular_stream;

/// Major and minor version: {2, 1} for "0201".
struct version {
    std::uint8_t major;
    std::uint8_t minor;

    friend constexpr bool operator==(version, version) noexcept = default;
};

/// The drive's objects, ASCII, borrowed from the response. Their lengths are those received: the manual prints 18 for a
/// name of 39 characters and 11 for a reference of 12.
struct identification {
    bytes vendor_name{};           ///< "Lauritz Knudsen Electrical & Automation"
    bytes product_code{};          ///< "xD1000H037N4", say
    bytes major_minor_revision{};  ///< "MMmm": "0201" is version 2.1

    /// Takes what a response holds. If that says that more follows, ask on from its next object, and take that too.
    constexpr void take(read_device_identification::response const& given) noexcept
    {
        for (auto const object : given.objects()) {
            if (object.id == modbus::device_object_id::vendor_name) { vendor_name = object.value; }
            if (object.id == modbus::device_object_id::product_code) { product_code = object.value; }
            if (object.id == modbus::device_object_id::major_minor_revision) { major_minor_revision = object.value; }
        }
    }

    /// Errors, at the character: `bad_value` if the revision is not of digits, `truncated` or `trailing_bytes` if it
    /// has not just four.
    [[nodiscard]] constexpr result<xd1000::version> version() const noexcept
    {
        auto const text = major_minor_revision;
        for (std::size_t i = 0; i < text.size() and i < 4; ++i) {
            if (text[i] < '0' or text[i] > '9') { return error{errc::bad_value, i}; }
        }
        if (text.size() < 4) { return error{errc::truncated, 4}; }
        if (text.size() > 4) { return error{errc::trailing_bytes, 4}; }
        auto const two_digits = [&](std::size_t at) {
            return static_cast<std::uint8_t>((text[at] - '0') * 10 + (text[at + 1] - '0'));
        };
        return xd1000::version{two_digits(0), two_digits(2)};
    }

    /// The drive's side: the objects that it has, for `read_device_identification::answer` with `conformity`.
    [[nodiscard]] constexpr std::array<modbus::device_object, 3> objects() const noexcept
    {
        using modbus::device_object_id;
        return {{{device_object_id::vendor_name, vendor_name},
                 {device_object_id::product_code, product_code},
                 {device_object_id::major_minor_revision, major_minor_revision}}};
    }
};

}  // namespace drivecodec::xd1000
