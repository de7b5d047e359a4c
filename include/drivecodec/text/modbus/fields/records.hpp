// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/functions/read_device_identification.hpp>
#include <drivecodec/modbus/functions/read_file_record.hpp>
#include <drivecodec/modbus/functions/write_file_record.hpp>
#include <drivecodec/text/modbus/device_identification.hpp>
#include <drivecodec/text/modbus/field_values.hpp>
#include <drivecodec/text/modbus/fields/values.hpp>

// The fields of messages that carry records, and of the records: 20, 21, 43/14.

namespace drivecodec::modbus {

//=== 20 and 21 ===//

template <typename Function, typename Records, std::size_t MinBytes, std::size_t MaxBytes>
constexpr void for_each_field(records_message<Function, Records, MinBytes, MaxBytes> const& message, auto&& visit)
{
    visit("byte_count", detail::byte_count_of(message.records()));
    if constexpr (fixed_size<Records>) {  // a constant message of one record
        visit("records", std::span<Records const, 1>{&message.records(), 1});
    } else {
        visit("records", message.records());
    }
}

constexpr void for_each_field(file_record_range const& range, auto&& visit)
{
    visit("reference_type", file_reference_type);
    visit("file", range.file());
    visit("record", range.record());
    visit("length", range.count());
}

template <typename Values>
constexpr void for_each_field(basic_file_record<Values> const& record, auto&& visit)
{
    for_each_field(record.range(), visit);
    visit("registers", detail::view_of(record.values()));
}

constexpr void for_each_field(file_values const& values, auto&& visit)
{
    visit("length", static_cast<std::uint8_t>(values.wire_size() - layout::file_values::length.end));
    visit("reference_type", file_reference_type);
    visit("registers", detail::view_of(values.values));
}

//=== 43/14 ===//

constexpr void for_each_field(read_device_identification::request const& asked, auto&& visit)
{
    visit("mei_type", read_device_identification::mei);
    visit("read_device_id_code", asked.id_code());
    visit("object_id", asked.object_id());
}

constexpr void for_each_field(device_object const& object, auto&& visit)
{
    visit("id", object.id);
    visit("value", ascii_text{object.value});
}

constexpr void for_each_field(read_device_identification::response const& given, auto&& visit)
{
    visit("mei_type", read_device_identification::mei);
    visit("read_device_id_code", given.id_code());
    visit("conformity", given.conformity());
    visit("more_follows", given.more_follows() ? more_follows::yes : more_follows::no);
    visit("next_object_id", given.next_object_id());
    visit("object_count", static_cast<std::uint8_t>(given.objects().size()));
    visit("objects", given.objects());
}

}  // namespace drivecodec::modbus
