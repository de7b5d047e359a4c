// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/device_object.hpp>
#include <drivecodec/modbus/encapsulated_interface.hpp>
#include <drivecodec/modbus/exception.hpp>
#include <drivecodec/modbus/record_list.hpp>

namespace drivecodec::modbus {

namespace compile_error {
void read_device_id_code_must_be_between_1_and_4();
void device_object_id_must_be_between_0_and_255();
}  // namespace compile_error

namespace layout::read_device_identification_request {  // | function | MEI type | read device ID code | object id |
inline constexpr u8_at<2> code{};
inline constexpr u8_at<3> object_id{};
}  // namespace layout::read_device_identification_request

// | function | MEI type | read device ID code | conformity | more follows | next object id | object count | objects ...
namespace layout::read_device_identification_response {
inline constexpr u8_at<2>    code{};
inline constexpr u8_at<3>    conformity{};
inline constexpr u8_at<4>    more_follows{};
inline constexpr u8_at<5>    next_object_id{};
inline constexpr u8_at<6>    object_count{};
inline constexpr std::size_t objects = object_count.end;
}  // namespace layout::read_device_identification_response

/// Read Device Identification (43/14), MODBUS Application Protocol V1.1b3, 6.21.
struct read_device_identification {
    static constexpr auto        code = function_code::encapsulated_interface_transport;
    static constexpr auto        mei  = mei_type::read_device_identification;
    static constexpr char const* name = "read_device_identification";

    static constexpr std::size_t max_objects_size = max_pdu_size - layout::read_device_identification_response::objects;

    class request;
    class response;

    [[nodiscard]] static constexpr bool is_valid(std::uint8_t id_code) noexcept
    {
        return id_code >= 1 and id_code <= 4;
    }

    /// What a device with these `objects` (ascending by id) answers, over as many responses as it takes.
    ///
    /// A stream begins at the object asked for, or at the first one if there is no such object; where not all fit, the
    /// response says that more follow and from which object on to ask next. A device answers by its own conformity
    /// where more is asked. Exceptions: 02 for a specific object that there is not, 03 for a specific object of
    /// a device that only has streams, 04 for an object that fits no response.
    [[nodiscard]] static constexpr result<response, exception_code>
    answer(request const& asked, device_conformity conformity, std::span<device_object const> objects) noexcept;
};

/// Some or all of the objects asked for. Made by `answer`.
class read_device_identification::response {
public:
    using function = read_device_identification;

    [[nodiscard]] constexpr read_device_id_code id_code() const noexcept { return code_; }
    [[nodiscard]] constexpr device_conformity   conformity() const noexcept { return conformity_; }
    [[nodiscard]] constexpr bool                more_follows() const noexcept { return more_follows_; }
    [[nodiscard]] constexpr device_object_id    next_object_id() const noexcept { return next_object_id_; }
    [[nodiscard]] constexpr record_list<device_object> const& objects() const noexcept { return objects_; }

    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
    {
        return layout::read_device_identification_response::objects + objects_.wire_size();
    }

    [[nodiscard]] static constexpr message_length length(bytes pdu) noexcept
    {
        namespace at = layout::read_device_identification_response;
        if (pdu.size() < at::objects) { return message_length::at_least(at::objects); }
        std::size_t end = at::objects;
        for (unsigned left = at::object_count.load(pdu); left > 0; --left) {
            auto const object = device_object::length(pdu.subspan(end < pdu.size() ? end : pdu.size()));
            if (end > pdu.size() or object.is_open()) {
                return message_length::at_least(end + left * layout::device_object::value);
            }
            end += object.size();
        }
        return message_length::exactly(end);
    }

    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        namespace at = layout::read_device_identification_response;
        if (auto const fault = check_mei_head(pdu, mei, at::objects, at::objects); not fault.ok()) { return fault; }
        if (not is_valid(at::code.load(pdu))) { return {errc::bad_value, at::code.begin}; }
        auto const more = at::more_follows.load(pdu);
        if (more != follows and more != ends) { return {errc::bad_value, at::more_follows.begin}; }
        auto const size = length(pdu).size();
        return size > max_pdu_size ? error{errc::bad_length, at::object_count.begin} : check_size(pdu, size);
    }

    [[nodiscard]] static constexpr response read(bytes pdu) noexcept
    {
        namespace at = layout::read_device_identification_response;
        response given;
        given.code_           = static_cast<read_device_id_code>(at::code.load(pdu));
        given.conformity_     = static_cast<device_conformity>(at::conformity.load(pdu));
        given.more_follows_   = at::more_follows.load(pdu) == follows;
        given.next_object_id_ = static_cast<device_object_id>(at::next_object_id.load(pdu));
        given.objects_        = record_list<device_object>::of_wire(pdu.subspan(at::objects));
        return given;
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::read_device_identification_response;
        write_mei_head(out, mei);
        at::code.store(out, static_cast<std::uint8_t>(code_));
        at::conformity.store(out, static_cast<std::uint8_t>(conformity_));
        at::more_follows.store(out, more_follows_ ? follows : ends);
        at::next_object_id.store(out, static_cast<std::uint8_t>(next_object_id_));
        at::object_count.store(out, static_cast<std::uint8_t>(objects_.size()));
        objects_.write(out.subspan(at::objects));
    }

