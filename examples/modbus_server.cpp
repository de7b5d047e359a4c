// SPDX-License-Identifier: MIT
//
// A Modbus RTU server on a serial device, or on a pseudo-terminal that it opens and names:
//
//     modbus_server --address 17 --link /tmp/drive &
//     modbus_poll --device /tmp/drive --address 17 read-holding 107 3
//
// The first line it prints is the path of the device. It ends with Ctrl-C, and then prints its counters.
#include "support/arguments.hpp"
#include "support/data_model.hpp"
#include "support/line_server.hpp"
#include "support/rtu_line.hpp"
#include "support/server_counters.hpp"

#include <drivecodec/modbus.hpp>
#include <drivecodec/text/modbus.hpp>
#include <drivecodec/version.hpp>

#include <array>
#include <iostream>
#include <string>
#include <system_error>
#include <utility>

namespace modbus = drivecodec::modbus;
namespace rtu    = modbus::rtu;

namespace {

using line_options = support::line_options<support::rtu_line>;
using line_server  = support::line_server<support::rtu_line>;

template <std::size_t N>
[[nodiscard]] consteval std::array<std::uint8_t, N - 1> ascii(char const (&text)[N])
{
    std::array<std::uint8_t, N - 1> out{};
    for (std::size_t i = 0; i < out.size(); ++i) { out[i] = static_cast<std::uint8_t>(text[i]); }
    return out;
}

//=== what it serves ===//

/// The handler: what it has an overload for is served; the library answers everything else with an exception.
class device {
public:
    explicit device(support::data_model model) : model_{std::move(model)} {}

    support::server_counters counters;
    support::event_log       log;
    bool                     listens_only = false;

    template <typename T>
    using answer = modbus::answer<T>;
    using done   = modbus::done;
    using enum modbus::exception_code;

    void refresh() { model_.refresh(counters.server_messages); }

    //=== coils and discrete inputs ===//

    answer<modbus::coil_view> operator()(modbus::read_coils::request const& asked) const
    {
        return model_.coils.read<modbus::coil_view>(asked.range.first(), asked.range.count());
    }
    answer<modbus::coil_view> operator()(modbus::read_discrete_inputs::request const& asked) const
    {
        return model_.discrete_inputs.read<modbus::coil_view>(asked.range.first(), asked.range.count());
    }
    answer<done> operator()(modbus::write_single_coil::request const& asked)
    {
        return model_.coils.write(asked.address, std::array{asked.value});
    }
    answer<done> operator()(modbus::write_multiple_coils::request const& asked)
    {
        return model_.coils.write(asked.block.first(), asked.block.values());
    }

    //=== registers ===//

    answer<modbus::register_view> operator()(modbus::read_holding_registers::request const& asked) const
    {
        return read_holding(asked.range.first(), asked.range.count());
    }
    answer<modbus::register_view> operator()(modbus::read_input_registers::request const& asked) const
    {
        return model_.input_registers.read<modbus::register_view>(asked.range.first(), asked.range.count());
    }
    answer<done> operator()(modbus::write_single_register::request const& asked)
    {
        return write_holding(asked.address, std::array{asked.value});
    }
    answer<done> operator()(modbus::write_multiple_registers::request const& asked)
    {
        return write_holding(asked.block.first(), asked.block.values());
    }
    answer<done> operator()(modbus::mask_write_register::request const& asked)
    {
        auto const current = read_holding(asked.address, 1);
        if (not current) { return current.error(); }
        return write_holding(asked.address, std::array{asked.apply((*current)[0])});
    }
    answer<modbus::register_view> operator()(modbus::read_write_multiple_registers::request const& asked)
    {
        auto const read = read_holding(asked.read_range.first(), asked.read_range.count());
        if (not read) { return read; }  // writes nothing, either
        auto const wrote = write_holding(asked.write_block.first(), asked.write_block.values());
        if (not wrote) { return wrote.error(); }
        return read;  // a view: it shows what was written
    }
    answer<modbus::read_fifo_queue::response> operator()(modbus::read_fifo_queue::request const& asked) const
    {
        if (asked.address != model_.queue_address) { return illegal_data_address; }
        return respond<modbus::read_fifo_queue::response>(modbus::register_view{model_.queue});
    }

    //=== files ===//

    answer<modbus::read_file_record::response> operator()(modbus::read_file_record::request const& asked)
    {
        file_values_.clear();
        for (auto const range : asked.records()) {
            auto const* file = find_file(range.file());
            if (file == nullptr) { return illegal_data_address; }
            auto const values = file->read<modbus::register_view>(range.record(), range.count());
            if (not values) { return values.error(); }
            file_values_.push_back(*modbus::file_values::make(*values));
        }
        return respond<modbus::read_file_record::response>(std::span<modbus::file_values const>{file_values_});
    }
    answer<done> operator()(modbus::write_file_record::request const& asked)
    {
        for (auto const record : asked.records()) {
            if (find_file(record.range().file()) == nullptr) { return illegal_data_address; }
        }
        for (auto const record : asked.records()) {
            auto const wrote = find_file(record.range().file())->write(record.range().record(), record.values());
            if (not wrote) { return wrote.error(); }
        }
        return done{};
    }

