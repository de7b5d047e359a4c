// SPDX-License-Identifier: MIT
#pragma once

#include "decoder.hpp"
#include "modbus_json.hpp"

#include <drivecodec/modbus/rtu/reader.hpp>
#include <drivecodec/text/modbus.hpp>

#include <functional>
#include <vector>

namespace support {

/// What a frame means to a drive, with the PDU of the request heard before if this is its reply. Empty: nothing known.
using modbus_explainer = std::function<std::string(drivecodec::modbus::rtu::frame const&, drivecodec::bytes asked)>;

struct modbus_options {
    drivecodec::modbus::rtu::expecting expect  = drivecodec::modbus::rtu::expecting::either;
    style                              how     = style::text;
    modbus_explainer                   explain = {};
};

/// Modbus RTU. A response is read in the light of the request before it.
class modbus_decoder final : public reader_decoder<drivecodec::modbus::rtu::reader> {
public:
    modbus_decoder(modbus_options chosen, sink out)
        : reader_decoder{reader{chosen.expect}, chosen.how, std::move(out)}, explain_{std::move(chosen.explain)}
    {}

private:
    using reader = drivecodec::modbus::rtu::reader;

    [[nodiscard]] static bool is_request(frame const& heard)
    {
        return heard.direction == drivecodec::modbus::direction::request;
    }

    [[nodiscard]] traffic_item item_of(frame const& heard) const override
    {
        auto const is_asked = is_request(heard) and heard.address() != 0
                              and drivecodec::modbus::public_functions::expects_reply(heard.pdu());
        return {.kind          = is_request(heard)      ? traffic::request
                                 : heard.is_exception() ? traffic::refusal
                                                        : traffic::reply,
                .protocol      = "Modbus",
                .address       = heard.address(),
                .expects_reply = is_asked};
    }

    [[nodiscard]] bool answers_request(frame const& heard) const override
    {
        return not request_.empty() and request_.front() == to_byte(heard.function());
    }

    void describe(frame const& heard, traffic_item& item) override
    {
        namespace modbus = drivecodec::modbus;
        auto const asked = item.is_answer ? drivecodec::bytes{request_} : drivecodec::bytes{};
        if (explain_) { item.meaning = explain_(heard, asked); }
        if (how() == style::json) {
            item.text = to_json(heard, asked);
        } else {
            std::array<char, modbus::max_description_size> buffer;
            item.text = modbus::rtu::describe(heard, buffer, asked);
        }
        if (how() == style::content) {  // behind `server 17  request  `
            auto const word = to_string(heard.direction);
            item.text.erase(0, item.text.find_first_not_of(' ', item.text.find(word) + word.size()));
        }
        request_.clear();
        if (item.expects_reply) { request_.assign(heard.pdu().begin(), heard.pdu().end()); }
    }

    [[nodiscard]] std::optional<std::uint8_t> damaged_address(drivecodec::bytes raw) const override
    {
        return raw.front();
    }

    void forget_request() override { request_.clear(); }

    std::vector<std::uint8_t> request_;  // PDU, until its response came
    modbus_explainer          explain_;
};

}  // namespace support
