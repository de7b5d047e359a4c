// EXPECT: a global constructor is linked in
struct counter {
    counter() noexcept { asm volatile(""); }
};
counter global;

int main() {}
