// live_line PROGRAM [ARGUMENT...]
//
// Opens a pseudo-terminal, runs `PROGRAM ARGUMENT... --device <its name>`, and sends it the bytes of each line of standard
// input, hexadecimal, with a silence behind. Waits after each line until the program has printed something. In the end it
// stops the program with SIGTERM, prints what it printed, and ends with its status.
#include "support/hex.hpp"
#include "support/serial_port.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace {

struct child {
    pid_t id;
    int   output;
};

child start(std::vector<std::string> words)
{
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) { return {-1, -1}; }

    std::vector<char*> arguments;
    for (auto& word : words) { arguments.push_back(word.data()); }
    arguments.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addclose(&actions, ends[0]);
    posix_spawn_file_actions_addclose(&actions, ends[1]);
    pid_t      id     = -1;
    auto const status = posix_spawn(&id, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    return {status == 0 ? id : -1, ends[0]};
}

/// Passes on what the program prints, once. False at the end of it, or if it is silent for ten seconds.
bool pass_on(child const& running)
{
    pollfd readable{running.output, POLLIN, 0};
    if (poll(&readable, 1, 10'000) <= 0) { return false; }
    std::array<char, 4096> buffer{};
    auto const             count = read(running.output, buffer.data(), buffer.size());
    if (count <= 0) { return false; }
    std::cout.write(buffer.data(), count);
    return true;
}

}  // namespace

int main(int argc, char** argv)
{
    constexpr std::chrono::milliseconds silence{100};

    auto line = support::serial_port::pseudo_terminal();
    if (not line or argc < 2) {
        std::cerr << "live_line: no pseudo-terminal, or no program\n";
        return 99;
    }
    std::vector<std::string> words(argv + 1, argv + argc);
    words.emplace_back("--device");
    words.emplace_back(line->name());
    auto const running = start(words);
    if (running.id < 0) {
        std::cerr << "live_line: cannot start " << words[0] << '\n';
        return 99;
    }

    for (std::string text; std::getline(std::cin, text);) {
        if (not line->write_all(support::parse_hex(text).bytes) or not pass_on(running)) { break; }
        std::this_thread::sleep_for(silence);
    }
    kill(running.id, SIGTERM);
    while (pass_on(running)) {}
    int status = 0;
    waitpid(running.id, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 99;
}
