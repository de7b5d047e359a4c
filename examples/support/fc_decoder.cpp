// SPDX-License-Identifier: MIT
#include "fc_decoder.hpp"

#include "fc_json.hpp"
#include "vlt6000_traffic.hpp"

#include <drivecodec/fc/reader.hpp>
#include <drivecodec/text/fc.hpp>

namespace support {

namespace {

namespace fc = drivecodec::fc;

template <typename Layout>
class fc_decoder final : public reader_decoder<fc::basic_reader<Layout>> {
    using base = reader_decoder<fc::basic_reader<Layout>>;

public:
    fc_decoder(fc_options const& chosen, std::ostream& out)
        : base{fc::basic_reader<Layout>{chosen.expect}, chosen.json, out}, explains_{chosen.vlt6000}
    {}

    [[nodiscard]] bool is_waiting_for_response() const override { return is_waiting_; }

private:
    [[nodiscard]] std::string lines_of(fc::frame const& heard) override
    {
        auto const is_asked = heard.direction == fc::direction::request and not heard.address().is_broadcast();
        is_waiting_         = is_asked or heard.direction == fc::direction::unknown;
        std::array<char, fc::max_description_size> buffer;
        auto const                                 meaning = explains_ ? explain_vlt6000(heard) : std::string{};
        auto const line = this->json() ? to_json<Layout>(heard) : std::string{fc::describe<Layout>(heard, buffer)};
        return with_meaning(line, meaning, this->json());
    }

    [[nodiscard]] bool is_typical(fc::frame const& heard) const override { return not heard.address().is_reserved(); }

    void forget_request() override { is_waiting_ = false; }

    bool explains_;
    bool is_waiting_ = true;  // for all that is known, somebody was asked
};

template <unsigned ParameterBits, std::size_t Words = 2>
std::unique_ptr<protocol_decoder> make(fc_options const& chosen, std::ostream& out)
{
    if constexpr (Words < 16) {
        if (chosen.process_words > Words) { return make<ParameterBits, Words + 1>(chosen, out); }
    }
    return std::make_unique<fc_decoder<fc::data_layout<Words, ParameterBits>>>(chosen, out);
}

}  // namespace

std::unique_ptr<protocol_decoder> make_fc_decoder(fc_options const& chosen, std::ostream& out)
{
    return chosen.parameter_bits == 12 ? make<12>(chosen, out) : make<11>(chosen, out);
}

}  // namespace support
