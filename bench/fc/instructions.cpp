// The instructions that parameter telegrams take, of sixteen bytes, from the wire to their fields.
#include <drivecodec/fc.hpp>

namespace fc = drivecodec::fc;
using drivecodec::bytes;

#define MEASURED extern "C" [[gnu::noinline]]

constexpr auto drive = fc::address::long_format(7);

constexpr fc::parameter_request asked = fc::read_value(202, fc::data_not_valid);
constexpr auto request = fc::encode(drive, fc::write_word(202, 1000, fc::storage::ram, fc::data_not_valid));
constexpr auto response =
    fc::encode(drive, fc::parameter_response{fc::pke::from_raw(0x10CA), {}, 1000, fc::process_status{0x0F07, {}}});

/// What a slave does with a request: all rules and the BCC, then all its fields. False if it is refused.
MEASURED bool measured_decode_parameter_request(bytes wire, fc::telegram<fc::parameter_request>& to)
{
    auto const telegram = fc::decode<fc::parameter_request>(wire);
    if (telegram) { to = *telegram; }
    return telegram.has_value();
}

/// What a master does with a response: all rules, the BCC, whether it answers the request, then all its fields.
MEASURED bool measured_check_parameter_response(fc::address from, fc::parameter_request const& question, bytes wire,
                                                fc::parameter_response& to)
{
    auto const answer = fc::check(from, question, wire);
    if (answer) { to = *answer; }
    return answer.has_value();
}

int main()
{
    // Read anew each time: the compiler must not know what is in the telegrams.
    auto const opaque = [](auto const& known) {
        bytes value{known};
        asm volatile("" : "+m"(value) : : "memory");
        return value;
    };
    static fc::telegram<fc::parameter_request> heard{drive, asked};
    static fc::parameter_response              answer{};

    bool worked = measured_decode_parameter_request(opaque(request), heard);
    worked      = measured_check_parameter_response(drive, asked, opaque(response), answer) and worked;
    worked      = heard.data.value<std::uint16_t>() == std::uint16_t{1000} and worked;
    return worked and answer.value<std::uint16_t>() == std::uint16_t{1000} ? 0 : 1;
}
