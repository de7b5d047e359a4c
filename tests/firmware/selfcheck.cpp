// The library's own claims, checked on the processor it is made for: every vector of the tests that is a constant.
#include "firmware.hpp"

#include "support/exchanges.hpp"
#include "support/fc_vectors.hpp"
#include "support/modbus_vectors.hpp"

#include <drivecodec/cia402.hpp>
#include <drivecodec/fc.hpp>
#include <drivecodec/modbus.hpp>
#include <drivecodec/modbus/crc16/byte_table.hpp>
#include <drivecodec/modbus/crc16/carryless.hpp>
#include <drivecodec/modbus/crc16/nibble.hpp>
#include <drivecodec/smd.hpp>
#include <drivecodec/vlt6000.hpp>

namespace {

using drivecodec::bytes;
using drivecodec::same_bytes;
namespace cia402  = drivecodec::cia402;
namespace fc      = drivecodec::fc;
namespace vlt6000 = drivecodec::vlt6000;
namespace smd     = drivecodec::smd;
namespace modbus  = drivecodec::modbus;
namespace crc16   = drivecodec::modbus::crc16;
namespace rtu     = drivecodec::modbus::rtu;

int checks   = 0;
int failures = 0;

// The value itself, but unknown to the compiler, so that the check runs on the target.
template <typename T>
T opaque(T value) noexcept
{
    asm volatile("" : : "r"(&value) : "memory");
    return value;
}

void check(bool passed, char const* subject, char const* claim) noexcept
{
    ++checks;
    if (passed) { return; }
    ++failures;
    firmware::write("FAILED: ");
    firmware::write(subject);
    firmware::write(": ");
    firmware::write(claim);
    firmware::write("\n");
}

constexpr rtu::server_address server{17};

std::uint8_t frame_buffer[rtu::max_adu_size];
std::uint8_t other_buffer[rtu::max_adu_size];

/// The PDU in a frame, made without the library's messages.
bytes frame_of(bytes pdu) noexcept
{
    auto const size = pdu.size() + rtu::layout::adu::around;
    frame_buffer[0] = server.byte();
    drivecodec::copy_bytes(pdu, drivecodec::mutable_bytes{frame_buffer}.subspan(1));
    rtu::write_crc(drivecodec::mutable_bytes{frame_buffer}.first(size));
    return bytes{frame_buffer}.first(size);
}

//=== messages ===//

/// What is decoded is encoded again as it was; so is what is left when the end is missing, or it is refused.
template <typename Message>
void check_message(bytes pdu) noexcept
{
    auto const* const name = Message::function::name;
    for (auto size = pdu.size(); size > 0; --size) {
        auto const wire    = opaque(pdu.first(size));
        auto const decoded = drivecodec::decode<Message>(wire);
        if (not decoded) {
            check(size < pdu.size(), name, "decodes");
            continue;
        }
        auto const encoded = drivecodec::encode(*decoded, other_buffer);
        check(encoded and same_bytes(*encoded, wire), name, "encodes what it decoded");
    }

    auto const frame   = frame_of(opaque(pdu));
    auto const decoded = rtu::decode<Message>(frame);
    check(decoded and decoded->address == server, name, "decodes from a frame");
    if (decoded) {
        auto const encoded = rtu::encode(server, decoded->message, other_buffer);
        check(encoded and same_bytes(*encoded, frame), name, "encodes a frame");
    }
    frame_buffer[1] ^= 0x10;
    auto const damaged = rtu::decode<Message>(frame);
    check(not damaged, name, "refuses a damaged frame");
}

//=== CRC ===//

template <typename Algorithm>
void check_crc(char const* name) noexcept
{
    auto const crc = [](bytes data) { return crc16::compute<Algorithm>(opaque(data)); };
    check(crc(vectors::crc_check_input) == vectors::crc_check, name, "gives the check value");
    check(crc(vectors::xd1000_read_request) == crc16::residue, name, "agrees with a printed request");
    check(crc(vectors::xd1000_read_response) == crc16::residue, name, "agrees with a printed response");
    check(crc(vectors::xd1000_write_request) == crc16::residue, name, "agrees with a printed write");
    check(crc(vectors::introduction_read_request) == crc16::residue, name, "agrees with the usual example");
    for (std::size_t size = 0; size < sizeof frame_buffer; ++size) {
        frame_buffer[size] = static_cast<std::uint8_t>(151 * size + 7);
        auto const data    = bytes{frame_buffer}.first(size + 1);
        check(crc(data) == crc16::compute<crc16::bitwise>(data), name, "is that of bit by bit");
    }
}

//=== the stream reader ===//

rtu::reader reader;

void check_next_frame(char const* name, bytes expected, modbus::direction direction, bool aligned) noexcept
{
    auto const item  = reader.next();
    auto const frame = item.frame();
    check(frame != nullptr, name, "is found");
    if (frame == nullptr) { return; }
    check(same_bytes(frame->raw, expected), name, "is found whole");
    check(frame->direction == direction and frame->aligned == aligned, name, "is read as what it is");
}

template <typename Function>
void check_stream(exchanges::exchange<Function> const& one) noexcept
{
    for (auto const direction : {modbus::direction::request, modbus::direction::response}) {
        auto const frame = frame_of(opaque(direction == modbus::direction::request ? one.request : one.response));
        for (auto const byte : frame) { check(reader.push({&byte, 1}).empty(), Function::name, "is taken"); }
        reader.silence();
        check_next_frame(Function::name, frame, direction, true);
        check(not reader.next(), Function::name, "leaves nothing");
    }
}

void check_noise() noexcept
{
    constexpr std::array<std::uint8_t, 5> noise{0x11, 0x03, 0xFF, 0x42, 0x00};

    check(reader.push(opaque(bytes{noise})).empty(), "noise", "is taken");
    check(reader.push(opaque(bytes{vectors::introduction_read_request})).empty(), "noise", "is taken");
    reader.silence();
    auto const dropped = reader.next();
    check(dropped.dropped() != nullptr and same_bytes(dropped.dropped()->raw, noise), "noise", "is dropped");
    check_next_frame("noise", vectors::introduction_read_request, modbus::direction::request, false);
}

//=== client and server ===//

std::uint16_t registers[16];

struct holding_registers {
    using done          = modbus::answer<modbus::done>;
    using register_view = modbus::answer<modbus::register_view>;

