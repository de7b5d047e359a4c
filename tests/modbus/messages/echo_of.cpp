#include <drivecodec/modbus/messages/echo_of.hpp>

#include <drivecodec/modbus/functions/write_single_register.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <type_traits>

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

using request = write_single_register::request;
using echo    = echo_of<request>;

constexpr request asked{.address = 1, .value = 3};

TEST(echo_of, has_the_fields_and_the_wire_form_of_its_request)
{
    constexpr echo answer{{.address = 1, .value = 3}};
    VERIFY(encode(answer) == encode(asked));
    VERIFY(*decode<echo>("06 00 01 00 03"_hex) == answer);
    VERIFY(answer.value == 3);
    VERIFY(readable_message<echo>);
}

TEST(echo_of, is_a_type_of_its_own)
{
    VERIFY(not std::is_same_v<echo, request>);
    VERIFY(std::is_same_v<decltype(echo::read({})), echo>);
    VERIFY(std::is_same_v<echo::function, request::function>);
}

TEST(echo_of, is_what_its_request_expects)
{
    VERIFY(asked.matches(asked.reply()).ok());
    VERIFY(std::is_same_v<decltype(asked.reply()), echo>);
}

}  // namespace
