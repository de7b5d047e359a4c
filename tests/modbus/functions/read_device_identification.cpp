#include <drivecodec/modbus/functions/read_device_identification.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

#include <random>

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

using identification = read_device_identification;
using request        = identification::request;
using response       = identification::response;
using id_code        = read_device_id_code;

constexpr device_object_id id(int number) { return static_cast<device_object_id>(number); }

//=== the specification's example ===//

constexpr auto vendor  = "43 6F 6D 70 61 6E 79 20 69 64 65 6E 74 69 66 69 63 61 74 69 6F 6E"_hex;
constexpr auto product = "50 72 6F 64 75 63 74 20 63 6F 64 65 20 58 58"_hex;
constexpr auto version = "56 32 2E 31 31"_hex;

constexpr std::array<device_object, 3> basic_objects{{{device_object_id::vendor_name, vendor},
                                                      {device_object_id::product_code, product},
                                                      {device_object_id::major_minor_revision, version}}};

TEST(read_device_identification, is_what_the_specification_prints)
{
    constexpr request asked{id_code::basic};
    VERIFY(encode(asked) == vectors::read_device_identification_request);
    VERIFY(*decode<request>(vectors::read_device_identification_request) == asked);

    constexpr auto given = *decode<response>(vectors::read_device_identification_response);
    VERIFY(given.id_code() == id_code::basic and given.conformity() == device_conformity::basic_stream);
    VERIFY(not given.more_follows() and given.next_object_id() == id(0));
    VERIFY(given.objects() == record_list<device_object>{basic_objects});
    VERIFY(asked.matches(given).ok());
}

TEST(read_device_identification, answers_what_the_specification_prints)
{
    constexpr request asked{id_code::basic};
    constexpr auto    given = identification::answer(asked, device_conformity::basic_stream, basic_objects);
    VERIFY(given.has_value());
    VERIFY(*given == *decode<response>(vectors::read_device_identification_response));
    EXPECT_EQ(properties::wire_of(*given), properties::copy_of(vectors::read_device_identification_response));
}

//=== requests ===//

TEST(read_device_identification, has_codes_1_to_4)
{
    for (unsigned code = 0; code <= 0xFF; ++code) {
        std::array<std::uint8_t, 4> const pdu{0x2B, 0x0E, static_cast<std::uint8_t>(code), 0};
        auto const                        expected = code >= 1 and code <= 4 ? error{} : error{errc::bad_value, 2};
        EXPECT_EQ(request::check(pdu), expected) << code;
        auto const made = request::make(static_cast<id_code>(code), id(0));
        EXPECT_EQ(made.has_value() ? error{} : made.error(), expected) << code;
    }
}

TEST(read_device_identification, asks_for_every_object_id)
{
    for (int number = 0; number <= 0xFF; ++number) {
        for (auto const code : {id_code::basic, id_code::regular, id_code::extended, id_code::specific}) {
            ASSERT_TRUE(properties::round_trips(*request::make(code, id(number))));
        }
    }
    constexpr request last{id_code::specific, 0xFF};
    constexpr request named{id_code::specific, device_object_id::model_name};
    VERIFY(last.object_id() == id(0xFF) and named.object_id() == id(5));
}

TEST(read_device_identification, is_not_another_mei_type)
{
    VERIFY(request::check("2B 0D 01 00"_hex) == error{errc::unexpected_function, 1});
    VERIFY(response::check("2B 0D 01 01 00 00 00"_hex) == error{errc::unexpected_function, 1});
    VERIFY(request::check("2B"_hex) == error{errc::truncated, 4});
    VERIFY(response::check("2B"_hex) == error{errc::truncated, 7});
}

//=== responses ===//

TEST(read_device_identification, checks_the_fields_of_a_response)
{
    VERIFY(response::check("2B 0E 00 01 00 00 00"_hex) == error{errc::bad_value, 2});
    VERIFY(response::check("2B 0E 05 01 00 00 00"_hex) == error{errc::bad_value, 2});
    VERIFY(response::check("2B 0E 01 01 01 00 00"_hex) == error{errc::bad_value, 4});
    VERIFY(response::check("2B 0E 01 01 FE 00 00"_hex) == error{errc::bad_value, 4});
    VERIFY(response::check("2B 0E 01 01 FF 05 00"_hex).ok());
    VERIFY(response::check("2B 0E 01 FF 00 00 00"_hex).ok());  // a conformity without a name
}

