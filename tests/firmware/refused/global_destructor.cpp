// EXPECT: undefined reference to `__dso_handle'
struct counter {
    ~counter() noexcept { asm volatile(""); }
};
counter global;

int main() {}
