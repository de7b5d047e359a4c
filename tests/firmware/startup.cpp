// Cortex-M: from reset to main() and out through semihosting. No C start files, no heap, no global constructors.
#include "firmware.hpp"

extern "C" {
extern std::uint32_t data_load, data_start, data_end, bss_start, bss_end, stack_top;
int                  main();
[[noreturn]] void    reset_handler();
[[noreturn]] void    fault_handler();
}

// The C standard library functions that the compiler itself calls come from newlib; everything else is in the image.
namespace firmware {

static std::uint32_t semihosting(std::uint32_t operation, void const* argument) noexcept
{
    register std::uint32_t r0 asm("r0") = operation;
    register void const*   r1 asm("r1") = argument;
    asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

void write(char const* text) noexcept { semihosting(0x04, text); }  // SYS_WRITE0

[[noreturn]] void exit(std::uint32_t status) noexcept
{
    std::uint32_t const block[] = {0x20026, status};  // ADP_Stopped_ApplicationExit
    semihosting(0x20, block);                         // SYS_EXIT_EXTENDED
    for (;;) {}
}

}  // namespace firmware

void fault_handler()
{
    firmware::write("fault\n");
    firmware::exit(99);
}

void reset_handler()
{
    std::uint32_t const* from = &data_load;
    for (auto* to = &data_start; to != &data_end;) { *to++ = *from++; }
    for (auto* to = &bss_start; to != &bss_end;) { *to++ = 0; }
    firmware::exit(static_cast<std::uint32_t>(main()));
}

struct vector_table {
    void const* stack;
    void (*reset)();
    void (*exceptions[14])();
};
__attribute__((section(".vectors"), used)) static vector_table const vectors{
    &stack_top, reset_handler, {fault_handler, fault_handler, fault_handler, fault_handler, fault_handler}};
