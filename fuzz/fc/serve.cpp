// Any bytes to a slave, with any room for the reply: it says what an independent look expects, byte for byte, or is
// silent; its handler is called as often as the telegram has something for it; no byte is written beside the reply; the
// master's check takes it as the reply to this request.
//
// Input: own ADR, the drive's manner (6 bytes), the room (2 bytes), the telegram.
#include "fc/drive.hpp"
#include "fc/rules.hpp"

#include <drivecodec/fc.hpp>

#include <vector>

namespace {

namespace fc = drivecodec::fc;
using drivecodec::bytes;
using drivecodec::errc;
using byte_list = std::vector<std::uint8_t>;

enum class kind { none, process, parameter, text };

/// What of a telegram to this slave it carries out.
template <typename Layout>
kind heard_as(unsigned own, bytes wire)
{
    constexpr auto process = 2 * Layout::process_words;
    if (rules::fault_of(wire, process, 252).code != errc::none) { return kind::none; }
    auto const adr = wire[2];
    if (not rules::is_broadcast(adr) and rules::slave_of(adr) != rules::slave_of(own)) { return kind::none; }
    auto const data = rules::data_of(wire);
    if (data.size() == process) { return kind::process; }
    if (data.size() >= process + 4 and rules::ak_of(data) == 0xF) { return kind::text; }
    return data.size() == process + 8 ? kind::parameter : kind::none;
}

void append(byte_list& list, bytes more)
{
    list.insert(list.end(), more.begin(), more.end());
}

void append_refusal(byte_list& reply, bytes asked, unsigned ak, std::uint32_t pwe)
{
    reply.push_back(static_cast<std::uint8_t>(ak << 4 | (asked[0] & 0x0F)));
    append(reply, asked.subspan(1, 3));
    for (int shift = 24; shift >= 0; shift -= 8) { reply.push_back(static_cast<std::uint8_t>(pwe >> shift)); }
}

/// The telegram that the drive sends back; nothing if it has no room.
template <typename Layout>
byte_list expected_reply(kind what, bytes wire, std::size_t room, fuzz_fc::drive<Layout> const& drive,
                         bool has_parameters)
{
    constexpr auto process = 2 * Layout::process_words;
    if (rules::is_broadcast(wire[2]) or room < 4 + 8 + process) { return {}; }
    auto const asked = rules::data_of(wire);
    byte_list  reply{0x02, 0x00, wire[2]};
    if (what == kind::parameter) {
        if (rules::ak_of(asked) == 0x0) {
            append_refusal(reply, asked, 0x0, 0);
        } else if (not has_parameters) {
            append_refusal(reply, asked, 0x7, 0);
        } else {
            append_refusal(reply, asked, drive.ak(), drive.pwe_sent());
        }
    } else if (what == kind::text) {
        auto const most = std::min(room, std::size_t{256}) - 4 - 4 - process;
        if (not has_parameters) {
            append_refusal(reply, asked, 0x7, 0);
        } else if (drive.refuses_text()) {
            append_refusal(reply, asked, 0x7, drive.refusal());
        } else if (drive.text().size() > most) {
            append_refusal(reply, asked, 0x7, 18);
        } else {
            append(reply, asked.first(4));
            append(reply, drive.text());
        }
    }
    for (std::size_t i = 0; i < process; ++i) { reply.push_back(static_cast<std::uint8_t>(0x0F + i)); }
    reply.push_back(0);
    reply[1] = static_cast<std::uint8_t>(reply.size() - 2);
    repair_bcc(reply);
    return reply;
}

/// The master that asked takes the reply, or the refusal in it.
template <typename Request>
void check_reply(bytes wire, bytes reply)
{
    auto const asked = fc::decode<Request>(wire);
    FUZZ_ASSERT(asked.has_value());
    auto const taken   = fc::check(asked->address, asked->data, reply);
    auto const ak      = rules::ak_of(rules::data_of(reply));
    auto const command = rules::ak_of(rules::data_of(wire));
    if constexpr (requires { asked->data.ind; }) {
        if (ak == 0x7) {
            FUZZ_ASSERT(not taken and taken.error().code() == errc::exception_reply);
            FUZZ_ASSERT(static_cast<unsigned>(taken.error().number()) == rules::word_at(rules::data_of(reply), 6));
            return;
        }
        FUZZ_ASSERT(taken.has_value() == rules::answers(ak, command));
        if (not taken) { FUZZ_ASSERT(taken.error().code() == errc::unexpected_reply); }
    } else {
        FUZZ_ASSERT(taken.has_value());
    }
    if (taken) { FUZZ_ASSERT(taken->wire_size() + 4 == reply.size()); }
}

/// `serve(buffer)` is what is tried.
template <typename Serve>
bytes serve_into(exact_buffer const& buffer, byte_list const& expected, Serve serve)
{
    std::fill(buffer.get().begin(), buffer.get().end(), std::uint8_t{0xA5});
    bytes const reply = serve(buffer.get());
    FUZZ_ASSERT(rules::is_same(reply, expected));
    if (not reply.empty()) { FUZZ_ASSERT(reply.data() == buffer.get().data()); }
    for (auto const byte : buffer.get().subspan(reply.size())) { FUZZ_ASSERT(byte == 0xA5); }
    return reply;
}

template <typename Layout>
void look_with(fuzz_input input)
{
    auto const             own = fc::address::from_byte(input.u8());
    fuzz_input             manner{input.take(6)};
    fuzz_fc::drive<Layout> drive{manner};
    auto const             room = input.u16();  // mostly as large as any reply
    exact_buffer const     buffer{room % 4 == 0 ? room / 4 % 260U : 256U};
    bytes const            wire = input.rest();

    auto const what = heard_as<Layout>(own.byte(), wire);
    auto const expected =
        what == kind::none ? byte_list{} : expected_reply(what, wire, buffer.get().size(), drive, true);
    auto const reply = serve_into(
        buffer, expected, [&](drivecodec::mutable_bytes out) { return fc::serve<Layout>(own, wire, out, drive); });

    FUZZ_ASSERT(drive.process_calls == (what == kind::none ? 0U : 1U));
    FUZZ_ASSERT(drive.text_calls == (what == kind::text ? 1U : 0U));
    auto const is_command = what == kind::parameter and rules::ak_of(rules::data_of(wire)) != 0x0;
    FUZZ_ASSERT(drive.parameter_calls == (is_command ? 1U : 0U));
    if (not reply.empty()) {
        if (what == kind::process) { check_reply<fc::basic_process_command<Layout>>(wire, reply); }
        if (what == kind::parameter) { check_reply<fc::basic_parameter_request<Layout>>(wire, reply); }
        if (what == kind::text) { check_reply<fc::basic_text_request<Layout>>(wire, reply); }
    }

    // The same without parameters; and from a reader, which slaves heed if it is an aligned request.
    fuzz_fc::drive_without_parameters<Layout> const without{drive.status()};
    auto const                                      refused =
        what == kind::none ? byte_list{} : expected_reply(what, wire, buffer.get().size(), drive, false);
    serve_into(buffer, refused,
               [&](drivecodec::mutable_bytes out) { return fc::serve<Layout>(own, wire, out, without); });
    for (auto const direction : {fc::direction::unknown, fc::direction::request, fc::direction::response}) {
        for (auto const aligned : {false, true}) {
            auto const      is_for_it = aligned and direction == fc::direction::request;
            fc::frame const whole{.raw = wire, .direction = direction, .aligned = aligned};
            serve_into(buffer, is_for_it ? refused : byte_list{},
                       [&](drivecodec::mutable_bytes out) { return fc::serve<Layout>(own, whole, out, without); });
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    look_with<fc::vlt_layout>({data, size});
    look_with<fc::data_layout<4, 12>>({data, size});
    return 0;
}

#ifdef FUZZ_ENGINE

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed)
{
    auto const mutated = LLVMFuzzerMutate(data, size, max_size);
    return repair_telegram(data, 9, mutated, max_size, seed, data[0]);
}

#endif