TEST(read_device_identification, says_how_much_of_its_objects_is_missing)
{
    VERIFY(response::length("2B 0E 01 01 00 00"_hex) == message_length::at_least(7));
    VERIFY(response::length("2B 0E 01 01 00 00 00"_hex) == message_length::exactly(7));
    VERIFY(response::length("2B 0E 01 01 00 00 03"_hex) == message_length::at_least(13));
    VERIFY(response::length("2B 0E 01 01 00 00 03 00"_hex) == message_length::at_least(13));
    VERIFY(response::length("2B 0E 01 01 00 00 03 00 10"_hex) == message_length::at_least(29));
    VERIFY(response::length("2B 0E 01 01 00 00 01 00 10"_hex) == message_length::exactly(25));
    VERIFY(response::check("2B 0E 01 01 00 00 03"_hex) == error{errc::truncated, 13});
    VERIFY(response::check("2B 0E 01 01 00 00 01 00 10"_hex) == error{errc::truncated, 25});
    VERIFY(response::check("2B 0E 01 01 00 00 01 00 00 00"_hex) == error{errc::trailing_bytes, 9});
}

// Objects longer than the frame, and more of them than a frame can hold.
TEST(read_device_identification, refuses_what_no_pdu_can_hold)
{
    VERIFY(response::check("2B 0E 01 01 00 00 01 00 F5"_hex) == error{errc::bad_length, 6});
    VERIFY(response::check("2B 0E 01 01 00 00 01 00 F4"_hex) == error{errc::truncated, 253});
    VERIFY(response::check("2B 0E 01 01 00 00 01 00 FF"_hex) == error{errc::bad_length, 6});
    VERIFY(response::check("2B 0E 01 01 00 00 FF"_hex) == error{errc::bad_length, 6});
    VERIFY(response::check("2B 0E 01 01 00 00 7C"_hex) == error{errc::bad_length, 6});
    VERIFY(response::check("2B 0E 01 01 00 00 7B"_hex) == error{errc::truncated, 253});
}

TEST(read_device_identification, keeps_objects_with_unknown_ids)
{
    static constexpr auto wire = "2B 0E 04 83 00 00 01 C8 02 12 34"_hex;
    constexpr auto        given = *decode<response>(wire);
    VERIFY((*given.objects().begin()).id == id(0xC8));
    EXPECT_EQ(properties::wire_of(given), properties::copy_of(wire));
}

TEST(read_device_identification, is_answered_with_its_code_and_its_object)
{
    static constexpr auto one     = "2B 0E 04 83 00 00 01 02 00"_hex;
    static constexpr auto another = "2B 0E 04 83 00 00 01 03 00"_hex;
    static constexpr auto two     = "2B 0E 04 83 00 00 02 02 00 03 00"_hex;
    static constexpr auto none    = "2B 0E 04 83 00 00 00"_hex;
    static constexpr auto stream  = "2B 0E 03 83 00 00 01 02 00"_hex;
    constexpr request     asked{id_code::specific, 2};
    constexpr request     streaming{id_code::extended, 2};
    VERIFY(asked.matches(*decode<response>(one)).ok());
    VERIFY(asked.matches(*decode<response>(another)) == error{errc::unexpected_reply, 7});
    VERIFY(asked.matches(*decode<response>(two)) == error{errc::unexpected_reply, 6});
    VERIFY(asked.matches(*decode<response>(none)) == error{errc::unexpected_reply, 6});
    VERIFY(asked.matches(*decode<response>(stream)) == error{errc::unexpected_reply, 2});
    VERIFY(streaming.matches(*decode<response>(stream)).ok());
    VERIFY(streaming.matches(*decode<response>(one)) == error{errc::unexpected_reply, 2});
}

//=== what a device answers ===//

