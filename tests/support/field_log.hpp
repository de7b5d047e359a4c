#pragma once

#include <gtest/gtest.h>

#include <drivecodec/core/codec.hpp>
#include <drivecodec/text/modbus/fields.hpp>

#include <string>
#include <string_view>
#include <type_traits>

/// A visitor of `for_each_field` that keeps what it sees as text, plainly and in a way of its own.
class field_log {
public:
    explicit field_log(std::string& log) : log_{log} {}

    template <typename Field>
    void operator()(std::string_view name, Field const& field)
    {
        log_.append(name).append("=");
        show(field);
        log_.append(" ");
    }

private:
    void show(drivecodec::modbus::comm_event event) { show(event.raw); }
    void show(drivecodec::modbus::ascii_text text)
    {
        log_.append("'").append(text.characters.begin(), text.characters.end()).append("'");
    }

    template <typename Field>
    void show(Field const& field)
    {
        if constexpr (std::is_enum_v<Field>) {
            log_.append(std::to_string(static_cast<unsigned>(field)));
            if (not to_string(field).empty()) { log_.append("(").append(to_string(field)).append(")"); }
        } else if constexpr (std::is_unsigned_v<Field>) {
            log_.append(std::to_string(field));
        } else if constexpr (drivecodec::modbus::has_fields<Field>) {
            log_.append("{");
            for_each_field(field, field_log{log_});
            log_.append("}");
        } else {
            log_.append("[");
            for (auto const element : field) {
                show(element);
                if constexpr (not drivecodec::modbus::has_fields<decltype(element)>) { log_.append(" "); }
            }
            log_.append("]");
        }
    }

    std::string& log_;
};

template <typename Message>
std::string fields_of_message(Message const& message)
{
    std::string log;
    for_each_field(message, field_log{log});
    return log;
}

template <typename Message>
std::string fields_of(auto const& pdu)
{
    auto const message = drivecodec::decode<Message>(pdu);
    return message ? fields_of_message(*message) : "does not decode";
}
