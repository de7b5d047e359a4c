// Any bytes as a telegram of every kind, in three layouts: exactly what is one is decoded, field by field as an
// independent look finds it; it encodes to the same bytes; what is none has its fault where the rules have it.
#include "fc/rules.hpp"

#include <drivecodec/fc.hpp>

#include <limits>

namespace {

namespace fc = drivecodec::fc;
using drivecodec::bytes;
using drivecodec::errc;

using four_words = fc::data_layout<4, 12>;

enum class kind { process, parameter, text };

/// What is wrong with `wire` as one of this kind.
template <typename Layout>
rules::fault fault_of(bytes wire, kind what)
{
    constexpr auto process = 2 * Layout::process_words;
    auto const     least   = process + (what == kind::process ? 0 : what == kind::parameter ? 8 : 4);
    auto const     fault   = rules::fault_of(wire, least, what == kind::text ? 252 : least);
    if (fault.code != errc::none or what == kind::process) { return fault; }
    auto const is_text = rules::ak_of(rules::data_of(wire)) == 0xF;
    return is_text == (what == kind::text) ? fault : rules::fault{errc::unexpected_function, 3};
}

/// The last words of the data.
template <typename Process>
void look_at(Process const& process, bytes data, std::size_t words)
{
    auto const pcd = data.last(2 * words);
    FUZZ_ASSERT(process.pcd().size() == words);
    for (std::size_t i = 0; i < words; ++i) { FUZZ_ASSERT(process.pcd(i) == rules::word_at(pcd, 2 * i)); }
    if constexpr (requires { process.control_word(); }) {
        FUZZ_ASSERT(process.control_word() == rules::word_at(pcd, 0) and process.reference().raw() == process.pcd(1));
        FUZZ_ASSERT(process.is_data_valid() == ((pcd[0] & 0x04) != 0));
    } else {
        FUZZ_ASSERT(process.status_word() == rules::word_at(pcd, 0));
        FUZZ_ASSERT(process.output_frequency().raw() == process.pcd(1));
    }
}

template <typename T, typename Parameter>
void look_at_value(Parameter const& parameter, bytes data, fc::data_type type)
{
    auto const expected = rules::value_of(data, Parameter::is_request, std::is_signed_v<T>, 8 * sizeof(T));
    auto const given    = parameter.template value<T>();
    FUZZ_ASSERT(given.has_value() == expected.has_value());
    if (given) { FUZZ_ASSERT(static_cast<long long>(*given) == *expected); }
    if (type == fc::data_type{}) { return; }
    auto const widened = parameter.value(type);
    FUZZ_ASSERT(widened.has_value() == expected.has_value());
    if (widened) { FUZZ_ASSERT(*widened == *expected); }
}

template <typename Block>
void look_at_pke(Block const& block, bytes data)
{
    constexpr auto has_12_bits = Block::layout_type::parameter_number_bits == 12;
    FUZZ_ASSERT(block.pke.raw == rules::word_at(data, 0) and block.ind.raw == rules::word_at(data, 2));
    FUZZ_ASSERT(block.number() == rules::number_of(data, has_12_bits));
}

template <typename Parameter>
void look_at_parameter(Parameter const& parameter, bytes data)
{
    look_at_pke(parameter, data);
    FUZZ_ASSERT(parameter.array_index() == data[3] and parameter.pwe == rules::pwe_of(data));
    if constexpr (Parameter::is_request) {
        FUZZ_ASSERT(static_cast<unsigned>(parameter.command()) == rules::ak_of(data));
    } else {
        FUZZ_ASSERT(static_cast<unsigned>(parameter.reply()) == rules::ak_of(data));
    }
    look_at_value<std::int8_t>(parameter, data, {});
    look_at_value<std::uint8_t>(parameter, data, fc::data_type::unsigned_8);
    look_at_value<std::int16_t>(parameter, data, fc::data_type::integer_16);
    look_at_value<std::uint16_t>(parameter, data, fc::data_type::unsigned_16);
    look_at_value<std::int32_t>(parameter, data, fc::data_type::integer_32);
    look_at_value<std::uint32_t>(parameter, data, fc::data_type::unsigned_32);
    FUZZ_ASSERT(not parameter.value(fc::data_type::text_string));
}

template <typename Text>
void look_at_text(Text const& text, bytes wire, std::size_t words)
{
    look_at_pke(text, rules::data_of(wire));
    FUZZ_ASSERT(static_cast<unsigned>(text.access()) == wire[5]);
    FUZZ_ASSERT(text.characters.data() == wire.data() + 7);  // borrowed
    FUZZ_ASSERT(text.characters.size() == wire.size() - 8 - 2 * words);
}

/// The same bytes come back, into a room of just this size, and into none of less.
template <typename Data>
void encode_again(fc::telegram<Data> const& decoded, bytes wire)
{
    FUZZ_ASSERT(decoded.wire_size() == wire.size());
    exact_buffer const buffer{wire.size()};
    auto const         written = fc::encode(decoded.address, decoded.data, buffer.get());
    FUZZ_ASSERT(written and written->data() == buffer.get().data() and rules::is_same(*written, wire));
    if constexpr (drivecodec::fixed_size<Data>) {
        FUZZ_ASSERT(rules::is_same(fc::encode(decoded.address, decoded.data), wire));
    }
    exact_buffer const small{wire.size() - 1};
    auto const         refused = fc::encode(decoded.address, decoded.data, small.get());
    FUZZ_ASSERT(not refused and refused.error().code() == errc::no_space);
    for (auto const byte : small.get()) { FUZZ_ASSERT(byte == 0); }
}

template <typename Layout, typename Data>
bool is_decoded(bytes wire, kind what)
{
    auto const decoded  = fc::decode<Data>(wire);
    auto const expected = fault_of<Layout>(wire, what);
    auto const checked  = fc::telegram<Data>::check(wire);
    FUZZ_ASSERT(checked.code() == expected.code and (checked.ok() or checked.offset() == expected.offset));
    FUZZ_ASSERT(decoded.has_value() == checked.ok());
    if (not decoded) {
        FUZZ_ASSERT(decoded.error().code() == expected.code and decoded.error().offset() == expected.offset);
        FUZZ_ASSERT((expected.code == errc::truncated) == (expected.offset > wire.size()));
        return false;
    }

    FUZZ_ASSERT(decoded->address.byte() == wire[2] and not decoded->address.is_reserved());
    FUZZ_ASSERT(decoded->address.is_broadcast() == rules::is_broadcast(wire[2]));
    FUZZ_ASSERT(decoded->address.number() == rules::slave_of(wire[2]));
    auto const data = rules::data_of(wire);
    if constexpr (requires { decoded->data.pwe; }) { look_at_parameter(decoded->data, data); }
    if constexpr (requires { decoded->data.characters; }) { look_at_text(decoded->data, wire, Layout::process_words); }
    if constexpr (requires { decoded->data.process; }) {
        look_at(decoded->data.process, data, Layout::process_words);
    } else {
        look_at(decoded->data, data, Layout::process_words);
    }
    encode_again(*decoded, wire);

    std::size_t needed = 0;
    for (std::size_t size = 0; size < wire.size(); ++size) {
        auto const cut = fc::telegram<Data>::check(wire.first(size));
        FUZZ_ASSERT(cut.code() == errc::truncated);
        FUZZ_ASSERT(cut.offset() > size and cut.offset() >= needed and cut.offset() <= wire.size());
        needed = cut.offset();
    }
    return true;
}

template <typename Layout>
void look_with(bytes wire)
{
    auto const is_process = is_decoded<Layout, fc::basic_process_command<Layout>>(wire, kind::process);
    FUZZ_ASSERT((is_decoded<Layout, fc::basic_process_status<Layout>>(wire, kind::process)) == is_process);
    auto const is_parameter = is_decoded<Layout, fc::basic_parameter_request<Layout>>(wire, kind::parameter);
    FUZZ_ASSERT((is_decoded<Layout, fc::basic_parameter_response<Layout>>(wire, kind::parameter)) == is_parameter);
    auto const is_text = is_decoded<Layout, fc::basic_text_request<Layout>>(wire, kind::text);
    FUZZ_ASSERT((is_decoded<Layout, fc::basic_text_response<Layout>>(wire, kind::text)) == is_text);

    // It is of one kind at most, and a reader's frame knows of which.
    FUZZ_ASSERT(is_process + is_parameter + is_text <= 1);
    if (not rules::is_telegram(wire)) { return; }
    fc::frame const whole{.raw = wire, .direction = fc::direction::unknown, .aligned = true};
    switch (whole.kind<Layout>()) {
    case fc::data_kind::process: FUZZ_ASSERT(is_process); break;
    case fc::data_kind::parameter: FUZZ_ASSERT(is_parameter); break;
    case fc::data_kind::text: FUZZ_ASSERT(is_text); break;
    case fc::data_kind::unknown: FUZZ_ASSERT(not is_process and not is_parameter and not is_text); break;
    }
    FUZZ_ASSERT(rules::is_same(whole.data(), rules::data_of(wire)) and whole.address().byte() == wire[2]);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    bytes const wire{data, size};
    FUZZ_ASSERT(fc::bcc::of(wire) == reference_bcc(wire));
    look_with<fc::vlt_layout>(wire);
    look_with<fc::fc_layout>(wire);
    look_with<four_words>(wire);
    return 0;
}

#ifdef FUZZ_ENGINE

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed)
{
    return repair_telegram(data, 0, LLVMFuzzerMutate(data, size, max_size), max_size, seed);
}

#endif