/// Asks again until nothing more follows; every response goes over the wire.
std::vector<device_object> stream_of(id_code code, device_conformity conformity, std::span<device_object const> objects,
                                     std::vector<properties::byte_vector>& wires)
{
    std::vector<device_object> collected;
    auto                       next = id(0);
    for (std::size_t responses = 0; responses <= objects.size(); ++responses) {
        auto const asked = *request::make(code, next);
        auto const given = identification::answer(asked, conformity, objects);
        EXPECT_TRUE(given);
        if (not given) { return collected; }
        EXPECT_LE(given->wire_size(), max_pdu_size);
        EXPECT_TRUE(properties::round_trips(*given));
        wires.push_back(properties::wire_of(*given));

        auto const received = decode<response>(wires.back());
        EXPECT_TRUE(asked.matches(*received).ok());
        EXPECT_EQ(received->conformity(), conformity);
        for (auto const object : received->objects()) { collected.push_back(object); }
        if (not received->more_follows()) {
            EXPECT_EQ(received->next_object_id(), id(0));
            return collected;
        }
        EXPECT_FALSE(received->objects().empty());
        next = received->next_object_id();
    }
    ADD_FAILURE() << "the stream does not end";
    return collected;
}

TEST(read_device_identification, streams_every_object_once)
{
    std::mt19937                  random{21};
    properties::byte_vector const text(244, 0x41);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<device_object> objects;
        for (int number = 0; number <= 0xFF; ++number) {
            if (random() % 8 == 0) { objects.push_back({id(number), bytes{text}.first(random() % 245)}); }
        }
        std::vector<properties::byte_vector> wires;
        EXPECT_EQ(stream_of(id_code::extended, device_conformity::extended_and_specific, objects, wires), objects);
    }
}

TEST(read_device_identification, splits_where_a_pdu_is_full)
{
    properties::byte_vector const    text(244, 0x41);
    std::array<device_object, 3>     objects{{{id(0), bytes{text}.first(120)}, {id(1), bytes{text}.first(122)}, {id(2), {}}}};
    std::vector<properties::byte_vector> wires;
    // 7 + 2 + 120 + 2 + 122 = 253: the two first fill a PDU.
    EXPECT_EQ(stream_of(id_code::basic, device_conformity::basic_stream, objects, wires).size(), 3U);
    ASSERT_EQ(wires.size(), 2U);
    EXPECT_EQ(wires[0].size(), 253U);
    EXPECT_EQ(wires[0][4], 0xFF);
    EXPECT_EQ(wires[0][5], 2);
    EXPECT_EQ(wires[0][6], 2);
    EXPECT_EQ(wires[1][4], 0x00);
    EXPECT_EQ(wires[1][6], 1);

    wires.clear();
    objects[1].value = bytes{text}.first(123);  // one byte more
    EXPECT_EQ(stream_of(id_code::basic, device_conformity::basic_stream, objects, wires).size(), 3U);
    ASSERT_EQ(wires.size(), 2U);
    EXPECT_EQ(wires[0][5], 1);
    EXPECT_EQ(wires[0][6], 1);
}

constexpr std::array<device_object, 8> mixed_objects{{{id(0x00), {}},
                                                      {id(0x01), {}},
                                                      {id(0x02), {}},
                                                      {id(0x03), {}},
                                                      {id(0x7F), {}},
                                                      {id(0x80), {}},
                                                      {id(0x90), {}},
                                                      {id(0xFF), {}}}};

constexpr std::size_t count_of(id_code code, device_conformity conformity)
{
    return identification::answer(*request::make(code, id(0)), conformity, mixed_objects)->objects().size();
}

TEST(read_device_identification, streams_the_category_asked_for)
{
    VERIFY(count_of(id_code::basic, device_conformity::extended_and_specific) == 3);
    VERIFY(count_of(id_code::regular, device_conformity::extended_and_specific) == 5);
    VERIFY(count_of(id_code::extended, device_conformity::extended_and_specific) == 8);
}

TEST(read_device_identification, streams_no_more_than_the_device_s_conformity)
{
    using enum device_conformity;
    VERIFY(count_of(id_code::extended, basic_stream) == 3 and count_of(id_code::extended, basic_and_specific) == 3);
    VERIFY(count_of(id_code::regular, basic_stream) == 3);
    VERIFY(count_of(id_code::extended, regular_stream) == 5 and count_of(id_code::extended, regular_and_specific) == 5);
    VERIFY(count_of(id_code::extended, extended_stream) == 8);
    VERIFY(count_of(id_code::basic, basic_stream) == 3);
}

