#include <drivecodec/fc/framing.hpp>

#include "support/fc_model.hpp"
#include "support/hex.hpp"
#include "support/verify.hpp"

#include <drivecodec/core/deframer.hpp>

namespace {

namespace fc = drivecodec::fc;
using drivecodec::bytes;
using drivecodec::message_length;
using fc::data_kind;
using fc::direction;
using fc::expecting;
using fc::framing;
using fc_model::byte_list;
using fc_model::telegram_of;

using four_words = fc::data_layout<4, 12>;

static_assert(drivecodec::framing<framing<>>);
static_assert(drivecodec::framing<framing<fc::fc_layout>>);
static_assert(drivecodec::framing<framing<four_words>>);

// The same telegram asks for 202 and answers with its value.
constexpr auto parameter       = "02 0E 01 10 CA 00 00 00 00 00 00 00 00 00 00 D7"_hex;
constexpr auto parameter_of_2  = "02 0E 02 10 CA 00 00 00 00 00 00 00 00 00 00 D4"_hex;
constexpr auto process         = "02 06 01 04 7F 20 00 5E"_hex;
constexpr auto process_of_2    = "02 06 02 04 7F 20 00 5D"_hex;
constexpr auto process_of_long = "02 06 81 04 7F 20 00 DE"_hex;
constexpr auto text            = "02 0E 01 F2 6D 04 00 00 00 00 00 00 00 00 00 96"_hex;

//=== frames ===//

constexpr fc::frame frame_of(bytes raw)
{
    return {.raw = raw, .direction = direction::unknown, .aligned = true};
}

TEST(fc_frame, gives_its_parts)
{
    VERIFY(frame_of(parameter).address() == fc::address::short_format(1));
    VERIFY(frame_of(process_of_long).address() == fc::address::long_format(1));
    VERIFY(frame_of(parameter).data().size() == 12 and frame_of(parameter).data()[0] == 0x10);
    VERIFY(frame_of(process).data().size() == 4 and frame_of(process).data()[3] == 0x00);
    VERIFY(frame_of(parameter).ak() == 1);
    VERIFY(frame_of(text).ak() == 0xF);
}

TEST(fc_frame, is_of_a_kind)
{
    VERIFY(frame_of(process).kind() == data_kind::process);
    VERIFY(frame_of(parameter).kind() == data_kind::parameter);
    VERIFY(frame_of(text).kind() == data_kind::text);
    VERIFY(frame_of(process).kind<four_words>() == data_kind::unknown);
    VERIFY(frame_of(parameter).kind<four_words>() == data_kind::unknown);
    VERIFY(frame_of(text).kind<four_words>() == data_kind::text);  // without characters
}

/// Every size of data with every AK.
template <typename Layout, std::size_t ProcessWords>
void try_all_kinds()
{
    for (std::size_t size = 0; size <= 252; ++size) {
        for (unsigned ak = 0; ak < 16; ++ak) {
            byte_list data(size, 0x00);
            if (size > 0) { data[0] = static_cast<std::uint8_t>(ak << 4); }
            auto wanted = data_kind::unknown;
            if (size == 8 + 2 * ProcessWords) { wanted = data_kind::parameter; }
            if (size >= 4 + 2 * ProcessWords and ak == 0xF) { wanted = data_kind::text; }
            if (size == 2 * ProcessWords) { wanted = data_kind::process; }  // of which AK are the first bits of PCD1
            auto const whole = telegram_of(1, data);
            ASSERT_EQ(frame_of(whole).kind<Layout>(), wanted) << size << " " << ak;
            if (size > 0) { ASSERT_EQ(frame_of(whole).ak(), ak); }
        }
    }
}

TEST(fc_frame, is_of_a_kind_by_its_length_and_ak_f)
{
    try_all_kinds<fc::vlt_layout, 2>();
    try_all_kinds<fc::fc_layout, 2>();
    try_all_kinds<four_words, 4>();
    try_all_kinds<fc::data_layout<16, 12>, 16>();
}

//=== lengths ===//

TEST(fc_framing, begins_with_stx)
{
    for (unsigned byte = 0; byte < 256; ++byte) {
        std::array const one{static_cast<std::uint8_t>(byte)};
        EXPECT_EQ(framing<>{}.length(one, 0), byte == 2 ? message_length::at_least(2) : message_length::impossible());
        std::array const two{static_cast<std::uint8_t>(byte), std::uint8_t{14}};
        EXPECT_EQ(framing<>{}.length(two, 0), byte == 2 ? message_length::exactly(16) : message_length::impossible());
    }
}

TEST(fc_framing, has_the_length_that_lge_says)
{
    for (unsigned lge = 0; lge < 256; ++lge) {
        for (std::size_t more = 0; more < 300; more += 7) {
            byte_list front{0x02, static_cast<std::uint8_t>(lge)};
            front.resize(2 + more, 0x02);
            EXPECT_EQ(framing<>{}.length(front, 0), message_length::exactly(lge + 2));
        }
    }
    // "Telegram length (LGE)": 4 data bytes have LGE 6, 12 have 14; the whole telegram has two bytes more.
    VERIFY(framing<>{}.length(bytes{process}.first(2), 0) == message_length::exactly(8));
    VERIFY(framing<>{}.length(bytes{parameter}.first(2), 0) == message_length::exactly(16));
    VERIFY(framing<>::min_frame_size == 8 and framing<>::max_frame_size == 256 and framing<>::max_readings == 1);
    VERIFY(framing<four_words>::min_frame_size == 8);  // what another layout has is shown, as of an unknown kind
}

TEST(fc_framing, verifies_the_bcc)
{
    VERIFY(framing<>::is_intact(process) and framing<>::is_intact(parameter) and framing<>::is_intact(text));
    for (std::size_t at = 0; at < parameter.size(); ++at) {
        for (unsigned wrong = 1; wrong < 256; ++wrong) {
            auto damaged = parameter;
            damaged[at]  = static_cast<std::uint8_t>(damaged[at] ^ wrong);
            EXPECT_FALSE(framing<>::is_intact(damaged));
        }
    }
}

//=== directions: each sentence of the rule ===//

template <typename Layout = fc::vlt_layout>
constexpr direction direction_of(framing<Layout> const& scheme, bytes raw)
{
    auto copy = scheme;
    return copy.accept(raw, 0, true).direction;
}

template <typename Layout = fc::vlt_layout>
constexpr framing<Layout> after(bytes heard, framing<Layout> scheme = framing<Layout>{})
{
    static_cast<void>(scheme.accept(heard, 0, true));
    return scheme;
}

/// `parameter` to or from `adr` with another AK, BCC repaired.
constexpr auto with_ak(unsigned ak, std::uint8_t adr = 1)
{
    auto made = parameter;
    made[2]   = adr;
    made[3]   = static_cast<std::uint8_t>(ak << 4);
    made[15]  = 0;
    made[15]  = fc::bcc::of(made);
    return made;
}

constexpr auto broadcast      = "02 06 20 04 7F 20 00 7F"_hex;
constexpr auto write_to_ee    = with_ak(0xE);
constexpr auto refusal        = with_ak(0x7);
constexpr auto write_double   = with_ak(0x3);
constexpr auto refusal_of_all = with_ak(0x7, 0x20);

TEST(fc_framing, keeps_what_it_accepts)
{
    static constexpr auto accepted = framing<>{}.accept(parameter, 0, false);
    VERIFY(accepted.raw.data() == parameter.data() and accepted.raw.size() == parameter.size());
    VERIFY(not accepted.aligned);
    VERIFY(framing<>{}.accept(parameter, 0, true).aligned);
}

TEST(fc_framing, has_the_direction_that_is_expected)
{
    for (unsigned ak = 0; ak < 16; ++ak) {
        for (int adr : {0x00, 0x01, 0x20, 0x80, 0x81, 0xFF}) {
            auto const whole = with_ak(ak, static_cast<std::uint8_t>(adr));
            EXPECT_EQ(direction_of(framing<>{expecting::request}, whole), direction::request);
            EXPECT_EQ(direction_of(framing<>{expecting::response}, whole), direction::response);
            EXPECT_EQ(direction_of(after(whole, framing<>{expecting::request}), whole), direction::request);
            EXPECT_EQ(direction_of(after(whole, framing<>{expecting::response}), whole), direction::response);
        }
    }
    // Also of the own address.
    VERIFY(direction_of(framing<>{expecting::response, fc::address::short_format(1)}, parameter)
           == direction::response);
}

TEST(fc_framing, has_requests_only_among_broadcasts)
{
    for (int adr = 0; adr < 256; ++adr) {
        auto const whole = with_ak(0x7, static_cast<std::uint8_t>(adr));  // else a response
        EXPECT_EQ(direction_of(framing<>{}, whole),
                  fc_model::is_broadcast(adr) ? direction::request : direction::response)
            << adr;
    }
    VERIFY(direction_of(framing<>{}, refusal_of_all) == direction::request);
    VERIFY(direction_of(after(broadcast), broadcast) == direction::request);
}

TEST(fc_framing, has_requests_only_for_its_own_address)
{
    for (int own = 1; own <= 126; ++own) {
        auto const format =
            own % 2 == 0 or own > 31 ? fc::address_format::long_1_to_126 : fc::address_format::short_1_to_31;
        framing<> const scheme{expecting::either, *fc::address::make(format, static_cast<std::uint8_t>(own))};
        for (int adr = 0; adr < 256; ++adr) {
            auto const is_own = fc_model::number_of(adr) == own;  // in either format
            auto const whole  = with_ak(0x7, static_cast<std::uint8_t>(adr));
            EXPECT_EQ(direction_of(scheme, whole),
                      is_own or fc_model::is_broadcast(adr) ? direction::request : direction::response);
        }
    }
}

TEST(fc_framing, has_no_own_address_that_is_none)
{
    for (auto const none : {fc::short_broadcast, fc::long_broadcast, fc::address::from_byte(0x00)}) {
        EXPECT_EQ(direction_of(framing<>{expecting::either, none}, with_ak(0x7, 0x00)), direction::response);
    }
}

TEST(fc_framing, knows_the_direction_of_an_ak_that_only_one_side_sends)
{
    for (unsigned ak = 0; ak < 16; ++ak) {
        auto const whole = with_ak(ak);
        auto const told  = ak == 0x3 or ak == 0xD or ak == 0xE ? direction::request
                           : ak == 0x7                         ? direction::response
                                                               : direction::unknown;
        EXPECT_EQ(direction_of(framing<>{}, whole), told) << ak;
        // Whatever was heard before.
        if (told != direction::unknown) {
            for (auto const& before : {parameter, parameter_of_2, write_to_ee, refusal}) {
                EXPECT_EQ(direction_of(after(before), whole), told) << ak;
            }
        }
    }
}

TEST(fc_framing, takes_ak_3_for_a_description_where_numbers_have_12_bits)
{
    VERIFY(direction_of(framing<>{}, write_double) == direction::request);
    VERIFY(direction_of(framing<fc::fc_layout>{}, write_double) == direction::unknown);
    VERIFY(direction_of(framing<fc::fc_layout>{}, write_to_ee) == direction::request);
    VERIFY(direction_of(framing<fc::fc_layout>{}, refusal) == direction::response);
}

TEST(fc_framing, looks_for_ak_in_parameters_only)
{
    // Process data that begin with E or 7, texts of either direction, and what has a length of another layout.
    VERIFY(direction_of(framing<>{}, "02 06 01 E4 7F 20 00 BE"_hex) == direction::unknown);
    VERIFY(direction_of(framing<>{}, "02 06 01 74 7F 20 00 2E"_hex) == direction::unknown);
    VERIFY(direction_of(framing<>{}, text) == direction::unknown);
    VERIFY(direction_of(framing<four_words>{}, write_to_ee) == direction::unknown);
}

TEST(fc_framing, hears_behind_a_request_the_response_of_the_same_address)
{
    VERIFY(direction_of(after(write_to_ee), parameter) == direction::response);
    VERIFY(direction_of(after(write_to_ee), process) == direction::response);
    VERIFY(direction_of(after(write_to_ee), text) == direction::response);
}

TEST(fc_framing, hears_behind_a_request_the_request_to_another_address)
{
    VERIFY(direction_of(after(write_to_ee), parameter_of_2) == direction::request);
    VERIFY(direction_of(after(write_to_ee), process_of_2) == direction::request);
    VERIFY(direction_of(after(write_to_ee), process_of_long) == direction::request);  // a slave repeats ADR as it came
    VERIFY(direction_of(after(broadcast), process) == direction::request);
}

TEST(fc_framing, hears_behind_a_response_a_request)
{
    VERIFY(direction_of(after(refusal), parameter) == direction::request);
    VERIFY(direction_of(after(refusal), process) == direction::request);
    VERIFY(direction_of(after(refusal), process_of_2) == direction::request);
    VERIFY(direction_of(after(parameter, after(write_to_ee)), parameter) == direction::request);
}

TEST(fc_framing, does_not_know_where_nothing_was_heard_before)
{
    VERIFY(direction_of(framing<>{}, parameter) == direction::unknown);
    VERIFY(direction_of(framing<>{}, process) == direction::unknown);
    VERIFY(direction_of(after(parameter), parameter) == direction::unknown);
    VERIFY(direction_of(after(process_of_2, after(parameter)), process) == direction::unknown);
    VERIFY(direction_of(after(write_to_ee, after(parameter)), parameter) == direction::response);
}

TEST(fc_framing, forgets_the_request_that_timed_out)
{
    static constexpr auto timed_out = [](framing<> scheme) {
        scheme.request_timed_out();
        return scheme;
    };
    VERIFY(direction_of(timed_out(after(write_to_ee)), parameter) == direction::request);
    VERIFY(direction_of(timed_out(after(write_to_ee)), process_of_2) == direction::request);
    VERIFY(direction_of(timed_out(after(refusal)), parameter) == direction::request);
    VERIFY(direction_of(timed_out(framing<>{}), parameter) == direction::request);
    VERIFY(direction_of(timed_out(after(parameter)), parameter) == direction::request);
    VERIFY(direction_of(timed_out(framing<>{}), refusal) == direction::response);
    VERIFY(direction_of(after(parameter, timed_out(after(write_to_ee))), parameter) == direction::response);
}

}  // namespace
