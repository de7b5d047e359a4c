#include <drivecodec/modbus/functions/write_file_record.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

#include <random>

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

using request  = write_file_record::request;
using response = write_file_record::response;

constexpr std::array<std::uint16_t, 3>   words{0x06AF, 0x04BE, 0x100D};
constexpr std::array<std::uint16_t, 124> zeros{};

constexpr file_record record_of(std::uint16_t file, std::uint16_t record, register_view values)
{
    return *file_record::make(file, record, values);
}

TEST(write_file_record, is_what_the_specification_prints)
{
    static constexpr std::array<file_record, 1> records{record_of(4, 7, words)};
    constexpr auto                              asked    = *request::make(records);
    constexpr auto                              constant = write_file_record::of(4, 7, {0x06AF, 0x04BE, 0x100D});
    VERIFY(encode(constant) == vectors::write_file_record);
    VERIFY(encode(constant.reply()) == vectors::write_file_record);
    VERIFY(*decode<request>(vectors::write_file_record) == asked);
    EXPECT_EQ(properties::wire_of(asked), properties::copy_of(vectors::write_file_record));
    EXPECT_EQ(properties::wire_of(asked.reply()), properties::copy_of(vectors::write_file_record));
    VERIFY(decode<response>(vectors::write_file_record)->records().size() == 1);
    VERIFY(asked.echo_size() == 15);
}

//=== limits ===//

TEST(write_file_record, has_a_byte_count_from_9_to_251)
{
    for (unsigned size = 0; size <= 0xFF; ++size) {
        properties::byte_vector pdu{0x15, static_cast<std::uint8_t>(size), 6, 0, 1, 0, 0, 0,
                                    static_cast<std::uint8_t>(size < 7 ? 0 : (size - 7) / 2)};
        pdu.resize(2 + size);

        auto const fault = request::check(pdu);
        if (size < 9 or size > 251) {
            EXPECT_EQ(fault, (error{errc::bad_quantity, 1})) << size;
        } else if (size % 2 == 0) {
            EXPECT_EQ(fault, (error{errc::bad_length, 2 + size - 1})) << size;  // a byte behind the record
        } else {
            EXPECT_EQ(fault, error{}) << size;
        }
        EXPECT_EQ(response::check(pdu), fault) << size;
    }
}

TEST(write_file_record, writes_up_to_122_registers)
{
    for (std::size_t count = 1; count <= 124; ++count) {
        std::array<file_record, 1> const records{record_of(1, 0, register_view{zeros}.subview(0, count))};
        auto const                       made = request::make(records);
        EXPECT_EQ(made.has_value(), count <= 122) << count;
        if (made) { EXPECT_TRUE(properties::round_trips(*made)) << count; }
    }
    VERIFY(request::make({}).error() == error{errc::bad_quantity, 1});
}

TEST(write_file_record, checks_every_record)
{
    VERIFY(request::check("15 09 05 00 01 00 00 00 01 00 00"_hex) == error{errc::bad_value, 2});
    VERIFY(request::check("15 09 06 00 00 00 00 00 01 00 00"_hex) == error{errc::bad_address, 3});
    VERIFY(request::check("15 09 06 00 01 27 10 00 01 00 00"_hex) == error{errc::bad_address, 5});
    VERIFY(request::check("15 0B 06 00 01 27 0F 00 02 00 00 00 00"_hex) == error{errc::bad_address, 5});
    VERIFY(request::check("15 09 06 00 01 27 0F 00 01 00 00"_hex).ok());
    VERIFY(request::check("15 12 06 00 01 00 00 00 01 00 00 06 00 00 00 00 00 01 00 00"_hex)
           == error{errc::bad_address, 12});
}

// Record counts that are longer than the frame, and those that overflow when they are doubled.
TEST(write_file_record, refuses_every_length_that_is_not_that_of_its_bytes)
{
    for (unsigned count = 0; count <= 0xFFFF; ++count) {
        std::array<std::uint8_t, 13> const pdu{0x15, 11, 6, 0, 1, 0, 0, static_cast<std::uint8_t>(count >> 8),
                                               static_cast<std::uint8_t>(count)};
        auto const fault = request::check(pdu);
        if (count == 2) {
            ASSERT_EQ(fault, error{});
        } else {
            ASSERT_TRUE(fault.code() == errc::bad_length or fault.code() == errc::bad_quantity) << count;
        }
    }
    VERIFY(request::check("15 0B 06 00 01 00 00 7F FD 00 00 00 00"_hex) == error{errc::bad_length, 2});  // 65537 bytes
    VERIFY(request::check("15 0B 06 00 01 00 00 80 02 00 00 00 00"_hex) == error{errc::bad_length, 2});  // 65547 bytes
}

//=== both ways ===//

TEST(write_file_record, survives_encoding_and_decoding)
{
    std::mt19937               random{19};
    std::vector<std::uint16_t> values(60);
    for (auto& value : values) { value = static_cast<std::uint16_t>(random()); }
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<file_record> records;
        for (std::size_t count = 1 + random() % 6; count > 0; --count) {
            auto const part = register_view{values}.subview(random() % 40, 1 + random() % 15);
            records.push_back(record_of(static_cast<std::uint16_t>(1 + random() % 0xFFFF),
                                        static_cast<std::uint16_t>(random() % 9980), part));
        }
        auto const made = request::make(std::span<file_record const>{records});
        ASSERT_TRUE(made);
        ASSERT_TRUE(properties::round_trips(*made));
        ASSERT_TRUE(properties::round_trips(made->reply()));
        ASSERT_TRUE(made->matches(made->reply()).ok());
    }
}

TEST(write_file_record, is_answered_by_its_echo)
{
    constexpr auto asked = *decode<request>(vectors::write_file_record);
    VERIFY(asked.matches(*decode<response>(vectors::write_file_record)).ok());
    for (std::size_t bit = 16; bit < 8 * vectors::write_file_record.size(); ++bit) {
        auto changed     = vectors::write_file_record;
        changed[bit / 8] = static_cast<std::uint8_t>(changed[bit / 8] ^ (1U << bit % 8));
        auto const other = decode<response>(changed);
        if (other) { EXPECT_EQ(asked.matches(*other), (error{errc::unexpected_reply, 2})) << bit; }
    }
}

}  // namespace