    friend constexpr bool operator==(response const&, response const&) noexcept = default;

private:
    friend read_device_identification;
    constexpr response() noexcept = default;

    static constexpr std::uint8_t follows = 0xFF;
    static constexpr std::uint8_t ends    = 0x00;

    record_list<device_object> objects_{};
    read_device_id_code        code_{};
    device_conformity          conformity_{};
    device_object_id           next_object_id_{};
    bool                       more_follows_ = false;
};

class read_device_identification::request {
public:
    using function = read_device_identification;

    /// Of a stream, `object_id` is 0 in the first request, then what the response before says.
    consteval explicit request(read_device_id_code id_code, int object_id = 0)
        : code_{id_code}, object_id_{static_cast<device_object_id>(object_id)}
    {
        if (not is_valid(static_cast<std::uint8_t>(id_code))) {
            compile_error::read_device_id_code_must_be_between_1_and_4();
        }
        if (object_id < 0 or object_id > 0xFF) { compile_error::device_object_id_must_be_between_0_and_255(); }
    }
    consteval request(read_device_id_code id_code, device_object_id object_id)
        : request{id_code, static_cast<int>(object_id)}
    {}

    /// Errors: `bad_value` at the read device ID code.
    [[nodiscard]] static constexpr result<request> make(read_device_id_code id_code,
                                                        device_object_id    object_id) noexcept
    {
        if (not is_valid(static_cast<std::uint8_t>(id_code))) {
            return error{errc::bad_value, layout::read_device_identification_request::code.begin};
        }
        return request{id_code, object_id, checked{}};
    }

    [[nodiscard]] constexpr read_device_id_code id_code() const noexcept { return code_; }
    [[nodiscard]] constexpr device_object_id    object_id() const noexcept { return object_id_; }

    [[nodiscard]] static constexpr std::size_t wire_size() noexcept
    {
        return layout::read_device_identification_request::object_id.end;
    }
    [[nodiscard]] static constexpr message_length length(bytes) noexcept
    {
        return message_length::exactly(wire_size());
    }

    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        namespace at = layout::read_device_identification_request;
        if (auto const fault = check_mei_head(pdu, mei, wire_size(), wire_size()); not fault.ok()) { return fault; }
        if (not is_valid(at::code.load(pdu))) { return {errc::bad_value, at::code.begin}; }
        return check_size(pdu, wire_size());
    }

    [[nodiscard]] static constexpr request read(bytes pdu) noexcept
    {
        namespace at = layout::read_device_identification_request;
        return {static_cast<read_device_id_code>(at::code.load(pdu)),
                static_cast<device_object_id>(at::object_id.load(pdu)), checked{}};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::read_device_identification_request;
        write_mei_head(out, mei);
        at::code.store(out, static_cast<std::uint8_t>(code_));
        at::object_id.store(out, static_cast<std::uint8_t>(object_id_));
    }

    /// Does the response repeat the code and, for a specific object, hold just that?
    [[nodiscard]] constexpr error matches(response const& given) const noexcept
    {
        namespace at = layout::read_device_identification_response;
        if (given.id_code() != code_) { return expect_equal(false, at::code.begin); }
        if (code_ != read_device_id_code::specific) { return {}; }
        if (given.objects().size() != 1) { return expect_equal(false, at::object_count.begin); }
        return expect_equal((*given.objects().begin()).id == object_id_, at::objects);
    }

    friend constexpr bool operator==(request const&, request const&) noexcept = default;

private:
    struct checked {};
    constexpr request(read_device_id_code id_code, device_object_id object_id, checked) noexcept
        : code_{id_code}, object_id_{object_id}
    {}

    read_device_id_code code_;
    device_object_id    object_id_;
};

constexpr auto read_device_identification::answer(request const& asked, device_conformity conformity,
                                                  std::span<device_object const> objects) noexcept
    -> result<response, exception_code>
{
    auto const is_specific = asked.id_code() == read_device_id_code::specific;
    if (is_specific and not has_specific_objects(conformity)) { return exception_code::illegal_data_value; }

    // The objects of the category come first, since they ascend by id.
    auto const  last_id = last_object_id(asked.id_code(), conformity);
    std::size_t end     = 0;
    while (end < objects.size() and objects[end].id <= last_id) { ++end; }

    std::size_t first = 0;
    while (first < end and objects[first].id != asked.object_id()) { ++first; }
    if (first == end) {
        if (is_specific) { return exception_code::illegal_data_address; }
        first = 0;
    }
    if (is_specific) { end = first + 1; }

    std::size_t stop = first;
    for (std::size_t size = 0; stop < end; ++stop) {
        size += objects[stop].wire_size();
        if (size > max_objects_size) { break; }
    }
    if (stop == first and first < end) { return exception_code::server_device_failure; }

    response given;
    given.code_           = asked.id_code();
    given.conformity_     = conformity;
    given.more_follows_   = stop < end;
    given.next_object_id_ = stop < end ? objects[stop].id : device_object_id{};
    given.objects_        = record_list<device_object>{objects.subspan(first, stop - first)};
    return given;
}

}  // namespace drivecodec::modbus
