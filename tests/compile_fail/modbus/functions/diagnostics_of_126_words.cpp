// EXPECT: this_diagnostic_does_not_allow_this_data
#include <drivecodec/modbus/functions/diagnostics.hpp>

using namespace drivecodec::modbus;

template <std::size_t N>
constexpr std::uint16_t words[N]{};

#ifdef OK
constexpr auto asked = diagnostics::of(diagnostic::return_query_data, words<125>);
#else
constexpr auto asked = diagnostics::of(diagnostic::return_query_data, words<126>);
#endif
