#include <drivecodec/drives/xd1000/scanner.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::literals;
using namespace drivecodec::xd1000;
using cia402::command;

constexpr std::array<std::uint16_t, 4> as_delivered_in{3201, 8604, 0, 0};
constexpr std::array<std::uint16_t, 4> as_delivered_out{8501, 8602, 0, 0};

TEST(xd1000_scanner, leaves_the_factory_with_command_and_speeds)
{
    constexpr scanner_configuration factory;
    VERIFY(factory.inputs() == as_delivered_in and factory.outputs() == as_delivered_out);
    VERIFY(scanner<>::configuration() == factory);
}

TEST(xd1000_scanner, is_set_up_with_two_writes)
{
    constexpr scanner_configuration factory;
    // 12701 = 319D, 12721 = 31B1
    VERIFY(encode(factory.write_inputs()) == "10 31 9D 00 04 08 0C 81 21 9C 00 00 00 00"_hex);
    VERIFY(encode(factory.write_outputs()) == "10 31 B1 00 04 08 21 35 21 9A 00 00 00 00"_hex);
}

TEST(xd1000_manual, says_values_are_written_in_706_but_those_are_addresses_and_values_go_to_708)
{
    // Reads 2 from 12741 = 31C5, writes 2 from 12761 = 31D9.
    VERIFY(encode(scanner<>::exchange(command::enable_operation, 1500_rpm))
           == "17 31 C5 00 02 31 D9 00 02 04 00 0F 05 DC"_hex);
}

TEST(xd1000_manual, has_cmi_as_its_third_word)
{
    using with_extended_words = scanner<outputs<cmd, lfrd, cmi>, inputs<eta, rfrd, eti>>;
    VERIFY(encode(with_extended_words::exchange(command::shutdown, -1_rpm, 0x1234))
           == "17 31 C5 00 03 31 D9 00 03 06 00 06 FF FF 12 34"_hex);
    constexpr auto configured = with_extended_words::configuration();
    VERIFY(configured.inputs()[2] == 3206 and configured.outputs()[2] == 8504);

    static constexpr std::array<std::uint16_t, 3> answer{0x0231, 0xFFFF, 0x5678};
    VERIFY(*decode_state(with_extended_words::value(eta, answer)) == cia402::state::ready_to_switch_on);
    VERIFY(with_extended_words::value(rfrd, answer) == -1_rpm);
    VERIFY(with_extended_words::value(eti, answer) == 0x5678);
}

TEST(xd1000_scanner, says_at_run_time_which_value_does_not_fit)
{
    VERIFY(scanner<>::make_exchange(command::shutdown, 1500_rpm).has_value());
    VERIFY(scanner<>::make_exchange(command::shutdown, 0.5_rpm).error() == error{errc::inexact, 1});
    VERIFY(scanner<>::make_exchange(command::shutdown, 40000_rpm).error() == error{errc::out_of_range, 1});
}

TEST(xd1000_scanner_configuration, is_checked)
{
    VERIFY(scanner_configuration::make(as_delivered_in, as_delivered_out).has_value());
    VERIFY(scanner_configuration::make({0, 0, 0, 1}, {}).error() == error{errc::bad_address, 3});
    VERIFY(scanner_configuration::make({}, {0, 1, 0, 0}).error() == error{errc::bad_address, 5});
    VERIFY(scanner_configuration::make({}, {8501, 0, 3201, 0}).error() == error{errc::read_only, 6});
}

TEST(xd1000_scanner_configuration, is_read_from_the_drive_as_it_is_written_to_it)
{
    VERIFY(encode(scanner_configuration::read_inputs()) == "03 31 9D 00 04"_hex);
    VERIFY(encode(scanner_configuration::read_outputs()) == "03 31 B1 00 04"_hex);

    static constexpr auto written = *scanner_configuration::make({3201, 8604, 3206, 0}, {8501, 0, 8504, 0});
    constexpr auto        seen    = scanner_configuration::decode(written.write_inputs().block.values().words,
                                                                  written.write_outputs().block.values().words);
    VERIFY(*seen == written);

    static constexpr std::array<std::uint16_t, 4> four{};
    static constexpr std::array<std::uint16_t, 3> three{};
    VERIFY(scanner_configuration::decode(three, four).error() == error{errc::bad_quantity, 0});
    VERIFY(scanner_configuration::decode(four, three).error() == error{errc::bad_quantity, 4});
}

TEST(xd1000_scanner_configuration, may_be_of_registers_that_the_manual_does_not_have)
{
    static constexpr std::array<std::uint16_t, 4> inputs{3202, 0, 0, 0};
    static constexpr std::array<std::uint16_t, 4> outputs{8501, 0, 0, 0};
    static constexpr std::array<std::uint16_t, 1> answer{500};
    constexpr auto                                seen = scanner_configuration::decode(inputs, outputs);
    VERIFY(seen.has_value() and not scanner_configuration::make(inputs, outputs));
    VERIFY(*seen->input(std::uint16_t{3202}, answer) == 500);
}

TEST(xd1000_scanner_configuration, exchanges_what_is_in_use)
{
    static constexpr std::array<std::uint16_t, 1> one{0x0006};
    static constexpr scanner_configuration        factory;
    constexpr auto                                asked = factory.exchange(one);
    VERIFY(asked->read_range.first() == 12741 and asked->read_range.count() == 2);
    VERIFY(asked->write_block.first() == 12761 and asked->write_block.count() == 1);

    static constexpr std::array<std::uint16_t, 5> five{};
    VERIFY(factory.exchange(five).error().code() == errc::bad_quantity);
    VERIFY(factory.exchange({}).error().code() == errc::bad_quantity);
    constexpr auto no_inputs = *scanner_configuration::make({}, as_delivered_out);
    VERIFY(no_inputs.exchange(one).error().code() == errc::bad_quantity);
}

TEST(xd1000_scanner_configuration, keeps_the_place_of_a_word_that_is_not_used)
{
    constexpr auto gap = *scanner_configuration::make({3201, 0, 8604, 0}, as_delivered_out);
    static constexpr std::array<std::uint16_t, 3> answer{0x0237, 0, 1500};
    static constexpr std::array<std::uint16_t, 1> one{0x0006};
    VERIFY(gap.exchange(one)->read_range.count() == 3);
    VERIFY(*gap.input(rfrd, answer) == 1500_rpm);
    VERIFY(*gap.input(eta, answer) == status_word::from_raw(0x0237));
    VERIFY(gap.input(eti, answer).error().code() == errc::bad_address);               // not mapped
    VERIFY(gap.input(std::uint16_t{0}, answer).error().code() == errc::bad_address);  // no register
    static constexpr std::array<std::uint16_t, 2> too_short{0x0237, 0};
    VERIFY(gap.input(rfrd, too_short).error().code() == errc::bad_address);
}

}  // namespace