    register_view operator()(modbus::read_holding_registers::request const& asked) const noexcept
    {
        return modbus::register_view{std::span{registers}.first(asked.range.count())};
    }
    register_view operator()(modbus::read_write_multiple_registers::request const& asked) const noexcept
    {
        asked.write_block.values().copy_to(registers);
        return modbus::register_view{std::span{registers}.first(asked.read_range.count())};
    }
    done operator()(modbus::write_single_register::request const& asked) const noexcept
    {
        registers[0] = asked.value;
        return modbus::done{};
    }
    done operator()(modbus::write_multiple_registers::request const& asked) const noexcept
    {
        asked.block.values().copy_to(registers);
        return modbus::done{};
    }
    done operator()(modbus::mask_write_register::request const&) const noexcept
    {
        return modbus::exception_code::illegal_data_address;
    }
};

/// A request reaches the server, and the client takes its reply for what it is.
template <typename Function>
void check_exchange(exchanges::exchange<Function> const& one) noexcept
{
    using request = typename Function::request;

    auto const asked    = request::read(opaque(one.request));
    auto const reply    = rtu::serve(server, frame_of(one.request), other_buffer, holding_registers{});
    auto const response = rtu::check(server, asked, reply);
    if constexpr (std::is_same_v<Function, modbus::mask_write_register>) {
        check(response.error() == modbus::reply_error{modbus::exception_code::illegal_data_address}, Function::name,
              "is refused as the handler says");
    } else if constexpr (std::is_invocable_v<holding_registers const&, request const&>) {
        check(response.has_value(), Function::name, "is answered");
    } else {
        check(response.error() == modbus::reply_error{modbus::exception_code::illegal_function}, Function::name,
              "is not served");
    }
}

//=== CiA 402 ===//

/// The state by the masks of the standard, or -1.
int state_by_masks(unsigned word) noexcept
{
    switch (word & 0x4FU) {
    case 0x00: return 0;
    case 0x40: return 1;
    case 0x0F: return 6;
    case 0x08: return 7;
    default: break;
    }
    switch (word & 0x6FU) {
    case 0x21: return 2;
    case 0x23: return 3;
    case 0x27: return 4;
    case 0x07: return 5;
    default: return -1;
    }
}

void check_states() noexcept
{
    bool agree = true;
    for (unsigned word = 0; word <= 0xFFFF; ++word) {
        auto const found =
            cia402::decode_state(cia402::status_word::from_raw(static_cast<std::uint16_t>(opaque(word))));
        agree = agree and (found ? static_cast<int>(*found) : -1) == state_by_masks(word);
    }
    check(agree, "decode_state", "is what the standard's masks say");
}

/// A controller takes a drive from power-on to every goal, over a fault, by the words of the path.
void check_state_machine() noexcept
{
    using cia402::progress;
    using cia402::state;

    for (unsigned number = 1; number <= 4; ++number) {
        auto const goal = static_cast<state>(opaque(number));

        cia402::machine drive;
        drive.fault();
        auto const whole = cia402::path::between(drive.state(), goal);
        check(whole.has_value(), "path", "leads out of a fault");

        cia402::controller control;
        control.set_goal(goal);
        control.reset_fault();
        std::size_t words = 0;
        auto        says  = control.update(drive.status());
        while (says == progress::waiting) {
            ++words;
            drive.receive(control.word());
            drive.fault_handled();
            says = control.update(drive.status());
        }
        check(says == progress::reached and drive.state() == goal, "controller", "reaches its goal");
        check(whole and words == whole->size() + 1, "controller",
              "needs a word for each transition, two for the reset");
    }
}

//=== FC ===//

/// Is `wire` a telegram of `Data`? If so, it is encoded again as it was.
template <typename Data>
bool is_fc_telegram_of(bytes wire) noexcept
{
    auto const decoded = fc::decode<Data>(opaque(wire));
    if (not decoded) { return false; }
    auto const encoded = fc::encode(decoded->address, decoded->data, drivecodec::mutable_bytes{other_buffer});
    check(encoded and same_bytes(*encoded, wire), "FC telegram", "encodes what it decoded");
    return true;
}

/// Of how many kinds a telegram is.
int fc_kinds_of(bytes wire) noexcept
{
    return is_fc_telegram_of<fc::process_command>(wire) + is_fc_telegram_of<fc::parameter_request>(wire)
           + is_fc_telegram_of<fc::text_request>(wire);
}

void check_fc_telegram(bytes telegram) noexcept
{
    constexpr char const* name = "FC telegram";

    check(fc_kinds_of(telegram) == 1, name, "is of one kind");
    for (std::size_t size = 0; size < telegram.size(); ++size) {
        check(fc_kinds_of(telegram.first(size)) == 0, name, "is refused if its end is missing");
    }
    auto const damaged = bytes{frame_buffer}.first(telegram.size());
    for (std::size_t bit = 0; bit < 8 * telegram.size(); ++bit) {
        drivecodec::copy_bytes(telegram, frame_buffer);
        frame_buffer[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
        check(fc_kinds_of(damaged) == 0, name, "is refused if a bit is wrong");
    }
}

// As small as can be: it lies on the stack.
using fc_reader = fc::basic_reader<fc::vlt_layout, fc::max_telegram_size + 2>;

void check_fc_stream(fc_reader& line, bytes telegram) noexcept
{
    for (auto const byte : telegram) { check(line.push({&byte, 1}).empty(), "FC stream", "is taken"); }
    line.silence();
    auto const item = line.next();
    check(item.frame() != nullptr and same_bytes(item.frame()->raw, telegram), "FC stream", "is found whole");
    check(not line.next(), "FC stream", "leaves nothing");
}

/// Answers as the drive of the examples.
struct fc_drive {
    fc::process_status operator()(fc::process_command const&) const noexcept
    {
        return {0x0F03, fc::output_frequency::from_raw(0x2000)};
    }
    fc::parameter_answer operator()(fc::parameter_request const& asked) const noexcept
    {
        switch (asked.number()) {
        case 206: return fc::parameter_answer::value(std::uint16_t{10});
        case 615: return fc::parameter_answer::value(std::uint8_t{13});
        case 501: return fc::parameter_error::no_bus_access;
        default: break;
        }
        auto const written = asked.value<std::uint32_t>();
        if (written) { return fc::parameter_answer::value(*written); }
        return fc::parameter_answer::value(asked.value<std::uint16_t>().value_or(0));
    }
    fc::text_answer operator()(fc::text_request const&) const noexcept
    {
        static constexpr std::array<std::uint8_t, 7> text{'V', 'L', 'T', '6', '0', '0', '0'};
        return bytes{text};
    }
};

/// A request reaches the slave, which answers as the manual has it, and the master takes its reply for what it is.
template <typename Request>
void check_fc_exchange(bytes request, bytes response, fc::reply_error refusal = drivecodec::error{}) noexcept
{
    auto const asked = fc::decode<Request>(opaque(request));
    check(asked.has_value(), "FC request", "decodes");
    if (not asked) { return; }
    auto const reply = fc::serve(asked->address, opaque(request), other_buffer, fc_drive{});
    check(same_bytes(reply, response), "FC request", "is answered");
    auto const answer = fc::check(asked->address, asked->data, reply);
    check(refusal.ok() ? answer.has_value() : not answer and answer.error() == refusal, "FC response",
          "is what it is for the master");
}

void check_fc() noexcept
{
    fc_reader line;
    for (auto const telegram : vectors::all_fc) {
        check_fc_telegram(telegram);
        check_fc_stream(line, telegram);
    }
    check_fc_exchange<fc::process_command>(vectors::forwards_to_22, vectors::status_of_22);
    check_fc_exchange<fc::parameter_request>(vectors::read_206, vectors::read_206_response);
    check_fc_exchange<fc::parameter_request>(vectors::write_202, vectors::write_202_response);
    check_fc_exchange<fc::parameter_request>(vectors::write_415, vectors::write_415_response);
    check_fc_exchange<fc::parameter_request>(vectors::read_615_1, vectors::read_615_1_response);
    check_fc_exchange<fc::parameter_request>(vectors::write_291_1, vectors::write_291_1_response);
    check_fc_exchange<fc::parameter_request>(vectors::write_501, vectors::write_501_response,
                                             fc::parameter_error::no_bus_access);
    check_fc_exchange<fc::text_request>(vectors::read_621, vectors::read_621_response);
}

/// The typed parameters of a drive; and what takes 64 bits, of which these processors have none.
void check_vlt6000() noexcept
{
    using vlt6000::parameter;
    using hertz = drivecodec::quantity<drivecodec::unit::hertz>;

    auto const asked = fc::decode<fc::parameter_request>(vectors::write_202);
    auto const made =
        parameter<202>.make_write(opaque(hertz{1000, -1}), fc::storage::ram_and_eeprom, asked->data.process);
    check(made and *made == asked->data, "VLT 6000", "writes 100 Hz as the manual does");
    check(not parameter<202>.make_write(opaque(hertz{5005, -2}), fc::storage::ram, fc::data_not_valid), "VLT 6000",
          "refuses a digit too many");
    auto const given = fc::decode<fc::parameter_response>(vectors::write_202_response);
    check(*parameter<202>.value(given->data) == hertz{100, 0}, "VLT 6000", "reads 100 Hz");

    for (unsigned raw = 0; raw <= 0xFFFF; raw += 0x101) {
        auto const reference = fc::reference::from_raw(static_cast<std::uint16_t>(raw));
        auto const percent   = reference.percent();
        check(percent and *fc::reference::make(*percent) == reference, "a reference", "comes back from percent");
        auto const frequency = reference.frequency(hertz{}, hertz{50, 0});
        check(frequency and *fc::reference::make(*frequency, hertz{}, hertz{50, 0}) == reference, "a reference",
              "comes back from hertz");
    }
}

/// The status block and a parameter of the smd, and its controller up to the start.
void check_smd() noexcept
{
    using hertz = drivecodec::quantity<drivecodec::unit::hertz>;

    static constexpr std::array<std::uint16_t, 6> words{0x0201, 0x0201, 0x6406, 0x000A, 0x0600, 0x0000};
    auto const                                    status = smd::status_block::from_words(words);
    check(status.actual_speed == hertz{513, -1} and status.load.number == 100, "smd", "runs at 51.3 Hz, fully loaded");
    auto const again = status.make_words();
    check(again and again->words == words, "smd", "has the same six words again");

    auto const map   = smd::map::make(opaque(std::uint16_t{507}));
    auto const write = map ? map->make_write("C12", {50, -1}) : map.error();
    check(write and write->address == 61 and write->value == 50, "smd", "has C12 at 61 in tenths of seconds");
    check(not smd::map::make(opaque(std::uint16_t{401})), "smd", "writes nothing to an unknown version");

    smd::controller control;
    check(control.run(smd::direction::forward, opaque(hertz{412, -1})).ok(), "smd", "takes 41.2 Hz");
    check(control.next().what != smd::step::start, "smd", "is not started first");
}

}  // namespace

int main()
{
    exchanges::for_each([](auto const& one) {
        using function = typename std::remove_cvref_t<decltype(one)>::function;
        check_message<typename function::request>(one.request);
        check_message<typename function::response>(one.response);
        check_stream(one);
        check_exchange(one);
    });
    check(registers[0] == 0x00FF and registers[1] == 0x00FF, "the registers", "hold what was written last");
    check_noise();

    check_states();
    check_state_machine();

    check_fc();
    check_vlt6000();
    check_smd();

    check_crc<crc16::bitwise>("bitwise");
    check_crc<crc16::nibble>("nibble");
    check_crc<crc16::byte_table>("byte_table");
    check_crc<crc16::slices>("slices");
    check_crc<crc16::carryless>("carryless");

    check(checks > 5000, "the self-check", "has checked everything");
    firmware::write(failures == 0 ? "selfcheck passed\n" : "selfcheck FAILED\n");
    return failures;
}
