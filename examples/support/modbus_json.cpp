// SPDX-License-Identifier: MIT
#include "modbus_json.hpp"

#include "hex.hpp"
#include "json.hpp"

#include <drivecodec/text/modbus.hpp>

#include <array>

namespace support {

namespace {

namespace modbus = drivecodec::modbus;
using drivecodec::bytes;

std::string text_of(modbus::comm_event event)
{
    std::array<char, 200> buffer;
    return std::string{drivecodec::describe(event, buffer)};
}

/// A visitor of `modbus::for_each_field`.
class json_fields {
public:
    explicit json_fields(json_object& out) : out_{out} {}

    void operator()(std::string_view name, std::unsigned_integral auto number) { out_.add(name, number); }

    template <typename Enum>
        requires std::is_enum_v<Enum>
    void operator()(std::string_view name, Enum number)
    {
        out_.add(name, static_cast<std::underlying_type_t<Enum>>(number));
        auto const its_name = to_string(number);
        if (its_name.empty()) { return; }
        out_.add(name == "id" ? "name" : std::string{name} + "_name", its_name);
    }

    void operator()(std::string_view name, modbus::ascii_text text)
    {
        out_.add(name, std::string(text.characters.begin(), text.characters.end()));
    }

    void operator()(std::string_view name, modbus::comm_event_list events)
    {
        json_array names;
        for (auto const event : events) { names.add(json_text(text_of(event))); }
        (*this)(name, events.log);
        out_.add_json("event_names", names.text());
    }

    /// A list of numbers, or of records.
    template <typename List>
        requires requires(List const& list) { list.begin(), list.end(); }
    void operator()(std::string_view name, List const& list)
    {
        json_array values;
        for (auto const& element : list) {
            if constexpr (modbus::has_fields<std::remove_cvref_t<decltype(element)>>) {
                json_object record;
                for_each_field(element, json_fields{record});
                values.add(record.text());
            } else {
                values.add(std::to_string(element));
            }
        }
        out_.add_json(name, values.text());
    }

private:
    json_object& out_;
};

}  // namespace

std::string to_json(modbus::rtu::frame const& found, bytes request)
{
    json_object out;
    out.add("protocol", "modbus-rtu");
    out.add("direction", to_string(found.direction));
    out.add("address", found.address());
    out.add("function", to_byte(found.function()));
    if (auto const name = modbus::function_name(found.pdu()); not name.empty()) {
        out.add("name", name);
    } else {
        out.add_null("name");
    }

    auto const add_fields = [&]<typename Message>(Message const& message) {
        if constexpr (modbus::has_fields<Message>) { for_each_field(message, json_fields{out}); }
    };
    using functions  = modbus::public_functions;
    auto const fault = modbus::visit_message<functions>(found.direction, found.pdu(), request, add_fields);
    if (not fault.ok() and fault.code() != drivecodec::errc::unsupported_function) {
        out.add("error", to_string(fault.code()));
        out.add("error_offset", fault.moved_by(modbus::rtu::layout::adu::pdu).offset());
    }
    out.add("aligned", found.aligned);
    out.add("raw", to_hex(found.raw));
    return out.text();
}

}  // namespace support
