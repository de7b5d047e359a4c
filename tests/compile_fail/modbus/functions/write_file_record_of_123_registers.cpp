// EXPECT: the record does not fit in a PDU
#include <drivecodec/modbus/functions/write_file_record.hpp>

using namespace drivecodec::modbus;

template <std::size_t N>
constexpr std::uint16_t words[N]{};

#ifdef OK
constexpr auto written = write_file_record::of(1, 0, words<122>);
#else
constexpr auto written = write_file_record::of(1, 0, words<123>);
#endif
