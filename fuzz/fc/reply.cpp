// Any request, and any bytes as its reply, or a drive's reply with one byte changed: the master takes what answers the
// request by the rules, and nothing else.
//
// Input: ADR, the kind of request and whether the reply is the drive's, PKE, IND, PWE (or so many characters), the
// drive's manner (6 bytes), where and how to change the reply (2 bytes), the reply.
#include "fc/drive.hpp"
#include "fc/rules.hpp"

#include <drivecodec/fc.hpp>

namespace {

namespace fc = drivecodec::fc;
using drivecodec::bytes;
using drivecodec::errc;

/// What is wrong with the reply to a request with these data.
template <typename Layout, typename Request>
rules::fault fault_of(unsigned adr, Request const& asked, bytes wire)
{
    constexpr auto process     = 2 * Layout::process_words;
    constexpr auto has_pke     = requires { asked.pke; };
    constexpr auto is_text     = requires { asked.characters; };
    constexpr auto has_12_bits = Layout::parameter_number_bits == 12;
    constexpr auto least       = process + (is_text ? 4 : has_pke ? 8 : 0);
    if (rules::is_broadcast(adr)) { return {errc::no_reply, 0}; }
    auto const fault = rules::fault_of(wire, least, is_text ? 252 : least);
    if (fault.code != errc::none) { return fault; }
    if (wire[2] != adr) { return {errc::unexpected_server, 2}; }

    if constexpr (has_pke) {
        auto const data    = rules::data_of(wire);
        auto const command = asked.pke.raw >> 12;
        auto const number  = asked.pke.raw % (has_12_bits ? 4096 : 2048);
        if (command != 0 and rules::number_of(data, has_12_bits) != static_cast<unsigned>(number)) {
            return {errc::unexpected_reply, 3};
        }
        if (rules::ak_of(data) == 0x7 and data.size() == process + 8) {
            return {errc::exception_reply, rules::word_at(data, 6)};
        }
        auto const is_refusal = rules::ak_of(data) == 0x7;
        if (is_refusal or not rules::answers(rules::ak_of(data), static_cast<unsigned>(command))) {
            return {errc::unexpected_reply, 3};
        }
        if (not is_text and data[3] != 0 and data[3] != asked.ind.raw % 256) { return {errc::unexpected_reply, 5}; }
    }
    return {};
}

template <typename Layout, typename Request>
void check_reply(fc::address to, Request const& asked, bytes wire)
{
    auto const taken    = fc::check(to, asked, wire);
    auto const expected = fault_of<Layout>(to.byte(), asked, wire);
    FUZZ_ASSERT(taken.has_value() == (expected.code == errc::none));
    if (not taken) {
        FUZZ_ASSERT(taken.error().code() == expected.code and taken.error().offset() == expected.offset);
        if (expected.code == errc::exception_reply) {
            FUZZ_ASSERT(static_cast<unsigned>(taken.error().number()) == expected.offset);
        }
        return;
    }
    // It is what the telegram decodes to; or, of a parameter, a text that was asked for as one.
    using response     = std::remove_cvref_t<decltype(*taken)>;
    auto const decoded = fc::decode<response>(wire);
    if (decoded) {
        FUZZ_ASSERT(decoded->data == *taken);
    } else {
        FUZZ_ASSERT(decoded.error().code() == errc::unexpected_function);
    }
}

template <typename Layout, typename Request>
void try_replies(fc::address to, Request const& asked, bool is_drives, fuzz_input input)
{
    fuzz_input             manner{input.take(6)};
    fuzz_fc::drive<Layout> drive{manner};
    auto const             where  = input.u8();
    auto const             change = input.u8();
    bytes const            given  = input.rest();
    if (not is_drives) {
        check_reply<Layout>(to, asked, given);
        return;
    }

    std::array<std::uint8_t, 256> request{};
    auto const                    sent = fc::encode(to, asked, request);
    FUZZ_ASSERT(sent.has_value());
    exact_buffer const buffer{256};
    auto const         reply = fc::serve<Layout>(to, *sent, buffer.get(), drive);
    if (reply.empty()) { return; }
    check_reply<Layout>(to, asked, reply);
    auto const changed = buffer.get().first(reply.size());
    changed[where % changed.size()] ^= change;
    check_reply<Layout>(to, asked, changed);
    repair_bcc(changed);
    check_reply<Layout>(to, asked, changed);
    // Cut, with all that is around the data repaired.
    auto const cut = changed.first(4 + where % (changed.size() - 3));
    cut[1]         = static_cast<std::uint8_t>(cut.size() - 2);
    repair_bcc(cut);
    check_reply<Layout>(to, asked, cut);
}

template <typename Layout>
void look_with(fuzz_input input)
{
    auto const                          to      = fc::address::from_byte(input.u8());
    auto const                          what    = input.u8();
    auto const                          pke     = fc::pke::from_raw(input.u16());
    auto const                          ind     = fc::ind::from_raw(input.u16());
    auto const                          high    = input.u16();
    auto const                          low     = input.u16();
    auto const                          process = fc::basic_process_command<Layout>{fc::data_not_valid};
    std::array<std::uint8_t, 244> const characters{};
    switch (what % 4) {
    case 0: try_replies<Layout>(to, process, what / 4 % 2 != 0, input); break;
    case 1: {
        fc::basic_text_request<Layout> const asked{pke.with(fc::pke::command, fc::ak_command::text), ind,
                                                   bytes{characters}.first(low % 21U), process};
        try_replies<Layout>(to, asked, what / 4 % 2 != 0, input);
        break;
    }
    default: {
        auto const                                pwe = std::uint32_t{high} << 16 | low;
        fc::basic_parameter_request<Layout> const asked{pke, ind, pwe, process};
        try_replies<Layout>(to, asked, what / 4 % 2 != 0, input);
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
    auto const     mutated = LLVMFuzzerMutate(data, size, max_size);
    constexpr auto head    = std::size_t{18};
    if (mutated > head + 4 and seed % 3 != 0) {  // often the same parameter
        data[head + 3] = static_cast<std::uint8_t>((data[head + 3] & 0xF0) | (data[2] & 0x0F));
        data[head + 4] = data[3];
    }
    return repair_telegram(data, head, mutated, max_size, seed / 3, data[0]);
}

#endif
