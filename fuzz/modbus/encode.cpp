// Messages built from fields by `make`, beside the same bytes written by hand: `make` refuses what `check` refuses and what
// the rules refuse, and else the wire form is those bytes, in a buffer of exactly their size, and decodes to the same value.
//
// Input: which message, its fields.
#include "input.hpp"
#include "modbus/message_oracle.hpp"

#include <vector>

using namespace oracle;

namespace {

using drivecodec::result;
using modbus::coil_view;
using modbus::register_view;

/// Bytes written by hand.
class wire_form {
public:
    wire_form& u8(std::size_t byte)
    {
        bytes_.push_back(static_cast<std::uint8_t>(byte));
        return *this;
    }
    wire_form& u16(std::size_t word) { return u8(word >> 8).u8(word); }
    wire_form& words(std::span<std::uint16_t const> all)
    {
        for (auto const word : all) { u16(word); }
        return *this;
    }
    wire_form& coils(std::span<bool const> all)
    {
        for (std::size_t i = 0; i < all.size(); i += 8) {
            unsigned byte = 0;
            for (std::size_t bit = 0; bit < 8 and i + bit < all.size(); ++bit) { byte |= (all[i + bit] ? 1U : 0U) << bit; }
            u8(byte);
        }
        return *this;
    }
    wire_form& raw(bytes all)
    {
        bytes_.insert(bytes_.end(), all.begin(), all.end());
        return *this;
    }

