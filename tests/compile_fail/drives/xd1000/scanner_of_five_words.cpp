// EXPECT: the scanner has one to four input words
#include <drivecodec/xd1000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
using namespace drivecodec::xd1000;

#ifdef OK
constexpr auto no = scanner<outputs<cmd>, inputs<eta, rfrd, eti, acc>>::configuration();
#else
constexpr auto no = scanner<outputs<cmd>, inputs<eta, rfrd, eti, acc, cmd>>::configuration();
#endif
