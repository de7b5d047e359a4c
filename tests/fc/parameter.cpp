#include <drivecodec/fc/parameter.hpp>

#include "support/fc_model.hpp"
#include "support/fc_vectors.hpp"
#include "support/verify.hpp"

#include <random>

namespace {

using namespace drivecodec::literals;
using drivecodec::bytes;
using drivecodec::errc;
using drivecodec::error;
using namespace drivecodec::fc;
using fc_model::byte_list;

constexpr error no_such_value{errc::bad_value, 0};
constexpr error does_not_fit{errc::out_of_range, 0};

//=== the examples of the manual ===//

constexpr auto data_of(auto const& telegram)
{
    std::array<std::uint8_t, 12> data{};
    for (std::size_t i = 0; i < data.size(); ++i) { data[i] = telegram[3 + i]; }
    return data;
}

TEST(parameter, decodes_the_examples)
{
    static constexpr auto asked = drivecodec::decode<parameter_request>(data_of(vectors::write_202));
    VERIFY(asked->command() == ak_command::write_word_to_eeprom);
    VERIFY(asked->number() == 202 and asked->array_index() == 0);
    VERIFY(asked->pwe == 1000 and *asked->value<std::uint16_t>() == 1000);
    VERIFY(asked->process.control_word() == 0x047F and asked->process.reference() == 50_percent);

    static constexpr auto said = drivecodec::decode<parameter_response>(data_of(vectors::write_202_response));
    VERIFY(said->reply() == ak_reply::word);
    VERIFY(said->number() == 202 and *said->value<std::uint16_t>() == 1000);
    VERIFY(said->process.status_word() == 0x0F03 and said->process.output_frequency() == 50_percent);
}

TEST(parameter, has_an_array_index)
{
    static constexpr auto asked = drivecodec::decode<parameter_request>(data_of(vectors::read_615_1));
    VERIFY(asked->command() == ak_command::read_value);
    VERIFY(asked->number() == 615 and asked->array_index() == 1);
    static constexpr auto said = drivecodec::decode<parameter_response>(data_of(vectors::read_615_1_response));
    VERIFY(said->array_index() == 1 and *said->value<std::uint8_t>() == 13);
}

// The reply of the example is 000Ah for 10 s: whole seconds, unlike most times of the drive.
TEST(parameter, of_206_has_10_for_10_seconds)
{
    static constexpr auto said = drivecodec::decode<parameter_response>(data_of(vectors::read_206_response));
    VERIFY(said->number() == 206 and *said->value(data_type::unsigned_16) == 10);
}

TEST(parameter, has_the_high_word_of_its_value_first)
{
    static constexpr auto asked = drivecodec::decode<parameter_request>(data_of(vectors::write_291_1));
    VERIFY(asked->command() == ak_command::write_double_word_to_eeprom);
    VERIFY(asked->pwe == 0x0001'2345);
    VERIFY(*asked->value<std::uint32_t>() == 0x0001'2345);
    VERIFY(drivecodec::encode(*asked) == data_of(vectors::write_291_1));
}

//=== which AK has a value ===//

TEST(parameter, has_a_width_that_ak_tells)
{
    for (unsigned ak = 0; ak < 16; ++ak) {
        auto const written = width_of(static_cast<ak_command>(ak));
        ASSERT_EQ(written.has_value(), ak == 0x2 or ak == 0x3 or ak == 0xD or ak == 0xE) << ak;
        if (written) {
            ASSERT_EQ(*written, ak == 0x2 or ak == 0xE ? width::word : width::double_word) << ak;
        } else {
            ASSERT_EQ(written.error(), no_such_value);
        }
        auto const brought = width_of(static_cast<ak_reply>(ak));
        ASSERT_EQ(brought.has_value(), ak == 0x1 or ak == 0x2) << ak;
        if (brought) {
            ASSERT_EQ(*brought, ak == 0x1 ? width::word : width::double_word) << ak;
        } else {
            ASSERT_EQ(brought.error(), no_such_value);
        }
    }
}

constexpr parameter_response response_of(ak_reply reply, std::uint32_t pwe)
{
    return {pke{}.with(pke::reply, reply), {}, pwe, {}};
}
constexpr parameter_request request_of(ak_command command, std::uint32_t pwe)
{
    return {pke{}.with(pke::command, command), {}, pwe, data_not_valid};
}

TEST(parameter, has_no_value_where_ak_has_none)
{
    for (unsigned ak = 0; ak < 16; ++ak) {
        auto const said = response_of(static_cast<ak_reply>(ak), 1);
        ASSERT_EQ(said.value<std::uint16_t>().has_value(), ak == 1) << ak;
        ASSERT_EQ(said.value<std::int32_t>().has_value(), ak == 2) << ak;
        ASSERT_EQ(said.value(data_type::unsigned_8).has_value(), ak == 1) << ak;
        ASSERT_EQ(said.value(data_type::unsigned_32).has_value(), ak == 2) << ak;
        auto const asked = request_of(static_cast<ak_command>(ak), 1);
        ASSERT_EQ(asked.value<std::int8_t>().has_value(), ak == 0x2 or ak == 0xE) << ak;
        ASSERT_EQ(asked.value<std::uint32_t>().has_value(), ak == 0x3 or ak == 0xD) << ak;
    }
    // "If the master enquires about a parameter value, the PWE block contains no value."
    VERIFY(request_of(ak_command::read_value, 1).value<std::uint16_t>().error() == no_such_value);
    VERIFY(response_of(ak_reply::cannot_be_executed, 130).value<std::uint16_t>().error() == no_such_value);
}

TEST(parameter, is_no_word_where_ak_says_double_word)
{
    VERIFY(response_of(ak_reply::double_word, 5).value<std::uint16_t>().error() == no_such_value);
    VERIFY(response_of(ak_reply::word, 5).value<std::uint32_t>().error() == no_such_value);
    VERIFY(response_of(ak_reply::double_word, 5).value(data_type::integer_16).error() == no_such_value);
    VERIFY(response_of(ak_reply::word, 5).value(data_type::integer_32).error() == no_such_value);
}

//=== every value ===//

TEST(parameter, is_read_from_every_word)
{
    for (int raw = 0; raw <= 0xFFFF; ++raw) {
        auto const said      = response_of(ak_reply::word, static_cast<std::uint32_t>(raw));
        auto const as_signed = raw < 0x8000 ? raw : raw - 0x10000;
        ASSERT_EQ(*said.value<std::uint16_t>(), raw);
        ASSERT_EQ(*said.value<std::int16_t>(), as_signed);
        ASSERT_EQ(*said.value(data_type::unsigned_16), raw);
        ASSERT_EQ(*said.value(data_type::integer_16), as_signed);

        auto const fits = [](auto const& read, bool wanted, int number) {
            return wanted ? read and *read == number : not read and read.error() == does_not_fit;
        };
        ASSERT_TRUE(fits(said.value<std::uint8_t>(), raw <= 0xFF, raw)) << raw;
        ASSERT_TRUE(fits(said.value(data_type::unsigned_8), raw <= 0xFF, raw)) << raw;
        ASSERT_TRUE(fits(said.value<std::int8_t>(), as_signed >= -128 and as_signed <= 127, as_signed)) << raw;
    }
}

TEST(parameter, takes_a_negative_word_with_0_or_its_sign_above)
{
    for (std::uint32_t raw = 0; raw <= 0xFFFF; ++raw) {
        auto const extended = response_of(ak_reply::word, 0xFFFF'0000U | raw);
        if (raw >= 0x8000) {
            ASSERT_EQ(*extended.value<std::int16_t>(), static_cast<int>(raw) - 0x10000);
            ASSERT_EQ(*extended.value(data_type::integer_16), static_cast<int>(raw) - 0x10000);
        } else {
            ASSERT_EQ(extended.value<std::int16_t>().error(), no_such_value) << raw;
        }
        ASSERT_EQ(extended.value<std::uint16_t>().error(), no_such_value) << raw;
        ASSERT_EQ(extended.value<std::uint8_t>().error(), no_such_value) << raw;
    }
    VERIFY(*response_of(ak_reply::word, 0xFFFF'FFFF).value<std::int8_t>() == -1);
    VERIFY(response_of(ak_reply::word, 0xFFFF'FF7F).value<std::int8_t>().error() == does_not_fit);
}

TEST(parameter, is_no_word_with_anything_else_above)
{
    for (std::uint32_t high = 1; high < 0xFFFF; ++high) {
        auto const said = response_of(ak_reply::word, high << 16 | 0x8001);
        ASSERT_EQ(said.value<std::int16_t>().error(), no_such_value) << high;
        ASSERT_EQ(said.value<std::uint16_t>().error(), no_such_value) << high;
    }
}

TEST(parameter, is_read_from_double_words)
{
    VERIFY(*response_of(ak_reply::double_word, 0xFFFF'FFFF).value<std::int32_t>() == -1);
    VERIFY(*response_of(ak_reply::double_word, 0xFFFF'FFFF).value<std::uint32_t>() == 4'294'967'295);
    VERIFY(*response_of(ak_reply::double_word, 0x8000'0000).value(data_type::integer_32) == -2'147'483'648LL);
    VERIFY(*response_of(ak_reply::double_word, 0x8000'0000).value(data_type::unsigned_32) == 2'147'483'648LL);
    VERIFY(*response_of(ak_reply::double_word, 5).value(data_type::integer_32) == 5);
}

TEST(parameter, has_no_number_of_a_type_that_is_none)
{
    for (unsigned type = 0; type < 256; ++type) {
        if (type >= 3 and type <= 7) { continue; }
        for (auto const reply : {ak_reply::word, ak_reply::double_word}) {
            ASSERT_EQ(response_of(reply, 1).value(static_cast<data_type>(type)).error(), no_such_value) << type;
        }
    }
}

TEST(parameter, holds_integers_of_up_to_32_bits)
{
    VERIFY(parameter_integer<std::uint8_t> and parameter_integer<int> and parameter_integer<std::int16_t>);
    VERIFY(not parameter_integer<std::int64_t> and not parameter_integer<bool> and not parameter_integer<float>);
}

//=== wire ===//

template <typename Data>
void survives()
{
    std::mt19937                                random{4};
    std::array<std::uint8_t, Data::wire_size()> wire{};
    for (unsigned pke = 0; pke <= 0xFFFF; ++pke) {
        for (auto& byte : wire) { byte = static_cast<std::uint8_t>(random()); }
        wire[0] = static_cast<std::uint8_t>(pke >> 8);
        wire[1] = static_cast<std::uint8_t>(pke);

        auto const read = drivecodec::decode<Data>(wire);
        ASSERT_EQ(read.has_value(), pke < 0xF000) << pke;
        if (not read) {
            ASSERT_EQ(read.error(), error(errc::unexpected_function, 0));
            continue;
        }
        ASSERT_EQ(drivecodec::encode(*read), wire);
        ASSERT_EQ(read->pke.raw, pke);
        ASSERT_EQ(read->number(), pke & (Data::layout_type::parameter_number_bits == 12 ? 0xFFFU : 0x7FFU));
        ASSERT_EQ(read->array_index(), wire[3]);
        ASSERT_EQ(read->pwe, ((wire[4] * 256U + wire[5]) * 256U + wire[6]) * 256U + wire[7]);
        ASSERT_EQ(read->process.pcd(0), wire[8] * 256 + wire[9]);
        if constexpr (Data::is_request) {
            ASSERT_EQ(static_cast<unsigned>(read->command()), pke >> 12);
        } else {
            ASSERT_EQ(static_cast<unsigned>(read->reply()), pke >> 12);
        }
    }
}

TEST(parameter, survives_with_every_pke_in_both_directions_and_all_layouts)
{
    survives<parameter_request>();
    survives<parameter_response>();
    survives<basic_parameter_request<fc_layout>>();
    survives<basic_parameter_response<data_layout<4, 12>>>();
    survives<basic_parameter_request<data_layout<8>>>();
}

template <typename Data>
void refuses_every_other_size()
{
    for (std::size_t size = 0; size <= 60; ++size) {
        byte_list const wire(size);
        auto const      wanted = Data::wire_size();
        if (size < wanted) { ASSERT_EQ(Data::check(wire), error(errc::truncated, wanted)); }
        if (size == wanted) { ASSERT_TRUE(Data::check(wire).ok()); }
        if (size > wanted) { ASSERT_EQ(Data::check(wire), error(errc::trailing_bytes, wanted)); }
    }
}

TEST(parameter, refuses_every_other_size)
{
    refuses_every_other_size<parameter_request>();
    refuses_every_other_size<parameter_response>();
    refuses_every_other_size<basic_parameter_request<data_layout<16>>>();
}

}  // namespace