    //=== who it is and how it is ===//

    modbus::read_exception_status::response operator()(modbus::read_exception_status::request) const
    {
        std::uint8_t outputs = 0;  // the first eight coils
        for (std::size_t i = 0; i < 8 and i < model_.coils.size(); ++i) {
            if (model_.coils.all()[i]) { outputs = static_cast<std::uint8_t>(outputs | 1U << i); }
        }
        return {outputs};
    }
    answer<modbus::report_server_id::response> operator()(modbus::report_server_id::request)
    {
        // The ID of one byte, the run indicator (on), and a text.
        static constexpr auto id = ascii("\xDC\xFF" "drivecodec");
        return respond<modbus::report_server_id::response>(id);
    }
    answer<modbus::read_device_identification::response> operator()(
        modbus::read_device_identification::request const& asked)
    {
        using modbus::device_object;
        using enum modbus::device_object_id;
        static constexpr auto vendor  = ascii("drivecodec");
        static constexpr auto product = ascii("modbus_server");
        static constexpr auto version = std::array<std::uint8_t, 3>{'0' + DRIVECODEC_VERSION_MAJOR, '.',
                                                                    '0' + DRIVECODEC_VERSION_MINOR};
        static constexpr auto model   = ascii("an example");
        static constexpr device_object objects[] = {
            {vendor_name, vendor}, {product_code, product}, {major_minor_revision, version}, {model_name, model}};
        return modbus::read_device_identification::answer(asked, modbus::device_conformity::regular_and_specific,
                                                          objects);
    }
    modbus::get_comm_event_counter::response operator()(modbus::get_comm_event_counter::request) const
    {
        return {.busy = false, .event_count = counters.events};
    }
    answer<modbus::get_comm_event_log::response> operator()(modbus::get_comm_event_log::request) const
    {
        return respond<modbus::get_comm_event_log::response>(false, counters.events, counters.server_messages,
                                                             log.events());
    }
    answer<modbus::diagnostics::response> operator()(modbus::diagnostics::request const& asked)
    {
        using enum modbus::diagnostic;
        switch (asked.sub_function()) {
        case return_query_data: return asked.reply();
        case restart_communications_option:
            if (asked.data()[0] == modbus::diagnostics::clear_log) { log.clear(); }
            counters     = {};
            listens_only = false;
            log.add(log.restarted);
            return asked.reply();
        case force_listen_only_mode:
            listens_only = true;
            log.add(log.entered_listen_only);
            return asked.reply();  // not sent
        case clear_counters_and_diagnostic_register: counters = {}; return asked.reply();
        case clear_overrun_counter_and_flag: return asked.reply();
        default:
            auto const* counter = counters.find(asked.sub_function());
            if (counter == nullptr) { return illegal_function; }
            auto const reply = asked.reply_with(std::span{counter, 1});
            if (not reply) { return server_device_failure; }
            return *reply;
        }
    }

private:
    template <typename Response, typename... Parts>
    static answer<Response> respond(Parts const&... parts)
    {
        auto const made = Response::make(parts...);
        if (not made) { return modbus::exception_code::server_device_failure; }
        return *made;
    }

    answer<modbus::register_view> read_holding(std::size_t first, std::size_t count) const
    {
        return model_.holding_registers.read<modbus::register_view>(first, count);
    }
    template <typename Values>
    answer<done> write_holding(std::size_t first, Values const& values)
    {
        auto const wrote = model_.holding_registers.write(first, values);
        if (wrote and first == model_.queue_address) { model_.enqueue(values[0]); }
        return wrote;
    }
    support::table<std::uint16_t>* find_file(std::uint16_t number)
    {
        return number <= model_.files.size() ? &model_.files[number - 1U] : nullptr;
    }

    support::data_model              model_;
    std::vector<modbus::file_values> file_values_;  // what a reply borrows
};

//=== the line ===//

/// The device, as the server `own` on a line: counts what it hears, and listens only when told to.
class line_device {
public:
    line_device(rtu::server_address own, device served) : own_{own}, device_{std::move(served)} {}

