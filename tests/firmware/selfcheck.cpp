// The library's own claims, checked on the processor it is made for.
#include "firmware.hpp"

#include <drivecodec/version.hpp>

namespace {

int failures = 0;

// The value itself, but unknown to the compiler, so that the check runs on the target.
template <typename T>
T opaque(T value) noexcept
{
    asm volatile("" : : "r"(&value) : "memory");
    return value;
}

void check(bool passed, char const* claim) noexcept
{
    if (passed) { return; }
    ++failures;
    firmware::write("FAILED: ");
    firmware::write(claim);
    firmware::write("\n");
}

}  // namespace

int main()
{
    check(opaque(DRIVECODEC_VERSION_MAJOR) == 0, "the version");
    firmware::write(failures == 0 ? "selfcheck passed\n" : "selfcheck FAILED\n");
    return failures;
}
