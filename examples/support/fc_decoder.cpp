// SPDX-License-Identifier: MIT
#include "fc_decoder.hpp"

#include "fc_json.hpp"

#include <drivecodec/fc/reader.hpp>
#include <drivecodec/text/fc.hpp>

namespace support {

namespace {

namespace fc = drivecodec::fc;

/// 0: all of them.
[[nodiscard]] std::uint8_t slave_of(fc::address of)
{
    constexpr std::uint8_t reserved = 255;  // whichever it is: no slave has it
    return of.is_broadcast() ? std::uint8_t{0} : of.is_reserved() ? reserved : of.number();
}

template <typename Layout>
class fc_decoder final : public reader_decoder<fc::basic_reader<Layout>> {
    using base = reader_decoder<fc::basic_reader<Layout>>;

public:
    fc_decoder(fc_options const& chosen, sink out)
        : base{fc::basic_reader<Layout>{chosen.expect}, chosen.how, std::move(out)}, explain_{chosen.explain}
    {}

    [[nodiscard]] bool is_waiting_for_response() const override
    {
        return base::is_waiting_for_response() or is_unclear_;
    }

private:
    [[nodiscard]] static traffic kind_of(fc::frame const& heard)
    {
        switch (heard.direction) {
        case fc::direction::request: return traffic::request;
        case fc::direction::unknown: return traffic::unclear;
        case fc::direction::response: break;
        }
        auto const is_refusal = heard.kind<Layout>() == fc::data_kind::parameter
                                and fc::ak_reply{heard.ak()} == fc::ak_reply::cannot_be_executed;
        return is_refusal ? traffic::refusal : traffic::reply;
    }

    [[nodiscard]] traffic_item item_of(fc::frame const& heard) const override
    {
        auto const kind = kind_of(heard);
        return {.kind          = kind,
                .protocol      = "FC",
                .address       = slave_of(heard.address()),
                .expects_reply = kind == traffic::request and not heard.address().is_broadcast()};
    }

    void describe(fc::frame const& heard, traffic_item& item) override
    {
        is_unclear_ = item.kind == traffic::unclear;
        if (explain_) { item.meaning = explain_(heard); }
        if (this->how() == style::json) {
            item.text = to_json<Layout>(heard);
        } else {
            std::array<char, fc::max_description_size> buffer;
            item.text = fc::describe<Layout>(heard, buffer);
        }
        if (this->how() == style::content) {  // behind `request to slave 1: `
            constexpr std::string_view behind_address = ": ";
            item.text.erase(0, item.text.find(behind_address) + behind_address.size());
        }
    }

    [[nodiscard]] std::optional<std::uint8_t> damaged_address(drivecodec::bytes raw) const override
    {
        constexpr auto adr = fc::layout::telegram::adr;
        if (raw.front() != fc::stx or raw.size() < adr.end) { return std::nullopt; }
        return slave_of(fc::address::from_byte(adr.load(raw)));
    }

    [[nodiscard]] bool is_typical(fc::frame const& heard) const override { return not heard.address().is_reserved(); }

    void forget_request() override { is_unclear_ = false; }

    fc_explainer explain_;
    bool         is_unclear_ = true;  // for all that is known, somebody was asked
};

template <unsigned ParameterBits, std::size_t Words = 2>
std::unique_ptr<protocol_decoder> make(fc_options const& chosen, sink out)
{
    if constexpr (Words < 16) {
        if (chosen.process_words > Words) { return make<ParameterBits, Words + 1>(chosen, std::move(out)); }
    }
    return std::make_unique<fc_decoder<fc::data_layout<Words, ParameterBits>>>(chosen, std::move(out));
}

}  // namespace

std::unique_ptr<protocol_decoder> make_fc_decoder(fc_options const& chosen, sink out)
{
    return chosen.parameter_bits == 12 ? make<12>(chosen, std::move(out)) : make<11>(chosen, std::move(out));
}

}  // namespace support
