// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/functions/canopen_general_reference.hpp>
#include <drivecodec/modbus/functions/get_comm_event_counter.hpp>
#include <drivecodec/modbus/functions/get_comm_event_log.hpp>
#include <drivecodec/modbus/functions/mask_write_register.hpp>
#include <drivecodec/modbus/functions/read_exception_status.hpp>
#include <drivecodec/modbus/functions/report_server_id.hpp>
#include <drivecodec/modbus/functions/write_single_register.hpp>
#include <drivecodec/text/modbus/comm_event.hpp>
#include <drivecodec/text/modbus/device_identification.hpp>
#include <drivecodec/text/modbus/exception_code.hpp>
#include <drivecodec/text/modbus/field_values.hpp>

// The fields of messages that are a few numbers, or bytes: 05, 06, 07, 11, 12, 17, 22, 43/13, exceptions.

namespace drivecodec::modbus {

template <typename Function>
constexpr void for_each_field(bare_request<Function> const&, auto&&)
{}

constexpr void for_each_field(write_single_coil::request const& message, auto&& visit)
{
    visit("output_address", message.address);
    visit("value", message.value ? coil_value::on : coil_value::off);
}

constexpr void for_each_field(write_single_register::request const& message, auto&& visit)
{
    visit("register_address", message.address);
    visit("value", message.value);
}

constexpr void for_each_field(read_exception_status::response const& given, auto&& visit)
{
    visit("outputs", static_cast<bits_8>(given.outputs));
}

constexpr void for_each_field(get_comm_event_counter::response const& given, auto&& visit)
{
    visit("status", given.busy ? program_status::busy : program_status::ready);
    visit("event_count", given.event_count);
}

constexpr void for_each_field(get_comm_event_log::response const& given, auto&& visit)
{
    namespace at = layout::get_comm_event_log_response;
    visit("byte_count", static_cast<std::uint8_t>(given.wire_size() - at::byte_count.end));
    visit("status", given.busy() ? program_status::busy : program_status::ready);
    visit("event_count", given.event_count());
    visit("message_count", given.message_count());
    visit("events", comm_event_list{given.events()});
}

constexpr void for_each_field(report_server_id::response const& given, auto&& visit)
{
    visit("byte_count", static_cast<std::uint8_t>(given.data().size()));
    visit("data", given.data());
}

constexpr void for_each_field(mask_write_register::request const& message, auto&& visit)
{
    visit("reference_address", message.address);
    visit("and_mask", static_cast<bits_16>(message.and_mask));
    visit("or_mask", static_cast<bits_16>(message.or_mask));
}

template <direction Direction>
constexpr void for_each_field(canopen_general_reference::message<Direction> const& message, auto&& visit)
{
    visit("mei_type", canopen_general_reference::mei);
    visit("payload", message.payload());
}

constexpr void for_each_field(exception_response const& refusal, auto&& visit)
{
    visit("exception", refusal.code);
}

}  // namespace drivecodec::modbus
