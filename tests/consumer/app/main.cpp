#include <drivecodec/drivecodec.hpp>
#include <drivecodec/version.hpp>

int main()
{
    return DRIVECODEC_VERSION_MAJOR == 0 ? 0 : 1;
}
