// EXPECT: undefined reference to `(end|_sbrk)'
#include <cstdlib>

int main()
{
    return std::malloc(16) == nullptr ? 1 : 0;
}