TEST(read_device_identification, begins_at_the_object_asked_for)
{
    constexpr auto first_of = [](id_code code, int object) {
        auto const given = identification::answer(*request::make(code, id(object)),
                                                  device_conformity::extended_and_specific, mixed_objects);
        return (*given->objects().begin()).id;
    };
    VERIFY(first_of(id_code::extended, 0x00) == id(0x00));
    VERIFY(first_of(id_code::extended, 0x80) == id(0x80));
    VERIFY(first_of(id_code::regular, 0x7F) == id(0x7F));
}

TEST(read_device_identification, begins_at_0_for_an_object_that_is_not_in_the_stream)
{
    constexpr auto count = [](id_code code, int object) {
        return identification::answer(*request::make(code, id(object)), device_conformity::extended_and_specific, mixed_objects)
            ->objects()
            .size();
    };
    VERIFY(count(id_code::extended, 0x04) == 8);  // no such object
    VERIFY(count(id_code::basic, 0x03) == 3);     // there is, but not in this category
    VERIFY(count(id_code::regular, 0x80) == 5);
}

TEST(read_device_identification, gives_one_specific_object)
{
    for (auto const& object : mixed_objects) {
        auto const asked = *request::make(id_code::specific, object.id);
        auto const given = identification::answer(asked, device_conformity::basic_and_specific, mixed_objects);
        ASSERT_TRUE(given);
        EXPECT_FALSE(given->more_follows());
        EXPECT_EQ(given->objects().size(), 1U);
        EXPECT_TRUE(asked.matches(*given).ok());
        EXPECT_TRUE(properties::round_trips(*given));
    }
}

TEST(read_device_identification, refuses_a_specific_object_that_there_is_not)
{
    constexpr auto refusal = [](int object, device_conformity conformity) {
        return identification::answer(*request::make(id_code::specific, id(object)), conformity, mixed_objects).error();
    };
    VERIFY(refusal(0x04, device_conformity::extended_and_specific) == exception_code::illegal_data_address);
    VERIFY(refusal(0x81, device_conformity::extended_and_specific) == exception_code::illegal_data_address);
    VERIFY(refusal(0x00, device_conformity::extended_stream) == exception_code::illegal_data_value);
}

TEST(read_device_identification, refuses_an_object_that_fits_no_response)
{
    static constexpr std::array<std::uint8_t, 246> text{};
    constexpr auto answer_to = [](std::size_t size, id_code code) {
        std::array<device_object, 1> const objects{{{device_object_id{}, bytes{text}.first(size)}}};
        auto const given = identification::answer(*request::make(code, device_object_id{}),
                                                  device_conformity::basic_and_specific, objects);
        return given ? exception_code{} : given.error();
    };
    VERIFY(answer_to(244, id_code::basic) == exception_code{});
    VERIFY(answer_to(244, id_code::specific) == exception_code{});
    VERIFY(answer_to(245, id_code::basic) == exception_code::server_device_failure);
    VERIFY(answer_to(245, id_code::specific) == exception_code::server_device_failure);
}

TEST(read_device_identification, says_when_it_comes_to_an_object_that_fits_no_response)
{
    static constexpr std::array<std::uint8_t, 245> text{};
    static constexpr std::array<device_object, 2>  objects{{{id(0), {}}, {id(1), text}}};
    constexpr request                              from_0{id_code::basic};
    constexpr request                              from_1{id_code::basic, 1};
    constexpr auto given = identification::answer(from_0, device_conformity::basic_stream, objects);
    VERIFY(given->more_follows() and given->next_object_id() == id(1));
    VERIFY(identification::answer(from_1, device_conformity::basic_stream, objects).error()
           == exception_code::server_device_failure);
}

TEST(read_device_identification, of_a_device_without_objects_is_empty)
{
    constexpr request asked{id_code::basic};
    constexpr auto    given = identification::answer(asked, device_conformity::basic_stream, {});
    VERIFY(given.has_value() and given->objects().empty() and not given->more_follows());
    EXPECT_EQ(properties::wire_of(*given), properties::copy_of("2B 0E 01 01 00 00 00"_hex));
}

}  // namespace
