#include <drivecodec/modbus/functions.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

#include <algorithm>
#include <random>

// What holds for every public function alike. The limits of each, and what is its own, are in the tests of its header.

namespace {

using namespace drivecodec;
using namespace properties;

/// A valid PDU and what its front says: `header` bytes until its size is known, of a message of `least` bytes at least.
struct sample {
    char const*  name;
    message_type type;
    byte_vector  pdu;
    std::size_t  header;
    std::size_t  least;
};

/// `size` bytes that are all different from their neighbours, behind `head`.
[[nodiscard]] byte_vector filled(bytes head, std::size_t size)
{
    auto made = copy_of(head);
    for (std::size_t i = 0; i < size; ++i) { made.push_back(static_cast<std::uint8_t>(37 * i + 11)); }
    return made;
}

template <typename T>
[[nodiscard]] sample printed(char const* name, bytes pdu, std::size_t header, std::size_t least)
{
    return {name, type_of<T>(), copy_of(pdu), header, least};
}

template <typename T>
[[nodiscard]] sample largest(char const* name, bytes head, std::size_t size, std::size_t header, std::size_t least)
{
    return {name, type_of<T>(), filled(head, size), header, least};
}

constexpr std::size_t any_length = 0;    // header of what ends with silence
constexpr std::size_t in_steps   = 255;  // header of what tells its length bit by bit

[[nodiscard]] std::vector<sample> printed_requests()
{
    using namespace modbus;
    return {
        printed<read_coils::request>("read_coils", vectors::read_coils_request, 5, 5),
        printed<read_coils::request>("no_such_coil", vectors::exception_request, 5, 5),
        printed<read_discrete_inputs::request>("read_discrete_inputs", vectors::read_discrete_inputs_request, 5, 5),
        printed<read_holding_registers::request>("read_holding_registers", vectors::read_holding_registers_request, 5, 5),
        printed<read_input_registers::request>("read_input_registers", vectors::read_input_registers_request, 5, 5),
        printed<write_single_coil::request>("write_single_coil", vectors::write_single_coil, 5, 5),
        printed<write_single_register::request>("write_single_register", vectors::write_single_register, 5, 5),
        printed<read_exception_status::request>("read_exception_status", vectors::read_exception_status_request, 1, 1),
        printed<diagnostics::request>("diagnostics", vectors::diagnostics, any_length, 3),
        printed<get_comm_event_counter::request>("get_comm_event_counter", vectors::get_comm_event_counter_request, 1, 1),
        printed<get_comm_event_log::request>("get_comm_event_log", vectors::get_comm_event_log_request, 1, 1),
        printed<write_multiple_coils::request>("write_multiple_coils", vectors::write_multiple_coils_request, 6, 7),
        printed<write_multiple_registers::request>("write_multiple_registers", vectors::write_multiple_registers_request, 6, 8),
        printed<report_server_id::request>("report_server_id", "11"_hex, 1, 1),
        printed<read_file_record::request>("read_file_record", vectors::read_file_record_request, 2, 9),
        printed<write_file_record::request>("write_file_record", vectors::write_file_record, 2, 11),
        printed<mask_write_register::request>("mask_write_register", vectors::mask_write_register, 7, 7),
        printed<read_write_multiple_registers::request>("read_write_multiple_registers",
                                                        vectors::read_write_multiple_registers_request, 10, 12),
        printed<read_fifo_queue::request>("read_fifo_queue", vectors::read_fifo_queue_request, 3, 3),
        printed<canopen_general_reference::request>("canopen_general_reference", "2B 0D 11 22 33"_hex, any_length, 2),
        printed<read_device_identification::request>("read_device_identification",
                                                     vectors::read_device_identification_request, 4, 4),
    };
}

[[nodiscard]] std::vector<sample> printed_responses()
{
    using namespace modbus;
    return {
        printed<read_coils::response>("read_coils", vectors::read_coils_response, 2, 3),
        printed<read_discrete_inputs::response>("read_discrete_inputs", vectors::read_discrete_inputs_response, 2, 3),
        printed<read_holding_registers::response>("read_holding_registers", vectors::read_holding_registers_response, 2, 4),
        printed<read_input_registers::response>("read_input_registers", vectors::read_input_registers_response, 2, 4),
        printed<write_single_coil::response>("write_single_coil", vectors::write_single_coil, 5, 5),
        printed<write_single_register::response>("write_single_register", vectors::write_single_register, 5, 5),
        printed<read_exception_status::response>("read_exception_status", vectors::read_exception_status_response, 2, 2),
        printed<diagnostics::response>("diagnostics", vectors::diagnostics, any_length, 3),
        printed<get_comm_event_counter::response>("get_comm_event_counter", vectors::get_comm_event_counter_response, 5, 5),
        printed<get_comm_event_log::response>("get_comm_event_log", vectors::get_comm_event_log_response, 2, 8),
        printed<write_multiple_coils::response>("write_multiple_coils", vectors::write_multiple_coils_response, 5, 5),
        printed<write_multiple_registers::response>("write_multiple_registers",
                                                    vectors::write_multiple_registers_response, 5, 5),
        printed<report_server_id::response>("report_server_id", "11 05 01 02 03 FF 04"_hex, 2, 3),
        printed<read_file_record::response>("read_file_record", vectors::read_file_record_response, 2, 6),
        printed<write_file_record::response>("write_file_record", vectors::write_file_record, 2, 11),
        printed<mask_write_register::response>("mask_write_register", vectors::mask_write_register, 7, 7),
        printed<read_write_multiple_registers::response>("read_write_multiple_registers",
                                                         vectors::read_write_multiple_registers_response, 2, 4),
        printed<read_fifo_queue::response>("read_fifo_queue", vectors::read_fifo_queue_response, 3, 5),
        printed<canopen_general_reference::response>("canopen_general_reference", "2B 0D 11 22"_hex, any_length, 2),
        printed<read_device_identification::response>("read_device_identification",
                                                      vectors::read_device_identification_response, in_steps, 7),
    };
}

[[nodiscard]] std::vector<sample> largest_messages()
{
    using namespace modbus;
    return {
        largest<read_coils::response>("coils_2000", "01 FA"_hex, 250, 2, 3),
        largest<read_discrete_inputs::response>("inputs_2000", "02 FA"_hex, 250, 2, 3),
        largest<read_holding_registers::response>("holding_registers_125", "03 FA"_hex, 250, 2, 4),
        largest<read_input_registers::response>("input_registers_125", "04 FA"_hex, 250, 2, 4),
        largest<diagnostics::request>("query_data_250", "08 00 00"_hex, 250, any_length, 3),
        largest<diagnostics::response>("unknown_diagnostic_250", "08 FF FF"_hex, 250, any_length, 3),
        largest<get_comm_event_log::response>("events_64", "0C 46 FF FF 01 02 03 04"_hex, 64, 2, 8),
        largest<write_multiple_coils::request>("write_coils_1968", "0F 00 00 07 B0 F6"_hex, 246, 6, 7),
        largest<write_multiple_registers::request>("write_registers_123", "10 FF 85 00 7B F6"_hex, 246, 6, 8),
        largest<report_server_id::response>("server_id_251", "11 FB"_hex, 251, 2, 3),
        largest<read_file_record::response>("file_values_124", "14 FA F9 06"_hex, 248, 2, 6),
        largest<write_file_record::request>("file_record_122", "15 FB 06 00 01 00 00 00 7A"_hex, 244, 2, 11),
        largest<write_file_record::response>("file_record_122_written", "15 FB 06 FF FF 26 96 00 7A"_hex, 244, 2, 11),
        largest<read_write_multiple_registers::request>("write_121_read_125", "17 FF 83 00 7D FF 87 00 79 F2"_hex, 242, 10,
                                                        12),
        largest<read_write_multiple_registers::response>("read_back_125", "17 FA"_hex, 250, 2, 4),
        largest<read_fifo_queue::response>("fifo_31", "18 00 40 00 1F"_hex, 62, 3, 5),
        largest<canopen_general_reference::request>("canopen_251", "2B 0D"_hex, 251, any_length, 2),
        largest<canopen_general_reference::response>("canopen_251_back", "2B 0D"_hex, 251, any_length, 2),
        largest<read_device_identification::response>("object_244", "2B 0E 04 83 00 00 01 80 F4"_hex, 244, in_steps, 7),
    };
}

//=== every sample ===//

[[nodiscard]] std::vector<sample> const& samples()
{
    static auto const all = [] {
        auto made = printed_requests();
        for (auto const& more : {printed_responses(), largest_messages()}) {
            made.insert(made.end(), more.begin(), more.end());
        }
        return made;
    }();
    return all;
}

TEST(every_message, survives_decoding_and_encoding)
{
    for (auto const& [name, type, pdu, header, least] : samples()) {
        SCOPED_TRACE(name);
        EXPECT_EQ(type.check(pdu), error{});
        EXPECT_EQ(to_hex(type.recode(pdu)), to_hex(pdu));
    }
}

TEST(every_message, is_read_at_every_alignment)
{
    for (auto const& [name, type, pdu, header, least] : samples()) {
        SCOPED_TRACE(name);
        for (std::size_t offset = 1; offset < 8; ++offset) {
            byte_vector moved(offset, 0xEE);
            moved.insert(moved.end(), pdu.begin(), pdu.end());
            EXPECT_EQ(type.recode(bytes{moved}.subspan(offset)), pdu) << offset;
        }
    }
}

TEST(every_message, knows_its_length_from_its_header)
{
    for (auto const& [name, type, pdu, header, least] : samples()) {
        SCOPED_TRACE(name);
        for (std::size_t size = 0; size <= pdu.size(); ++size) {
            auto const front  = copy_of(bytes{pdu}.first(size));
            auto const length = type.length(front);
            if (header == any_length) {
                if (size >= least) { EXPECT_TRUE(length.is_until_silence()) << size; }
            } else if (size < header and not length.is_exact()) {
                EXPECT_TRUE(length.is_open()) << size;
                EXPECT_GT(length.size(), size);
                EXPECT_LE(length.size(), pdu.size());
            } else {
                EXPECT_EQ(length, message_length::exactly(pdu.size())) << size;
            }
        }
        EXPECT_TRUE(length_settles(type, pdu));
    }
}

TEST(every_message, that_is_cut_short_is_truncated)
{
    for (auto const& [name, type, pdu, header, least] : samples()) {
        SCOPED_TRACE(name);
        auto const end = header == any_length ? least : pdu.size();
        for (std::size_t size = 0; size < end; ++size) {
            auto const front = copy_of(bytes{pdu}.first(size));
            auto const fault = type.check(front);
            if (header == in_steps and size >= least) {
                EXPECT_EQ(fault.code(), errc::truncated);
                EXPECT_GT(fault.offset(), size);
                EXPECT_LE(fault.offset(), end);
            } else {
                EXPECT_EQ(fault, (error{errc::truncated, size < header ? least : end})) << size;
            }
        }
    }
}

TEST(every_message, with_one_byte_too_many_has_trailing_bytes)
{
    for (auto const& [name, type, pdu, header, least] : samples()) {
        SCOPED_TRACE(name);
        if (header == any_length and pdu.size() < modbus::max_pdu_size) { continue; }
        auto longer = pdu;
        longer.push_back(0);
        if (type.code == 0x08) { longer.push_back(0); }  // comes in words
        EXPECT_EQ(type.check(longer), (error{errc::trailing_bytes, pdu.size()}));
    }
}

TEST(every_message, of_another_function_is_unexpected)
{
    for (auto const& [name, type, pdu, header, least] : samples()) {
        SCOPED_TRACE(name);
        for (unsigned other = 0; other <= 0xFF; ++other) {
            auto changed = pdu;
            changed[0]   = static_cast<std::uint8_t>(other);
            if (changed[0] == pdu[0]) { continue; }
            EXPECT_EQ(type.check(changed), (error{errc::unexpected_function, 0})) << other;
            EXPECT_EQ(type.check(bytes{changed}.first(1)), (error{errc::unexpected_function, 0})) << other;
        }
    }
}

TEST(every_message, with_one_bit_flipped_is_refused_or_is_another_message)
{
    for (auto const& [name, type, pdu, header, least] : samples()) {
        SCOPED_TRACE(name);
        for (std::size_t bit = 0; bit < 8 * pdu.size(); ++bit) {
            auto changed     = pdu;
            changed[bit / 8] = static_cast<std::uint8_t>(changed[bit / 8] ^ (1U << bit % 8));
            ASSERT_TRUE(consistent(type, changed)) << "bit " << bit;
        }
    }
}

TEST(every_message, with_any_byte_in_its_front_is_refused_or_is_another_message)
{
    for (auto const& [name, type, pdu, header, least] : samples()) {
        SCOPED_TRACE(name);
        for (std::size_t at = 0; at < pdu.size() and at < 12; ++at) {
            for (unsigned byte = 0; byte <= 0xFF; ++byte) {
                auto changed = pdu;
                changed[at]  = static_cast<std::uint8_t>(byte);
                ASSERT_TRUE(consistent(type, changed)) << int{changed[at]} << " at " << at;
            }
        }
    }
}

// Byte counts 0, odd, 255, larger than the frame, on every prefix.
TEST(every_message, with_any_count_is_consistent_however_much_of_it_came)
{
    for (auto const& [name, type, pdu, header, least] : samples()) {
        SCOPED_TRACE(name);
        for (std::size_t at = 1; at < pdu.size() and at < 10; ++at) {
            for (auto const count : "00 01 02 03 7F 80 FE FF"_hex) {
                auto changed = pdu;
                changed[at]  = count;
                ASSERT_TRUE(length_settles(type, changed)) << int{count} << " at " << at;
                for (std::size_t size = 0; size <= pdu.size(); ++size) {
                    ASSERT_TRUE(consistent(type, bytes{changed}.first(size))) << int{count} << " at " << at;
                }
            }
        }
    }
}

TEST(every_message, of_random_bytes_is_refused_or_encodes_to_them)
{
    for (auto const& [name, type, pdu, header, least] : samples()) {
        SCOPED_TRACE(name);
        std::mt19937 random{20};
        for (int trial = 0; trial < 2000; ++trial) {
            byte_vector noise(random() % 270);
            for (auto& byte : noise) { byte = static_cast<std::uint8_t>(random() % 4 == 0 ? random() : random() % 4); }
            auto const kept = std::min<std::size_t>({noise.size(), pdu.size(), 1 + random() % (std::min<std::size_t>(header, 12) + 3)});
            std::copy_n(pdu.begin(), kept, noise.begin());
            ASSERT_TRUE(consistent(type, noise));
            ASSERT_TRUE(length_settles(type, bytes{noise}.first(std::min<std::size_t>(noise.size(), 16))));
        }
    }
}

//=== the set ===//

TEST(public_functions, know_every_printed_request_by_name_and_length)
{
    for (auto const& [name, pdu] : vectors::printed_requests) {
        EXPECT_STREQ(modbus::public_functions::name(pdu), name);
        auto const length = modbus::public_functions::request_length(pdu);
        EXPECT_TRUE(length == message_length::exactly(pdu.size()) or length.is_until_silence()) << name;
    }
}

TEST(public_functions, know_every_printed_response_by_name_and_length)
{
    for (auto const& [name, pdu] : vectors::printed_responses) {
        EXPECT_STREQ(modbus::public_functions::name(pdu), name);
        auto const length = modbus::public_functions::response_length(pdu);
        EXPECT_TRUE(length == message_length::exactly(pdu.size()) or length.is_until_silence()) << name;
    }
}

TEST(public_functions, are_those_of_the_specification_and_no_other)
{
    constexpr std::array<std::uint8_t, 19> codes{1,  2,  3,  4,  5,  6,  7,  8,  11, 12,
                                                 15, 16, 17, 20, 21, 22, 23, 24, 43};
    for (unsigned code = 0; code <= 0x7F; ++code) {
        std::array<std::uint8_t, 2> const pdu{static_cast<std::uint8_t>(code), 0x0E};
        auto const is_public = std::find(codes.begin(), codes.end(), pdu[0]) != codes.end();
        EXPECT_EQ(modbus::public_functions::name(pdu) != nullptr, is_public) << code;
        EXPECT_EQ(modbus::public_functions::request_length(pdu).is_until_silence(), not is_public) << code;
    }
}

TEST(public_functions, that_write_may_be_broadcast)
{
    using namespace modbus;
    VERIFY(is_write<write_single_coil>() and is_write<write_single_register>());
    VERIFY(is_write<write_multiple_coils>() and is_write<write_multiple_registers>());
    VERIFY(is_write<mask_write_register>() and is_write<write_file_record>());
    VERIFY(not is_write<read_coils>() and not is_write<read_discrete_inputs>());
    VERIFY(not is_write<read_holding_registers>() and not is_write<read_input_registers>());
    VERIFY(not is_write<read_exception_status>() and not is_write<report_server_id>());
    VERIFY(not is_write<get_comm_event_counter>() and not is_write<get_comm_event_log>());
    VERIFY(not is_write<read_file_record>() and not is_write<read_fifo_queue>());
    VERIFY(not is_write<read_device_identification>() and not is_write<read_write_multiple_registers>());
}

}  // namespace
