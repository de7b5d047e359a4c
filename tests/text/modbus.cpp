#include <drivecodec/text/modbus.hpp>

#include "support/verify.hpp"

namespace {

namespace modbus = drivecodec::modbus;

TEST(text_modbus, has_a_word_for_everything)
{
    VERIFY(to_string(drivecodec::errc::none) == "none");
    VERIFY(to_string(modbus::function_code::diagnostics) == "diagnostics");
    VERIFY(to_string(modbus::exception_code::acknowledge) == "acknowledge");
    VERIFY(to_string(modbus::diagnostic::return_query_data) == "return_query_data");
    VERIFY(to_string(modbus::device_object_id::vendor_url) == "vendor_url");
    VERIFY(to_string(modbus::comm_event_kind::send) == "send");
    VERIFY(to_string(modbus::word_order::abcd) == "abcd");
    VERIFY(to_string(modbus::rtu::parity::even) == "even");
    VERIFY(modbus::has_fields<modbus::read_coils::request>);
    VERIFY(modbus::max_description_size > 0);
}

}  // namespace
