#include <drivecodec/drives/smd/map.hpp>
#include <drivecodec/drives/smd/parameters.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::literals;
using smd::pv400;
using smd::pv507;

TEST(smd_parameters, are_written_where_their_version_has_them)
{
    VERIFY(smd::C12<pv507>.write(5.0_s) == smd::write_single_register::request{61, 50});
    VERIFY(smd::n23<pv400>.write(100_ms) == smd::write_single_register::request{115, 100});
    VERIFY(smd::n23<pv507>.write(100_ms) == smd::write_single_register::request{133, 100});
    VERIFY(smd::C34<pv400>.address() == 71 and smd::C34<pv507>.address() == 72 and smd::C31<pv507>.address() == 71);
    VERIFY(smd::C01<pv507>.address() == 51 and smd::c01<pv507>.address() == 96);
    VERIFY(smd::C12<pv507>.read().range.first() == 61 and smd::C12<pv507>.read().range.count() == 1);
}

TEST(smd_parameters, say_at_run_time_why_they_are_not_written)
{
    VERIFY(smd::C12<pv400>.make_write(5.05_s).error() == error{errc::inexact, 0});
    VERIFY(smd::C12<pv400>.make_write(999.1_s).error() == error{errc::out_of_range, 0});
    VERIFY(smd::C46<pv400>.make_write(1_Hz).error() == error{errc::read_only, 0});
    VERIFY(smd::CE1<pv400>.make_write(smd::digital_input_function{0}).error() == error{errc::out_of_range, 0});
    VERIFY(smd::C09<pv507>.make_write(0).error() == error{errc::out_of_range, 0});
}

TEST(smd_parameters, are_of_their_types)
{
    VERIFY(smd::C01<pv507>.write(smd::control_mode::c40_modbus).value == 11);
    VERIFY(smd::C02<pv507>.value(3) == smd::load_defaults::load_oem_defaults);
    VERIFY(smd::CE3<pv507>.value(3) == smd::digital_input_function::dc_braking);
    VERIFY(smd::C08<pv507>.value(1) == smd::output_function::fault);
    VERIFY(smd::C14<pv507>.value(2) == smd::operating_mode::linear_with_constant_boost);
    VERIFY(smd::C18<pv507>.value(2) == smd::chopper_frequency::chopper_8_khz);
    VERIFY(smd::C22<pv507>.value(150) == 150_percent and smd::C16<pv507>.value(40) == 4.0_percent);
    VERIFY(smd::C37<pv507>.value(200) == 20_Hz and smd::C37<pv507>.write(999_Hz).value == 9990);
    VERIFY(smd::c08<pv400>.value(1000).scaled_to(0) == 100 and smd::C94<pv400>.value(999) == 999);
    VERIFY(smd::c25<pv400>.value(1) == smd::serial_format::format_8n1);
    VERIFY(smd::c61<pv400>.value(24) == smd::fault::communication_fault);
    VERIFY(smd::c70<pv507>.value(1) == smd::trip_reset::auto_reset);
    VERIFY(smd::n20<pv507>.value(1) == smd::power_up_state::inhibit);
    VERIFY(smd::n22<pv507>.write(smd::serial_timeout_action::quick_stop).value == 2);
    VERIFY(smd::C99<pv400>.read().range.count() == 4);
    VERIFY(smd::parameter<"C12", pv400>.address() == 61);
}

TEST(smd_parameters, keep_unknown_codes_as_numbers)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const word = static_cast<std::uint16_t>(raw);
        ASSERT_EQ(static_cast<unsigned>(smd::C14<pv507>.value(word)), raw);
        ASSERT_EQ(static_cast<unsigned>(smd::C01<pv507>.value(word)), raw);
        ASSERT_EQ(smd::C14<pv507>.make_write(smd::C14<pv507>.value(word)).has_value(), raw <= 3);
    }
}

TEST(smd_parameters, give_back_what_they_were_given)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const word = static_cast<std::uint16_t>(raw);
        auto const made = smd::C12<pv507>.make_write(smd::C12<pv507>.value(word));
        ASSERT_EQ(made.has_value(), raw <= 9990);
        if (made) { ASSERT_EQ(made->value, raw); }
    }
}

TEST(smd_parameters, are_all_there_by_code)
{
    constexpr smd::map map{pv507};
    int                count = 0;
    auto const         is    = [&](auto const& parameter, std::string_view code) {
        EXPECT_EQ(parameter.address(), map.find(code)->address) << code;
        ++count;
    };
#define IS(CODE) is(smd::CODE<pv507>, #CODE)
    IS(C01), IS(C02), IS(CE1), IS(CE2), IS(CE3), IS(C08), IS(C09), IS(C10), IS(C11), IS(C12), IS(C13), IS(C14), IS(C15);
    IS(C16), IS(C17), IS(C18), IS(C21), IS(C22), IS(C24), IS(C31), IS(C34), IS(C36), IS(C37), IS(C38), IS(C39), IS(C46);
    IS(C50), IS(C52), IS(C53), IS(C54), IS(C56), IS(C59), IS(C70), IS(C71), IS(C90), IS(C94), IS(C99), IS(c01), IS(c03);
    IS(c06), IS(c08), IS(c11), IS(c17), IS(c20), IS(c25), IS(c38), IS(c40), IS(c42), IS(c60), IS(c61), IS(c62), IS(c63);
    IS(c70), IS(c71), IS(c78), IS(c79), IS(c81), IS(c82), IS(c86), IS(c87), IS(d25), IS(d38), IS(d46), IS(d47), IS(n20);
    IS(n22), IS(n23);
#undef IS
    EXPECT_EQ(count, 67);
}

}  // namespace
