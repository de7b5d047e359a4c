# 32-bit words on a 64-bit host: std::size_t is unsigned int, as in firmware.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR i386)
set(CMAKE_CXX_COMPILER g++)
set(CMAKE_C_COMPILER gcc)
# Debian's g++-12-multilib, which unlike g++-multilib goes with the cross compilers, does not find asm/ itself.
set(CMAKE_CXX_FLAGS_INIT "-m32 -isystem /usr/include/x86_64-linux-gnu")
set(CMAKE_C_FLAGS_INIT "${CMAKE_CXX_FLAGS_INIT}")
set(CMAKE_CROSSCOMPILING_EMULATOR env)
