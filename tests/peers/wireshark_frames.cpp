// SPDX-License-Identifier: MIT
//
// Writes random frames of every function that Wireshark knows, encoded by the library, as a capture file; and what its
// dissector should find in each, one line a frame: `field=value|value<TAB>field=...`, under Wireshark's names.
//
//     wireshark_frames CAPTURE EXPECTED SEED
#include <drivecodec/modbus.hpp>

#include <array>
#include <cstdint>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace modbus = drivecodec::modbus;
namespace rtu    = modbus::rtu;

using drivecodec::bytes;
using modbus::direction;

namespace {

//=== the files ===//

/// One field of Wireshark's, all its occurrences in the frame.
struct field {
    std::string_view           name;
    std::vector<std::uint64_t> values;
    std::vector<std::string>   texts{};
};

/// A capture of UDP packets, in which server 5020 and a port of its own for each request tell the directions apart.
class capture {
public:
    capture(std::string const& packets, std::string const& expected)
        : packets_{packets, std::ios::binary}, expected_{expected}
    {
        put_le32(0xA1B2'C3D4);
        put_le16(2);  // version 2.4
        put_le16(4);
        put_le32(0);
        put_le32(0);
        put_le32(65535);  // longest packet
        put_le32(101);    // raw IP
    }

    /// Another request and its response.
    void begin_exchange() { ++client_port_; }

    void add(direction which, bytes adu, std::vector<field> fields)
    {
        auto const size = adu.size();
        put_le32(0);
        put_le32(0);
        put_le32(static_cast<std::uint32_t>(28 + size));
        put_le32(static_cast<std::uint32_t>(28 + size));
        put_be16(0x4500);
        put_be16(28 + size);
        put_be16(0);
        put_be16(0);
        put_be16(0x4011);  // UDP
        put_be16(0);
        for (auto const address : {0x7F00, 0x0001, 0x7F00, 0x0001}) { put_be16(static_cast<std::size_t>(address)); }
        put_be16(which == direction::request ? client_port_ : server_port);
        put_be16(which == direction::request ? server_port : client_port_);
        put_be16(8 + size);
        put_be16(0);
        for (auto const byte : adu) { packets_.put(static_cast<char>(byte)); }

        if (adu.size() < least_dissected) {
            expected_ << '\n';
            return;
        }
        fields.push_back({"mbrtu.unit_id", {adu.front()}});
        fields.push_back({"mbrtu.crc16.status", {1}});  // good
        fields.push_back({"modbus.func_code", {static_cast<std::uint64_t>(rtu::pdu_of(adu).front() & 0x7F)}});
        for (auto const& [name, values, texts] : fields) {
            auto between = '=';
            expected_ << name;
            for (auto const value : values) { expected_ << std::exchange(between, '|') << value; }
            for (auto const& text : texts) { expected_ << std::exchange(between, '|') << text; }
            expected_ << (between == '=' ? "=" : "") << '\t';
        }
        expected_ << '\n';
    }

private:
    static constexpr std::size_t server_port     = 5020;
    static constexpr std::size_t least_dissected = 5;  // Wireshark leaves frames of four bytes alone: 07, 11, 12, 17

    void put_le16(unsigned word)
    {
        packets_.put(static_cast<char>(word & 0xFF));
        packets_.put(static_cast<char>(word >> 8 & 0xFF));
    }
    void put_le32(std::uint32_t word)
    {
        put_le16(word & 0xFFFF);
        put_le16(word >> 16);
    }
    void put_be16(std::size_t word)
    {
        packets_.put(static_cast<char>(word >> 8 & 0xFF));
        packets_.put(static_cast<char>(word & 0xFF));
    }

    std::ofstream packets_;
    std::ofstream expected_;
    std::size_t   client_port_ = 10'000;
};

//=== random values ===//

std::mt19937 generator;

std::size_t pick(std::size_t lowest, std::size_t highest)
{
    return std::uniform_int_distribution<std::size_t>{lowest, highest}(generator);
}

/// As `pick`; often one of the limits.
std::uint16_t pick_count(std::size_t highest)
{
    auto const kind = pick(0, 5);
    return static_cast<std::uint16_t>(kind == 0 ? 1 : kind == 1 ? highest : pick(1, highest));
}

std::uint16_t pick_word() { return static_cast<std::uint16_t>(pick(0, 0xFFFF)); }

/// A first address from which `count` do not pass the last one.
std::uint16_t pick_first(std::size_t count) { return static_cast<std::uint16_t>(pick(0, 0x10000 - count)); }

std::vector<std::uint16_t> pick_words(std::size_t count)
{
    std::vector<std::uint16_t> words(count);
    for (auto& word : words) { word = pick_word(); }
    return words;
}

std::vector<std::uint8_t> pick_bytes(std::size_t count)
{
    std::vector<std::uint8_t> some(count);
    for (auto& byte : some) { byte = static_cast<std::uint8_t>(pick(0, 0xFF)); }
    return some;
}

using numbers = std::vector<std::uint64_t>;

template <typename Range>
numbers as_numbers(Range const& range)
{
    numbers all;
    for (auto const value : range) { all.push_back(static_cast<std::uint64_t>(value)); }
    return all;
}

/// `count` numbers from `first` on.
numbers consecutive(std::size_t first, std::size_t count)
{
    numbers all(count);
    for (auto& number : all) { number = first++; }
    return all;
}

/// Bytes, or registers, as Wireshark prints a run of bytes.
template <typename Values>
std::string as_hex(Values const& values)
{
    std::string text;
    for (auto const value : values) {
        for (auto shift = 8 * static_cast<int>(sizeof value); shift > 0;) {
            shift -= 4;
            text += "0123456789abcdef"[value >> shift & 0xF];
        }
    }
    return text;
}

//=== exchanges ===//

capture* out = nullptr;

rtu::server_address server = 1;

template <modbus::message Message>
std::vector<std::uint8_t> frame_of(Message const& message)
{
    std::array<std::uint8_t, rtu::max_adu_size> buffer;
    auto const                                  made = rtu::encode(server, message, buffer);
    return {made->begin(), made->end()};
}

template <typename Request>
void request(Request const& asked, std::vector<field> fields)
{
    out->begin_exchange();
    server = *rtu::server_address::make(static_cast<std::uint8_t>(pick(1, 247)));
    out->add(direction::request, frame_of(asked), std::move(fields));
}

template <typename Response>
void response(Response const& given, std::vector<field> fields)
{
    out->add(direction::response, frame_of(given), std::move(fields));
}

/// The request once more, refused.
template <typename Request>
void exception(Request const& asked, std::vector<field> fields)
{
    request(asked, std::move(fields));
    auto const code = static_cast<modbus::exception_code>(std::array{1, 2, 3, 4, 5, 6, 8, 10, 11}[pick(0, 8)]);
    std::array<std::uint8_t, rtu::max_adu_size> buffer;

    auto const reply = rtu::serve(server, frame_of(asked), buffer, [&](Request const&) { return code; });
    out->add(direction::response, reply, {{"modbus.exception_code", {static_cast<std::uint64_t>(code)}}});
}

/// 01 and 02.
template <typename Function>
void read_bits()
{
    auto const count  = pick_count(2000);
    auto const first  = pick_first(modbus::coils::wire_size(count) * 8);  // Wireshark counts on past 65535
    using range       = decltype(Function::request::range);
    auto const asked  = typename Function::request{.range = range::from_checked(first, count)};
    auto const fields = std::vector<field>{{"modbus.reference_num", {first}}, {"modbus.bit_cnt", {count}}};
    request(asked, fields);

    auto const wire = pick_bytes(modbus::coils::wire_size(count));
    auto const view = modbus::coil_view::of_wire(wire, count);
    response(*Function::response::make(view), {{"modbus.byte_cnt", {wire.size()}},
                                               {"modbus.bitnum", consecutive(first, count)},
                                               {"modbus.bitval", as_numbers(view)}});
    exception(asked, fields);
}

/// 03 and 04.
template <typename Function>
void read_registers()
{
    auto const count  = pick_count(125);
    auto const first  = pick_first(count);
    using range       = decltype(Function::request::range);
    auto const asked  = typename Function::request{.range = range::from_checked(first, count)};
    auto const fields = std::vector<field>{{"modbus.reference_num", {first}}, {"modbus.word_cnt", {count}}};
    request(asked, fields);

    auto const values = pick_words(count);
    response(*Function::response::make(std::span{values}), {{"modbus.byte_cnt", {2 * values.size()}},
                                                            {"modbus.regnum16", consecutive(first, count)},
                                                            {"modbus.regval_uint16", as_numbers(values)}});
    exception(asked, fields);
}

void write_single_coil()
{
    auto const asked  = modbus::write_single_coil::request{.address = pick_word(), .value = pick(0, 1) == 1};
    auto const fields = std::vector<field>{{"modbus.reference_num", {asked.address}},
                                           {"modbus.data", {}, {asked.value ? "ff00" : "0000"}}};
    request(asked, fields);
    response(asked.reply(), fields);
    exception(asked, fields);
}

void write_single_register()
{
    auto const asked  = modbus::write_single_register::request{.address = pick_word(), .value = pick_word()};
    auto const fields = std::vector<field>{{"modbus.reference_num", {asked.address}},
                                           {"modbus.data", {}, {as_hex(std::array{asked.value})}}};
    request(asked, fields);
    response(asked.reply(), fields);
    exception(asked, fields);
}

void write_multiple_coils()
{
    auto const count = pick_count(1968);
    auto const first = pick_first(count);
    auto const wire  = pick_bytes(modbus::coils::wire_size(count));
    auto const view  = modbus::coil_view::of_wire(wire, count);
    auto const asked = *modbus::write_multiple_coils::request::make(first, view);
    auto       sent  = wire;
    view.write(sent);  // as the wire, but the unused bits of the last byte are 0
    request(asked, {{"modbus.reference_num", {first}},
                    {"modbus.bit_cnt", {count}},
                    {"modbus.byte_cnt", {wire.size()}},
                    {"modbus.data", {}, {as_hex(sent)}}});
    response(asked.reply(), {{"modbus.reference_num", {first}}, {"modbus.bit_cnt", {count}}});
}

void write_multiple_registers()
{
    auto const count  = pick_count(123);
    auto const first  = pick_first(count);
    auto const values = pick_words(count);
    auto const asked  = *modbus::write_multiple_registers::request::make(first, std::span{values});
    request(asked, {{"modbus.reference_num", {first}},
                    {"modbus.word_cnt", {count}},
                    {"modbus.byte_cnt", {2U * count}},
                    {"modbus.regnum16", consecutive(first, count)},
                    {"modbus.regval_uint16", as_numbers(values)}});
    response(asked.reply(), {{"modbus.reference_num", {first}}, {"modbus.word_cnt", {count}}});
}

void read_exception_status()
{
    request(modbus::read_exception_status::request{}, {});
    auto const outputs = static_cast<std::uint8_t>(pick(0, 0xFF));
    response(modbus::read_exception_status::response{.outputs = outputs},
             {{"modbus.data", {}, {as_hex(std::array{outputs})}}});
}

void diagnostics()
{
    static constexpr struct {
        modbus::diagnostic sub_function;
        std::string_view   name;
    } counters[] = {
        {modbus::diagnostic::return_diagnostic_register, "modbus.diagnostic.return_diag_register"},
        {modbus::diagnostic::return_bus_message_count, "modbus.diagnostic.bus_message_count"},
        {modbus::diagnostic::return_bus_communication_error_count, "modbus.diagnostic.bus_comm_error_count"},
        {modbus::diagnostic::return_bus_exception_error_count, "modbus.diagnostic.bus_exception_error_count"},
        {modbus::diagnostic::return_server_message_count, "modbus.diagnostic.slave_message_count"},
        {modbus::diagnostic::return_server_no_response_count, "modbus.diagnostic.no_slave_response_count"},
        {modbus::diagnostic::return_server_nak_count, "modbus.diagnostic.slave_nak_count"},
        {modbus::diagnostic::return_server_busy_count, "modbus.diagnostic.slave_busy_count"},
        {modbus::diagnostic::return_bus_character_overrun_count, "modbus.diagnostic.bus_char_overrun_count"},
    };
    static constexpr auto none = std::array<std::uint16_t, 1>{0};
    for (auto const& counter : counters) {
        auto const asked = *modbus::diagnostics::request::make(counter.sub_function, none);
        auto const code  = field{"modbus.diagnostic_code", {static_cast<std::uint64_t>(counter.sub_function)}};
        request(asked, {code});
        auto const value = std::array{pick_word()};
        response(*asked.reply_with(value), {code, {counter.name, {value[0]}}});
    }
    auto const words = pick_words(1);
    auto const asked = *modbus::diagnostics::request::make(modbus::diagnostic::return_query_data, std::span{words});
    request(asked,
            {{"modbus.diagnostic_code", {0}}, {"modbus.diagnostic.return_query_data.request", {}, {as_hex(words)}}});
    response(asked.reply(),
             {{"modbus.diagnostic_code", {0}}, {"modbus.diagnostic.return_query_data.echo", {}, {as_hex(words)}}});
}

/// One flag of all events of a kind.
numbers flags(bytes events, modbus::comm_event_kind kind, drivecodec::flag<modbus::comm_event> wanted)
{
    numbers states;
    for (auto const byte : events) {
        auto const event = modbus::comm_event::from_raw(byte);
        if (event.kind() == kind) { states.push_back(event.test(wanted) ? 1 : 0); }
    }
    return states;
}

void comm_events()
{
    using event = modbus::comm_event;
    using enum modbus::comm_event_kind;

    request(modbus::get_comm_event_counter::request{}, {});
    auto const busy  = pick(0, 1) == 1;
    auto const count = pick_word();
    response(modbus::get_comm_event_counter::response{.busy = busy, .event_count = count},
             {{"modbus.ev_status", {busy ? 0xFFFFU : 0U}}, {"modbus.ev_count", {count}}});

    request(modbus::get_comm_event_log::request{}, {});
    auto const events   = pick_bytes(pick(0, 64));
    auto const messages = pick_word();
    response(*modbus::get_comm_event_log::response::make(busy, count, messages, events),
             {{"modbus.byte_cnt", {6 + events.size()}},
              {"modbus.ev_status", {busy ? 0xFFFFU : 0U}},
              {"modbus.ev_count", {count}},
              {"modbus.ev_msg_count", {messages}},
              {"modbus.event", as_numbers(events)},
              {"modbus.ev_recv_comm_err", flags(events, receive, event::communication_error)},
              {"modbus.ev_recv_char_over", flags(events, receive, event::character_overrun)},
              {"modbus.ev_recv_lo_mode", flags(events, receive, event::in_listen_only_mode)},
              {"modbus.ev_recv_broadcast", flags(events, receive, event::broadcast_received)},
              {"modbus.ev_send_read_ex", flags(events, send, event::read_exception_sent)},
              {"modbus.ev_send_slave_abort_ex", flags(events, send, event::server_abort_exception_sent)},
              {"modbus.ev_send_slave_busy_ex", flags(events, send, event::server_busy_exception_sent)},
              {"modbus.ev_send_slave_nak_ex", flags(events, send, event::program_nak_exception_sent)},
              {"modbus.ev_send_write_timeout", flags(events, send, event::write_timeout)},
              {"modbus.ev_send_lo_mode", flags(events, send, event::in_listen_only_mode)}});
}

void report_server_id()
{
    request(modbus::report_server_id::request{}, {});
    auto const id         = pick_bytes(pick(1, 251));
    auto const byte_count = std::array{static_cast<std::uint8_t>(id.size())};
    response(*modbus::report_server_id::response::make(id),
             {{"modbus.data", {}, {as_hex(byte_count) + as_hex(id)}}});
}

/// File and record as Wireshark shows them.
std::uint64_t as_reference(modbus::file_record_range range)
{
    return std::uint64_t{range.file()} << 16 | range.record();
}

modbus::file_record_range pick_records(std::uint16_t count)
{
    auto const file = static_cast<std::uint16_t>(pick(1, 0xFFFF));
    return *modbus::file_record_range::make(file, static_cast<std::uint16_t>(pick(0, 10'000U - count)), count);
}

void read_file_record()
{
    constexpr auto                          most = modbus::read_file_record::max_response_byte_count;
    std::vector<modbus::file_record_range>  ranges;
    std::vector<std::vector<std::uint16_t>> values;
    numbers                                 types, references, counts, sizes{0};
    std::vector<std::string>                data;
    for (auto wanted = pick(1, 12); wanted > 0; --wanted) {
        auto const range = pick_records(pick_count(124));
        auto const size  = 2 + 2U * range.count();
        if (sizes.front() + size > most) { continue; }
        sizes.front() += size;
        ranges.push_back(range);
        values.push_back(pick_words(range.count()));
        data.push_back(as_hex(values.back()));
        types.push_back(6);
        references.push_back(as_reference(range));
        counts.push_back(range.count());
        sizes.push_back(size - 1);
    }
    auto const list = std::span<modbus::file_record_range const>{ranges};
    request(*modbus::read_file_record::request::make(list), {{"modbus.byte_cnt", {7 * ranges.size()}},
                                                             {"modbus.reference_type", types},
                                                             {"modbus.reference_num_32", references},
                                                             {"modbus.word_cnt", counts}});
    std::vector<modbus::file_values> sent;
    for (auto const& words : values) { sent.push_back(*modbus::file_values::make(std::span{words})); }
    response(*modbus::read_file_record::response::make(std::span<modbus::file_values const>{sent}),
             {{"modbus.byte_cnt", sizes}, {"modbus.reference_type", types}, {"modbus.data", {}, data}});
}

void write_file_record()
{
    std::vector<std::vector<std::uint16_t>> values;
    std::vector<modbus::file_record>        parts;
    numbers                                 types, references, counts;
    std::vector<std::string>                data;
    std::size_t                             total = 0;
    for (auto wanted = pick(1, 3); wanted > 0; --wanted) { values.push_back(pick_words(pick_count(38))); }
    for (auto const& words : values) {
        auto const range = pick_records(static_cast<std::uint16_t>(words.size()));
        parts.push_back(*modbus::file_record::make(range.file(), range.record(), std::span{words}));
        types.push_back(6);
        references.push_back(as_reference(range));
        counts.push_back(words.size());
        data.push_back(as_hex(words));
        total += 7 + 2 * words.size();
    }
    auto const fields = std::vector<field>{{"modbus.byte_cnt", {total}},
                                           {"modbus.reference_type", types},
                                           {"modbus.reference_num_32", references},
                                           {"modbus.word_cnt", counts},
                                           {"modbus.data", {}, data}};
    auto const asked  = *modbus::write_file_record::request::make(std::span<modbus::file_record const>{parts});
    request(asked, fields);
    response(asked.reply(), fields);
}

void mask_write_register()
{
    auto const asked =
        modbus::mask_write_register::request{.address = pick_word(), .and_mask = pick_word(), .or_mask = pick_word()};
    auto const fields = std::vector<field>{{"modbus.reference_num", {asked.address}},
                                           {"modbus.and_mask", {asked.and_mask}},
                                           {"modbus.or_mask", {asked.or_mask}}};
    request(asked, fields);
    response(asked.reply(), fields);
    exception(asked, fields);
}

void read_write_multiple_registers()
{
    using function         = modbus::read_write_multiple_registers;
    auto const read_count  = pick_count(125);
    auto const read_first  = pick_first(read_count);
    auto const write_count = pick_count(121);
    auto const write_first = pick_first(write_count);
    auto const written     = pick_words(write_count);
    auto const range       = function::range_to_read::from_checked(read_first, read_count);
    request(*function::request::make(range, write_first, std::span{written}),
            {{"modbus.read_reference_num", {read_first}},
             {"modbus.read_word_cnt", {read_count}},
             {"modbus.write_reference_num", {write_first}},
             {"modbus.write_word_cnt", {write_count}},
             {"modbus.byte_cnt", {2U * write_count}},
             {"modbus.data", {}, {as_hex(written)}}});
    auto const values = pick_words(read_count);
    response(*function::response::make(std::span{values}),
             {{"modbus.byte_cnt", {2U * read_count}}, {"modbus.data", {}, {as_hex(values)}}});
}

void read_fifo_queue()
{
    auto const address = pick_word();
    request(modbus::read_fifo_queue::request{.address = address}, {{"modbus.reference_num", {address}}});
    auto const values = pick_words(pick(0, 31));
    response(*modbus::read_fifo_queue::response::make(std::span{values}),
             {{"modbus.byte_cnt_16", {2 + 2 * values.size()}},
              {"modbus.word_cnt", {values.size()}},
              {"modbus.data", {}, values.empty() ? std::vector<std::string>{} : std::vector{as_hex(values)}}});
}

void read_device_identification()
{
    std::vector<std::string>           texts;
    std::vector<modbus::device_object> objects;
    numbers                            ids, sizes;
    for (auto const id : {0, 1, 2}) {
        std::string text;
        for (auto size = pick(1, 60); size > 0; --size) { text += static_cast<char>(pick('A', 'Z')); }
        texts.push_back(text);
        ids.push_back(static_cast<std::uint64_t>(id));
        sizes.push_back(text.size());
    }
    std::vector<std::vector<std::uint8_t>> owned;
    for (auto const& text : texts) { owned.emplace_back(text.begin(), text.end()); }
    for (std::size_t i = 0; i < owned.size(); ++i) {
        objects.push_back({static_cast<modbus::device_object_id>(i), owned[i]});
    }

    auto const asked = *modbus::read_device_identification::request::make(modbus::read_device_id_code::basic, {});
    request(asked, {{"modbus.mei", {14}}, {"modbus.read_device_id", {1}}, {"modbus.object_id", {0}}});
    response(
        *modbus::read_device_identification::answer(asked, modbus::device_conformity::extended_and_specific, objects),
        {{"modbus.mei", {14}},
         {"modbus.read_device_id", {1}},
         {"modbus.conformity_level", {0x83}},
         {"modbus.more_follows", {0}},
         {"modbus.next_object_id", {0}},
         {"modbus.num_objects", {3}},
         {"modbus.object_id", ids},
         {"modbus.objects_len", sizes},
         {"modbus.object_str_value", {}, texts}});
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 4) { return 2; }
    capture file{argv[1], argv[2]};
    out = &file;
    generator.seed(static_cast<std::mt19937::result_type>(std::stoul(argv[3])));
    for (auto round = 0; round < 8; ++round) {
        read_bits<modbus::read_coils>();
        read_bits<modbus::read_discrete_inputs>();
        read_registers<modbus::read_holding_registers>();
        read_registers<modbus::read_input_registers>();
        write_single_coil();
        write_single_register();
        read_exception_status();
        diagnostics();
        comm_events();
        write_multiple_coils();
        write_multiple_registers();
        report_server_id();
        read_file_record();
        write_file_record();
        mask_write_register();
        read_write_multiple_registers();
        read_fifo_queue();
        read_device_identification();
    }
    return 0;
}
