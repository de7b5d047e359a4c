#include <drivecodec/drives/smd/fault.hpp>

#include "support/verify.hpp"

namespace {

using drivecodec::smd::fault;

// smd manual, tables 16 and 18.
static_assert(fault{0} == fault::no_fault);
static_assert(fault{1} == fault::output_transistor_fault);
static_assert(fault{2} == fault::high_drive_temperature);
static_assert(fault{3} == fault::high_dc_bus_voltage);
static_assert(fault{4} == fault::low_dc_bus_voltage);
static_assert(fault{5} == fault::thermal_overload);
static_assert(fault{6} == fault::control_fault);
static_assert(fault{7} == fault::external_fault);
static_assert(fault{8} == fault::serial_communication_failure);
static_assert(fault{9} == fault::start_error);
static_assert(fault{10} == fault::internal_fault_1_epm);
static_assert(fault{11} == fault::internal_fault_2);
static_assert(fault{12} == fault::internal_fault_3);
static_assert(fault{13} == fault::internal_fault_4);
static_assert(fault{14} == fault::internal_fault_5);
static_assert(fault{15} == fault::internal_fault_6);
static_assert(fault{16} == fault::internal_fault_7);
static_assert(fault{17} == fault::internal_fault_8);
static_assert(fault{18} == fault::internal_fault_9);
static_assert(fault{19} == fault::internal_fault_o);
static_assert(fault{20} == fault::single_phase_fault);
static_assert(fault{21} == fault::incompatibility_fault);
static_assert(fault{22} == fault::dynamic_brake_overheated);
static_assert(fault{23} == fault::remote_keypad_fault);
static_assert(fault{24} == fault::communication_fault);
static_assert(fault{25} == fault::earth_fault);
static_assert(fault{26} == fault::configuration_fault);

TEST(smd_manual, has_two_faults_of_the_serial_link_and_says_the_cause_of_one)
{
    // n22 = 3 trips FC3, which is 24; what raises 8, FC5, is not stated. Both are of the communication.
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        ASSERT_EQ(is_communication(fault{static_cast<std::uint16_t>(raw)}), raw == 8 or raw == 24) << raw;
    }
    VERIFY(is_communication(fault::communication_fault) and is_communication(fault::serial_communication_failure));
}

}  // namespace
