#include <drivecodec/drives/smd/exchange.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::smd;

TEST(smd_exchange, is_a_write_but_for_none_and_the_poll)
{
    for (unsigned number = 0; number <= static_cast<unsigned>(step::lock); ++number) {
        auto const what = step{static_cast<std::uint8_t>(number)};
        EXPECT_EQ((exchange{what, {1, 4}}.is_write()), what != step::none and what != step::poll_status);
    }
    VERIFY(exchange{}.what == step::none and not exchange{}.is_write());
    VERIFY((exchange{step::stop, {1, 0x0004}}.write.value) == 4);
}

}  // namespace
