// The bus monitor on any recorded file: every byte is in one row once, every request ends in one way, what is written
// can be printed and is not wider than wished, and all of it counts like the stream readers do.
//
// Input: a byte that chooses the protocol and the look, then the file.
#include "fuzz_common.hpp"

#include "support/bus_monitor.hpp"
#include "support/recorded_line.hpp"

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>

namespace {

using support::line_protocol;

/// As the program does, but for a mistake, behind which it goes on. Gives how many bytes there were.
std::uint64_t feed(support::bus_monitor& monitor, std::string_view file)
{
    std::uint64_t all = 0;
    while (not file.empty()) {
        auto const end    = std::min(file.find('\n'), file.size());
        auto const parsed = support::parse_recorded(file.substr(0, end));
        file.remove_prefix(std::min(end + 1, file.size()));
        if (parsed.heard.column != 0) { FUZZ_ASSERT(not parsed.heard.problem.empty() and parsed.heard.column <= end); }
        all += parsed.heard.bytes.size();
        if (not parsed.heard.bytes.empty()) { monitor.hear(parsed.heard.bytes, parsed.time); }
        monitor.hear_nothing(parsed.time);
    }
    return all;
}

/// A column of dim zeros is as wide as its text: escape sequences take no room.
void check_lines(std::string const& written, std::size_t width, bool has_colours)
{
    std::istringstream in{written};
    for (std::string line; std::getline(in, line);) {
        std::size_t used = 0;
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (has_colours and line[i] == '\033') {
                i = line.find('m', i);
                FUZZ_ASSERT(i != std::string::npos);
                continue;
            }
            FUZZ_ASSERT(line[i] >= ' ' and line[i] <= '~');
            ++used;
        }
        FUZZ_ASSERT(width == 0 or used <= width);
    }
}

void check_counts(support::bus_monitor const& monitor)
{
    auto const& counted = monitor.statistics();
    for (auto const& [address, row] : counted.rows()) {
        // Every request that asks for an answer has one, or a silence; what nobody asked for is more.
        FUZZ_ASSERT(row.silences <= row.requests);
        if (address == 0) { FUZZ_ASSERT(row.silences == 0); }
        FUZZ_ASSERT(row.times.empty()
                    or (row.times.least() <= row.times.mean() and row.times.mean() <= row.times.most()));
        FUZZ_ASSERT(not row.times.empty() or row.times.most() == 0);
    }
    auto const total = counted.total();
    auto const says  = monitor.counters();
    FUZZ_ASSERT(total.requests + total.replies + total.refusals + total.unclear == says.frames);
    FUZZ_ASSERT(total.dropped_bytes == says.dropped_bytes and total.bad_checks == says.bad_checksums);
    FUZZ_ASSERT(monitor.is_healthy() == (total.dropped_bytes == 0 and total.silences == 0));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    if (size == 0) { return 0; }
    constexpr line_protocol      protocols[] = {line_protocol::unknown, line_protocol::modbus, line_protocol::fc};
    support::bus_monitor_options chosen;
    chosen.line.protocol      = protocols[data[0] % 3];
    chosen.json               = (data[0] & 0x08) != 0;
    chosen.look.has_colours   = (data[0] & 0x10) != 0 and not chosen.json;
    chosen.look.is_absolute   = (data[0] & 0x20) != 0;
    chosen.line.request_first = (data[0] & 0x40) != 0;
    if ((data[0] & 0x80) != 0) {
        for (auto const* const drive : {"1=vlt6000", "2=xd1000:fan", "5=smd"}) { chosen.drives.add(drive); }
    }

    std::ostringstream     out;
    support::bus_monitor   monitor{chosen, out};
    std::string_view const file{reinterpret_cast<char const*>(data) + 1, size - 1};
    auto const             all = feed(monitor, file);
    monitor.end(true);
    check_counts(monitor);
    FUZZ_ASSERT(monitor.shown_bytes() == all);
    check_lines(out.str(), chosen.json ? 0 : chosen.look.width, chosen.look.has_colours);

    out.str({});
    monitor.write_table();
    check_lines(out.str(), 0, chosen.look.has_colours);
    return 0;
}
