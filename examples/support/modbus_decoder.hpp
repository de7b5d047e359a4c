// SPDX-License-Identifier: MIT
#pragma once

#include "decoder.hpp"
#include "modbus_json.hpp"
#include "xd1000_traffic.hpp"

#include <drivecodec/modbus/rtu/reader.hpp>
#include <drivecodec/text/modbus.hpp>

#include <vector>

namespace support {

struct modbus_options {
    drivecodec::modbus::rtu::expecting expect = drivecodec::modbus::rtu::expecting::either;
    bool                               json   = false;
    bool                               xd1000 = false;  ///< Explains the registers of this drive.
};

/// Modbus RTU. A response is read in the light of the request before it.
class modbus_decoder final : public reader_decoder<drivecodec::modbus::rtu::reader> {
public:
    modbus_decoder(modbus_options chosen, std::ostream& out)
        : reader_decoder{reader{chosen.expect}, chosen.json, out}, names_registers_{chosen.xd1000}
    {}

    [[nodiscard]] bool is_waiting_for_response() const override { return not request_.empty(); }

private:
    using reader = drivecodec::modbus::rtu::reader;

    [[nodiscard]] std::string lines_of(frame const& heard) override
    {
        namespace modbus      = drivecodec::modbus;
        auto const is_request = heard.direction == modbus::direction::request;
        auto const is_answer  = not is_request and not request_.empty() and request_.front() == heard.address();
        auto const asked      = is_answer ? drivecodec::bytes{request_}.subspan(1) : drivecodec::bytes{};

        std::array<char, modbus::max_description_size> buffer;
        auto const meaning = names_registers_ ? drive_.explain(heard, asked) : std::string{};
        auto const line    = json() ? to_json(heard, asked) : std::string{describe(heard, buffer, asked)};
        request_.clear();
        if (is_request) {
            auto const address_and_pdu = heard.raw.first(1 + heard.pdu().size());
            request_.assign(address_and_pdu.begin(), address_and_pdu.end());
        }
        return with_meaning(line, meaning, json());
    }

    void forget_request() override { request_.clear(); }

    std::vector<std::uint8_t> request_;  // address and PDU, until its response came
    bool                      names_registers_;
    xd1000_traffic            drive_;
};

}  // namespace support