    /// On the heap, exactly so many bytes.
    [[nodiscard]] exact_buffer exact() const
    {
        exact_buffer made{bytes_.size()};
        drivecodec::copy_bytes(bytes_, made.get());
        return made;
    }

private:
    std::vector<std::uint8_t> bytes_;
};

/// `valid` is false for what the rules allow and a device's own limit does not. A response of coils does not say how many.
template <typename Message>
void expect(result<Message> const& made, wire_form const& by_hand, bool valid = true, bool decodes_equal = true)
{
    using function        = typename Message::function;
    constexpr auto is_request = std::is_same_v<Message, typename function::request>;
    auto const wire       = by_hand.exact();
    bytes const pdu       = wire.get();
    valid                 = valid and (is_request ? rules::is_request(pdu) : rules::is_response(pdu));
    FUZZ_ASSERT(made.has_value() == valid);
    FUZZ_ASSERT(Message::check(pdu).ok() == valid);
    if (not made) { return; }
    FUZZ_ASSERT(made->wire_size() == pdu.size());
    FUZZ_ASSERT(rules::is_same(encode_exactly(*made).get(), pdu));
    auto const decoded = drivecodec::decode<Message>(pdu);
    FUZZ_ASSERT(decoded and (not decodes_equal or *decoded == *made));
}

/// A message without a condition, which no `make` refuses.
template <typename Message>
void expect_value(Message const& message, wire_form const& by_hand)
{
    expect(result<Message>{message}, by_hand);
}

//=== values on the heap, exactly as many as there are ===//

template <typename T>
[[nodiscard]] exact_array<T> some(fuzz_input& input, std::size_t limit)
{
    exact_array<T> values{input.below(limit)};
    for (auto& each : values.get()) { each = static_cast<T>(sizeof(T) == 2 ? input.u16() : input.u8() % 2); }
    return values;
}

[[nodiscard]] exact_buffer some_bytes(fuzz_input& input, std::size_t limit)
{
    auto const   given = input.take(input.below(limit));
    exact_buffer values{given.size()};
    drivecodec::copy_bytes(given, values.get());
    return values;
}

/// The same registers as host words and as bytes of the wire.
class registers {
public:
    registers(fuzz_input& input, std::size_t limit) : words_{some<std::uint16_t>(input, limit)}, wire_{2 * words_.get().size()}
    {
        drivecodec::store_be16(words_.get(), wire_.get());
    }
    [[nodiscard]] std::span<std::uint16_t const> words() const { return words_.get(); }
    [[nodiscard]] std::size_t                    size() const { return words_.get().size(); }
    [[nodiscard]] register_view                  host() const { return words(); }
    [[nodiscard]] register_view                  wire() const { return register_view::of_wire(wire_.get()); }

private:
    exact_array<std::uint16_t> words_;
    exact_buffer               wire_;
};

//=== requests ===//

template <typename Function>
void expect_read(fuzz_input& input, std::size_t most = 2000)
{
    using request    = typename Function::request;
    using range      = decltype(request::range);
    auto const first = input.u16();
    auto const count = input.u16();
    auto const made  = range::make(first, count);
    auto const hand  = wire_form{}.u8(modbus::to_byte(Function::code)).u16(first).u16(count);
    expect(made ? result<request>{request{.range = *made}} : result<request>{made.error()}, hand, count <= most);
}

template <typename Function>
void expect_write_registers(fuzz_input& input, std::size_t limit, std::size_t most)
{
    using request    = typename Function::request;
    auto const first = input.u16();
    registers  values{input, limit};
    auto const hand  = wire_form{}.u8(0x10).u16(first).u16(values.size()).u8(2 * values.size()).words(values.words());
    for (auto const view : {values.host(), values.wire()}) {
        auto const made = request::make(first, view);
        expect(made, hand, values.size() <= most);
        if (not made) { continue; }
        using response = typename Function::response;
        expect_value<response>(made->reply(), wire_form{}.u8(0x10).u16(first).u16(values.size()));
        FUZZ_ASSERT(made->matches(made->reply()).ok());
    }
}

void expect_write_coils(fuzz_input& input)
{
    using request     = modbus::write_multiple_coils::request;
    auto const first  = input.u16();
    auto const values = some<bool>(input, 2100);
    auto const count  = values.get().size();
    auto const packed = wire_form{}.coils(values.get()).exact();
    auto const hand   = wire_form{}.u8(0x0F).u16(first).u16(count).u8(packed.get().size()).coils(values.get());
    // What lies in the unused bits of the last byte does not matter.
    if (count % 8 != 0) { packed.get().back() = static_cast<std::uint8_t>(packed.get().back() | (0xFFU << (count % 8))); }
    expect(request::make(first, std::span<bool const>{values.get()}), hand);
    expect(request::make(first, coil_view::of_wire(packed.get(), count)), hand);
}

void expect_read_write(fuzz_input& input)
{
    using function        = modbus::read_write_multiple_registers;
    auto const read_first = input.u16();
    auto const read_count = input.u16();
    auto const first      = input.u16();
    registers  values{input, 130};
    auto const range = function::range_to_read::make(read_first, read_count);
    auto const hand  = wire_form{}.u8(0x17).u16(read_first).u16(read_count).u16(first).u16(values.size())
                          .u8(2 * values.size()).words(values.words());
    for (auto const view : {values.host(), values.wire()}) {
        expect(range ? function::request::make(*range, first, view) : result<function::request>{range.error()}, hand);
    }
}

void expect_diagnostics(fuzz_input& input)
{
    std::size_t const sub = input.u8() % 4 == 0 ? input.u16() : input.below(24);
    registers  words{input, 130};
    auto const hand = wire_form{}.u8(0x08).u16(sub).words(words.words());
    for (auto const view : {words.host(), words.wire()}) {
        auto const code = static_cast<modbus::diagnostic>(sub);
        auto const made = modbus::diagnostics::request::make(code, view);
        expect(made, hand);
        expect(modbus::diagnostics::response::make(code, view), hand);
        if (made and modbus::diagnostics::echoes_data(code)) {
            expect_value<modbus::diagnostics::response>(made->reply(), hand);
            FUZZ_ASSERT(made->matches(made->reply()).ok());
        }
    }
}

void expect_read_file(fuzz_input& input)
{
    using request = modbus::read_file_record::request;
    std::vector<modbus::file_record_range> ranges;
    wire_form  records;
    auto const count    = input.below(38);
    auto       are_made = true;
    for (std::size_t i = 0; i < count; ++i) {
        auto const file   = input.u16();
        auto const record = input.u16();
        std::size_t const length = input.u8() % 8 == 0 ? input.u16() : input.u8();
        auto const made   = modbus::file_record_range::make(file, record, static_cast<std::uint16_t>(length));
        records.u8(6).u16(file).u16(record).u16(length);
        are_made = are_made and made;
        if (made) { ranges.push_back(*made); }
    }
    auto const hand = wire_form{}.u8(0x14).u8(7 * count).raw(records.exact().get());
    auto const made = request::make(std::span<modbus::file_record_range const>{ranges});
    expect(are_made ? made : result<request>{error{errc::bad_quantity, 0}}, hand);
}

void expect_write_file(fuzz_input& input)
{
    using request = modbus::write_file_record::request;
    std::vector<registers>           values;
    std::vector<modbus::file_record> list;
    wire_form                        records;
    auto are_made = true;
    for (auto left = input.below(30); left > 0; --left) {
        auto const file   = input.u16();
        auto const record = input.u16();
        values.emplace_back(input, 130);
        auto const made = modbus::file_record::make(file, record, values.back().host());
        records.u8(6).u16(file).u16(record).u16(values.back().size()).words(values.back().words());
        are_made = are_made and made;
        if (made) { list.push_back(*made); }
    }
    auto const wire = records.exact();
    auto const hand = wire_form{}.u8(0x15).u8(wire.get().size()).raw(wire.get());
    auto const made = request::make(std::span<modbus::file_record const>{list});
    expect(are_made ? made : result<request>{error{errc::bad_quantity, 0}}, hand);
    if (are_made and made) { expect_value<modbus::write_file_record::response>(made->reply(), hand); }
}

//=== responses ===//

template <typename Function>
void expect_registers(fuzz_input& input, std::size_t most = 125)
{
    using response = typename Function::response;
    registers  values{input, 135};
    auto const hand = wire_form{}.u8(modbus::to_byte(Function::code)).u8(2 * values.size()).words(values.words());
    expect(response::make(values.host()), hand, values.size() <= most);
    expect(response::make(values.wire()), hand, values.size() <= most);
}

template <typename Function>
void expect_coils(fuzz_input& input)
{
    using response    = typename Function::response;
    auto const values = some<bool>(input, 2100);
    auto const packed = wire_form{}.coils(values.get()).exact();
    auto const count  = values.get().size();
    auto const hand   = wire_form{}.u8(modbus::to_byte(Function::code)).u8(packed.get().size()).coils(values.get());
    expect(response::make(std::span<bool const>{values.get()}), hand, true, count % 8 == 0);
    expect(response::make(coil_view::of_wire(packed.get(), count)), hand, true, count % 8 == 0);
}

void expect_read_file_response(fuzz_input& input)
{
    using response = modbus::read_file_record::response;
    std::vector<registers>           values;
    std::vector<modbus::file_values> list;
    wire_form                        records;
    auto are_made = true;
    for (auto left = input.below(70); left > 0; --left) {
        values.emplace_back(input, 130);
        auto const made = modbus::file_values::make(values.back().host());
        records.u8(1 + 2 * values.back().size()).u8(6).words(values.back().words());
        are_made = are_made and made;
        if (made) { list.push_back(*made); }
    }
    auto const wire = records.exact();
    auto const hand = wire_form{}.u8(0x14).u8(wire.get().size()).raw(wire.get());
    auto const made = response::make(std::span<modbus::file_values const>{list});
    expect(are_made ? made : result<response>{error{errc::bad_quantity, 0}}, hand);
}

void expect_fifo(fuzz_input& input)
{
    using response = modbus::read_fifo_queue::response;
    registers  values{input, 40};
    auto const hand = wire_form{}.u8(0x18).u16(2 + 2 * values.size()).u16(values.size()).words(values.words());
    expect(response::make(values.host()), hand);
    expect(response::make(values.wire()), hand);
}

void expect_events(fuzz_input& input)
{
    auto const is_busy  = input.u8() % 2 != 0;
    auto const counted  = input.u16();
    auto const messages = input.u16();
    auto const status   = is_busy ? 0xFFFFU : 0U;
    auto const events   = some_bytes(input, 80);
    expect(modbus::get_comm_event_log::response::make(is_busy, counted, messages, events.get()),
           wire_form{}.u8(0x0C).u8(6 + events.get().size()).u16(status).u16(counted).u16(messages).raw(events.get()));
    expect_value(modbus::get_comm_event_counter::response{.busy = is_busy, .event_count = counted},
                 wire_form{}.u8(0x0B).u16(status).u16(counted));
}

void expect_bytes(fuzz_input& input)
{
    auto const payload = some_bytes(input, 260);
    bytes const data   = payload.get();
    expect(modbus::report_server_id::response::make(data), wire_form{}.u8(0x11).u8(data.size()).raw(data));
    auto const canopen = wire_form{}.u8(0x2B).u8(0x0D).raw(data);
    expect(modbus::canopen_general_reference::request::make(data), canopen);
    expect(modbus::canopen_general_reference::response::make(data), canopen);
}

/// A device's objects, asked for response by response as a client does: each object once, in order.
void expect_identification(fuzz_input& input)
{
    using function        = modbus::read_device_identification;
    auto const conformity = static_cast<modbus::device_conformity>(input.u8());
    auto const level      = static_cast<std::uint8_t>(conformity);
    std::size_t const code = input.u8() % 6U;
    auto const first      = input.u8();
    auto const count      = input.below(40);

    std::vector<exact_buffer>          values;
    std::vector<modbus::device_object> objects;
    unsigned                           id = 0;
    for (std::size_t i = 0; i < count and id < 256; ++i) {
        values.push_back(some_bytes(input, 256));
        objects.push_back({.id = static_cast<modbus::device_object_id>(id), .value = values.back().get()});
        id += 1U + input.u8() % 40U;
    }

    auto asked = function::request::make(static_cast<modbus::read_device_id_code>(code),
                                         static_cast<modbus::device_object_id>(first));
    expect(asked, wire_form{}.u8(0x2B).u8(0x0E).u8(code).u8(first));
    if (not asked) { return; }

    std::size_t next = 0;
    while (next < objects.size() and static_cast<unsigned>(objects[next].id) != first) { ++next; }
    if (next == objects.size()) { next = 0; }  // an unknown object: from the first one on
    auto const category = code < (level & 0x7F) ? static_cast<std::uint8_t>(code) : static_cast<std::uint8_t>(level & 0x7F);
    auto const last     = code == 4 or category >= 3 ? 0xFFU : category == 2 ? 0x7FU : 0x02U;
    if (code != 4 and not objects.empty() and static_cast<unsigned>(objects[next].id) > last) { next = 0; }

    for (int responses = 0;; ++responses) {
        FUZZ_ASSERT(responses <= 40);
        auto const given = function::answer(*asked, conformity, objects);
        if (not given) {
            auto const is_there = not objects.empty() and static_cast<unsigned>(objects[next].id) == first;
            if (code == 4 and level < 0x80) {
                FUZZ_ASSERT(given.error() == modbus::exception_code::illegal_data_value);
            } else if (code == 4 and not is_there) {
                FUZZ_ASSERT(given.error() == modbus::exception_code::illegal_data_address);
            } else {
                FUZZ_ASSERT(given.error() == modbus::exception_code::server_device_failure);
                FUZZ_ASSERT(next < objects.size() and objects[next].value.size() > 244);
            }
            return;
        }
        FUZZ_ASSERT(asked->matches(*given).ok());
        auto const number = given->objects().size();
        wire_form  hand;
        hand.u8(0x2B).u8(0x0E).u8(code).u8(level).u8(given->more_follows() ? 0xFF : 0);
        hand.u8(static_cast<std::size_t>(given->next_object_id())).u8(number);
        for (std::size_t i = 0; i < number; ++i) {
            FUZZ_ASSERT(next < objects.size() and static_cast<unsigned>(objects[next].id) <= last);
            hand.u8(static_cast<std::size_t>(objects[next].id)).u8(objects[next].value.size()).raw(objects[next].value);
            ++next;
        }
        expect_value(*given, hand);
        auto const is_end = next == objects.size() or static_cast<unsigned>(objects[next].id) > last;
        FUZZ_ASSERT(given->more_follows() == (code != 4 and not is_end));
        FUZZ_ASSERT(given->more_follows() or static_cast<unsigned>(given->next_object_id()) == 0);
        if (not given->more_follows()) { return; }
        FUZZ_ASSERT(number > 0 and given->next_object_id() == objects[next].id);
        asked = function::request::make(static_cast<modbus::read_device_id_code>(code), given->next_object_id());
        FUZZ_ASSERT(asked.has_value());
    }
}

void expect_single(fuzz_input& input)
{
    auto const address = input.u16();
    auto const value   = input.u16();
    auto const mask    = input.u16();
    auto const is_on   = value % 2 != 0;
    auto const coil    = modbus::write_single_coil::request{.address = address, .value = is_on};
    auto const by_hand = wire_form{}.u8(0x05).u16(address).u16(is_on ? 0xFF00U : 0U);
    expect_value(coil, by_hand);
    expect_value<modbus::write_single_coil::response>(coil.reply(), by_hand);

    auto const one = modbus::write_single_register::request{.address = address, .value = value};
    expect_value(one, wire_form{}.u8(0x06).u16(address).u16(value));
    expect_value<modbus::write_single_register::response>(one.reply(), wire_form{}.u8(0x06).u16(address).u16(value));

    auto const masked = modbus::mask_write_register::request{.address = address, .and_mask = value, .or_mask = mask};
    expect_value(masked, wire_form{}.u8(0x16).u16(address).u16(value).u16(mask));
    auto const current = input.u16();
    for (unsigned bit = 0; bit < 16; ++bit) {
        auto const from = (value >> bit & 1U) != 0 ? current : mask;
        FUZZ_ASSERT((masked.apply(current) >> bit & 1U) == (static_cast<unsigned>(from) >> bit & 1U));
    }

    expect_value(modbus::read_fifo_queue::request{.address = address}, wire_form{}.u8(0x18).u16(address));
    auto const outputs = input.u8();
    expect_value(modbus::read_exception_status::response::make(outputs), wire_form{}.u8(0x07).u8(outputs));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    fuzz_input input{data, size};
    switch (input.u8() % 24) {
    case 0: expect_read<modbus::read_coils>(input); break;
    case 1: expect_read<modbus::read_discrete_inputs>(input); break;
    case 2: expect_read<modbus::read_holding_registers>(input); break;
    case 3: expect_read<modbus::read_input_registers>(input); break;
    case 4: expect_read<modbus::basic_read_holding_registers<63>>(input, 63); break;
    case 5: expect_single(input); break;
    case 6: expect_diagnostics(input); break;
    case 7: expect_write_coils(input); break;
    case 8: expect_write_registers<modbus::write_multiple_registers>(input, 130, 123); break;
    case 9: expect_write_registers<modbus::basic_write_multiple_registers<4>>(input, 8, 4); break;
    case 10: expect_read_write(input); break;
    case 11: expect_read_file(input); break;
    case 12: expect_write_file(input); break;
    case 13: expect_identification(input); break;
    case 14: expect_coils<modbus::read_coils>(input); break;
    case 15: expect_coils<modbus::read_discrete_inputs>(input); break;
    case 16: expect_registers<modbus::read_holding_registers>(input); break;
    case 17: expect_registers<modbus::read_input_registers>(input); break;
    case 18: expect_registers<modbus::read_write_multiple_registers>(input); break;
    case 19: expect_registers<modbus::basic_read_holding_registers<63>>(input, 63); break;
    case 20: expect_read_file_response(input); break;
    case 21: expect_fifo(input); break;
    case 22: expect_events(input); break;
    case 23: expect_bytes(input); break;
    default: break;
    }
    return 0;
}