    [[nodiscard]] drivecodec::bytes answer(rtu::frame const& found, drivecodec::mutable_bytes room)
    {
        ++device_.counters.bus_messages;
        auto const is_broadcast = found.address() == 0;
        auto const is_for_us    = found.address() == own_.byte() or is_broadcast;
        if (not is_for_us or not found.aligned or found.direction != modbus::direction::request) { return {}; }

        ++device_.counters.server_messages;
        auto const was_listening_only = device_.listens_only;
        log_received(is_broadcast ? support::event_log::received.with(modbus::comm_event::broadcast_received)
                                  : support::event_log::received);
        if (was_listening_only and not is_restart(found)) {
            ++device_.counters.without_response;
            return {};
        }
        device_.refresh();
        auto const served = rtu::serve(own_, found, room, device_);
        auto const reply  = was_listening_only ? drivecodec::bytes{} : served;
        count_reply(found, reply);
        return reply;
    }

    void hear(drivecodec::dropped_bytes const& noise)
    {
        if (noise.reason != drivecodec::errc::bad_checksum) { return; }
        ++device_.counters.bus_errors;
        log_received(support::event_log::received.with(modbus::comm_event::communication_error));
    }

    void go_on() {}

    [[nodiscard]] support::server_counters const& counters() const noexcept { return device_.counters; }

private:
    void count_reply(rtu::frame const& asked, drivecodec::bytes reply)
    {
        auto const answered = rtu::frame{.raw = reply, .direction = modbus::direction::response, .aligned = true};
        if (reply.empty()) {
            ++device_.counters.without_response;
        } else if (answered.is_exception()) {
            ++device_.counters.exceptions_sent;
            device_.log.add(support::event_log::sent_exception(static_cast<modbus::exception_code>(answered.pdu()[1])));
            return;
        } else {
            device_.log.add(support::event_log::sent);
        }
        if (asked.function() != modbus::function_code::get_comm_event_counter) { ++device_.counters.events; }
    }

    /// The one request that ends the listen-only mode.
    [[nodiscard]] static bool is_restart(rtu::frame const& found)
    {
        auto const asked = drivecodec::decode<modbus::diagnostics::request>(found.pdu());
        return asked and asked->sub_function() == modbus::diagnostic::restart_communications_option;
    }

    void log_received(modbus::comm_event event)
    {
        device_.log.add(device_.listens_only ? event.with(modbus::comm_event::in_listen_only_mode) : event);
    }

    rtu::server_address own_;
    device              device_;
};

void print(line_server const& server, support::server_counters const& own)
{
    auto const& line = server.counters();
    std::cout << "on the line: " << line.frames << " frames, " << line.dropped_bytes << " bytes dropped in "
              << line.dropped_runs << " runs (" << line.bad_checksums << " bad checksums, " << line.truncated
              << " cut short)\n"
              << "this server: " << own.server_messages << " requests, " << own.events << " carried out, "
              << own.exceptions_sent << " exceptions, " << own.without_response << " without a response\n";
}

//=== the command line ===//

constexpr auto usage = R"(usage: modbus_server [options]
  --address N       the server's address, 1 to 247 (1)
  --holding N --input N --coils N --discrete N
                    how many registers, coils and discrete inputs (1000)
  --files N         how many files (4))";

constexpr rtu::server_address default_address{1};

struct options {
    line_options               line;
    rtu::server_address        address = default_address;
    support::data_model::sizes sizes;
};

options parse(support::arguments words)
{
    options given;
    while (not words.empty()) {
        auto const word = words.next("an option");
        if (given.line.take(word, words)) { continue; }
        auto const value = [&] { return words.next("the value of " + word); };
        auto const count = [&] { return support::to<std::size_t>(value(), 0, 65536); };
        if (word == "--address") {
            given.address = *rtu::server_address::make(support::to<std::uint8_t>(value(), 1, 247));
        } else if (word == "--holding") {
            given.sizes.holding_registers = count();
        } else if (word == "--input") {
            given.sizes.input_registers = count();
        } else if (word == "--coils") {
            given.sizes.coils = count();
        } else if (word == "--discrete") {
            given.sizes.discrete_inputs = count();
        } else if (word == "--files") {
            given.sizes.files = count();
        } else {
            throw support::usage_error{"unknown option '" + word + "'"};
        }
    }
    return given;
}

int run(options const& given)
{
    line_device          served{given.address, device{support::data_model{given.sizes}}};
    line_server          server{given.line, given.address};
    try {
        server.run(served);
    } catch (std::system_error const&) {
        print(server, served.counters());
        throw;
    }
    print(server, served.counters());
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    support::stop_signal::listen();
    try {
        return run(parse({argc, argv}));
    } catch (support::help_wanted) {
        std::cout << usage << line_options::usage() << '\n';
        return 0;
    } catch (support::usage_error const& fault) {
        std::cerr << "modbus_server: " << fault.what() << '\n'
                  << usage << line_options::usage() << '\n';
    } catch (std::exception const& fault) {
        std::cerr << "modbus_server: " << fault.what() << '\n';
    }
    return 2;
}
