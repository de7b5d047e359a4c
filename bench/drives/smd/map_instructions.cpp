// The instructions that it takes to find a parameter of the smd drive while the program runs: those that the search comes
// to last.
#include <drivecodec/drives/smd/map.hpp>

namespace drives = drivecodec::drives;
namespace smd    = drivecodec::smd;

#define MEASURED extern "C" [[gnu::noinline]]

MEASURED drives::register_row const* measured_find_by_address(smd::map drive, std::uint16_t address)
{
    return drive.find(address);
}

MEASURED drives::register_row const* measured_find_by_code(smd::map drive, std::string_view code)
{
    return drive.find(code);
}

int main()
{
    smd::map drive{smd::pv507};
    asm volatile("" : "+m"(drive) : : "memory");  // read anew: the compiler must not know the version
    auto const* by_address = measured_find_by_address(drive, 133);
    auto const* by_code    = measured_find_by_code(drive, "n23");
    return by_address != nullptr and by_address == by_code ? 0 : 1;
}
