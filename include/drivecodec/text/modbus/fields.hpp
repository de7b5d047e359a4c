// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/text/modbus/fields/numbers.hpp>
#include <drivecodec/text/modbus/fields/records.hpp>
#include <drivecodec/text/modbus/fields/values.hpp>

// The fields of every request and response, in wire order, under their names in MODBUS Application Protocol V1.1b3.
//
// `for_each_field(message, visit)` calls visit(name, field) for each. A field is one of these:
//
//   an unsigned integer             a number
//   an enum                         a number that may have a name: `to_string`
//   register_view, coil_view        a list of numbers
//   bytes                           a list of bytes whose meaning the device knows
//   ascii_text                      a text, if the device keeps to the specification
//   comm_event_list                 a list of events; `write_text` explains one
//   another range                   a list of records, which have fields of their own
//
// A user's own message brings its own `for_each_field`, in the namespace of the message; without one it has no fields.

namespace drivecodec::modbus {

namespace detail {
struct any_visitor {
    constexpr void operator()(std::string_view, auto const&) const noexcept {}
};
}  // namespace detail

/// Does the message say what its fields are? (A class: an enum converts to a message that is made of it.)
template <typename Message>
concept has_fields = std::is_class_v<Message> and requires(Message const& message, detail::any_visitor const visit) {
    for_each_field(message, visit);
};

}  // namespace drivecodec::modbus
