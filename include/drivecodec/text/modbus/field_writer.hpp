// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/text/modbus/fields.hpp>

#include <ranges>

namespace drivecodec::modbus {

/// Writes fields as text: `first=107 count=3`, lists as `[1 2 3]`, records as `{...}`. A visitor of `for_each_field`.
class field_writer {
public:
    /// `before` is written before the first field, if there is one.
    constexpr explicit field_writer(text_writer& out, std::string_view before = {}) noexcept
        : out_{&out}, between_{before}
    {}

    template <typename Field>
    constexpr void operator()(std::string_view name, Field const& field) noexcept
    {
        out_->put(between_).put(name).put('=');
        between_ = " ";
        write(field);
    }

private:
    constexpr void write(bool field) noexcept { out_->put(field ? '1' : '0'); }
    constexpr void write(std::string_view field) noexcept { out_->put(field); }
    constexpr void write(comm_event field) noexcept { write_text(*out_, field); }
    constexpr void write(ascii_text field) noexcept { out_->quoted(field.characters); }
    constexpr void write(bytes field) noexcept { out_->put(field.empty() ? "[" : "[0x").hex(field, " 0x").put(']'); }

    template <std::integral Number>
    constexpr void write(Number field) noexcept
    {
        out_->decimal(field);
    }

    template <typename Enum>
        requires std::is_enum_v<Enum>
    constexpr void write(Enum field) noexcept
    {
        if (auto const name = to_string(field); not name.empty()) {
            out_->put(name);
        } else {
            out_->put("0x").hex(static_cast<std::underlying_type_t<Enum>>(field));
        }
    }

    template <typename List>
        requires requires(List const& list) { list.begin(), list.end(); }
    constexpr void write(List const& field) noexcept
    {
        auto between = std::string_view{};
        out_->put('[');
        for (auto const& element : field) {
            out_->put(between);
            write(element);
            between = " ";
        }
        out_->put(']');
    }

    template <has_fields Record>
    constexpr void write(Record const& field) noexcept
    {
        out_->put('{');
        for_each_field(field, field_writer{*out_});
        out_->put('}');
    }

    text_writer*     out_;
    std::string_view between_;
};

/// The fields of `message`, if it says what they are; `before` the first one, if there is one.
template <typename Message>
constexpr void write_fields(text_writer& out, Message const& message, std::string_view before = {}) noexcept
{
    if constexpr (has_fields<Message>) { for_each_field(message, field_writer{out, before}); }
}

}  // namespace drivecodec::modbus
