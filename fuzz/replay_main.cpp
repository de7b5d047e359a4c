// In the place of a fuzzing engine: runs a fuzzer over files and folders, with any compiler and on any machine.
#include "fuzz_common.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

int main(int argc, char** argv)
{
    namespace fs = std::filesystem;

    std::vector<fs::path> files;
    for (int i = 1; i < argc; ++i) {
        fs::path const path{argv[i]};
        if (fs::is_directory(path)) {
            for (auto const& entry : fs::recursive_directory_iterator(path)) {
                if (entry.is_regular_file()) { files.push_back(entry.path()); }
            }
        } else {
            files.push_back(path);
        }
    }
    std::sort(files.begin(), files.end());

    for (auto const& file : files) {
        std::ifstream     stream{file, std::ios::binary};
        std::string const content{std::istreambuf_iterator<char>{stream}, {}};
        if (not stream) {
            std::fprintf(stderr, "cannot read %s\n", file.c_str());
            return 1;
        }
        // A block of exactly this size: a sanitizer, or valgrind, sees a read past its end.
        auto const exact = std::make_unique<std::uint8_t[]>(content.size());
        std::copy(content.begin(), content.end(), exact.get());
        LLVMFuzzerTestOneInput(exact.get(), content.size());
    }
    std::printf("replayed %zu inputs\n", files.size());
    return files.empty() ? 1 : 0;  // a corpus that was not found is no success
}
