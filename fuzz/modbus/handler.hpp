#pragma once

#include "fuzz_common.hpp"
#include "input.hpp"

#include <drivecodec/modbus/server.hpp>

#include <array>

namespace oracle {

namespace modbus = drivecodec::modbus;

/// A server of every function. It answers as asked, or refuses, or gives another number of values than was asked for.
class full_handler {
public:
    explicit full_handler(fuzz_input& input) : how_{static_cast<manner>(input.u8() % 3)}, input_{input}
    {
        for (std::size_t i = 0; i < words_.size(); ++i) { words_[i] = static_cast<std::uint16_t>(i * 0x0123); }
        for (std::size_t i = 0; i < text_.size(); ++i) { text_[i] = static_cast<std::uint8_t>(i); }
        refusal_ = static_cast<modbus::exception_code>(1 + input.below(255));
        count_   = input.below(300);
    }

    [[nodiscard]] unsigned               calls() const noexcept { return calls_; }
    [[nodiscard]] bool                   is_faithful() const noexcept { return how_ == manner::faithful; }
    [[nodiscard]] bool                   refuses() const noexcept { return how_ == manner::refusing; }
    [[nodiscard]] modbus::exception_code refusal() const noexcept { return refusal_; }

    template <typename Request>
    [[nodiscard]] auto operator()(Request const& asked)
    {
        ++calls_;
        return answer(asked);
    }

private:
    enum class manner : std::uint8_t { faithful, refusing, miscounting };

    using coils     = modbus::answer<modbus::coil_view>;
    using registers = modbus::answer<modbus::register_view>;
    using none      = modbus::answer<modbus::done>;

    [[nodiscard]] std::size_t counted(std::size_t asked) const { return how_ == manner::miscounting ? count_ : asked; }

    [[nodiscard]] modbus::register_view words(std::size_t count) const
    {
        return std::span<std::uint16_t const>{words_}.first(count);
    }
    [[nodiscard]] coils some_coils(std::size_t asked)
    {
        if (refuses()) { return refusal_; }
        if (how_ == manner::miscounting) { return modbus::coil_view::of_wire(text_, count_); }
        states_ = {};
        for (std::size_t i = 0; i < asked; ++i) { states_[i] = i % 3 == 0; }
        return modbus::coil_view{std::span<bool const>{states_}.first(asked)};
    }
    [[nodiscard]] registers some_registers(std::size_t asked)
    {
        if (refuses()) { return refusal_; }
        return words(counted(asked));
    }
    template <typename Response>
    [[nodiscard]] modbus::answer<Response> made(drivecodec::result<Response> const& response) const
    {
        if (refuses()) { return refusal_; }
        if (not response) { return modbus::exception_code::server_device_failure; }
        return *response;
    }
    /// What the library makes a response of, if it can.
    template <typename Payload>
    [[nodiscard]] modbus::answer<Payload> given(Payload payload) const
    {
        if (refuses()) { return refusal_; }
        return payload;
    }
    [[nodiscard]] none is_done() const
    {
        if (refuses()) { return refusal_; }
        return modbus::done{};
    }

    auto answer(modbus::read_coils::request const& asked) { return some_coils(asked.range.count()); }
    auto answer(modbus::read_discrete_inputs::request const& asked) { return some_coils(asked.range.count()); }
    auto answer(modbus::read_holding_registers::request const& asked) { return some_registers(asked.range.count()); }
    auto answer(modbus::read_input_registers::request const& asked) { return some_registers(asked.range.count()); }
    auto answer(modbus::read_write_multiple_registers::request const& asked)
    {
        return some_registers(asked.read_range.count());
    }
    auto answer(modbus::read_fifo_queue::request const&)
    {
        return given(words(count_ % (is_faithful() ? 32 : 300)));
    }

    auto answer(modbus::write_single_coil::request const& asked) -> modbus::answer<modbus::write_single_coil::response>
    {
        if (refuses()) { return refusal_; }
        auto reply = asked.reply();
        if (how_ == manner::miscounting) { reply.value = not reply.value; }
        return reply;
    }
    auto answer(modbus::write_single_register::request const&) { return is_done(); }
    auto answer(modbus::write_multiple_coils::request const&) { return is_done(); }
    auto answer(modbus::write_multiple_registers::request const&) { return is_done(); }
    auto answer(modbus::write_file_record::request const&) { return is_done(); }
    auto answer(modbus::mask_write_register::request const&) { return is_done(); }

    auto answer(modbus::read_exception_status::request const&) -> modbus::answer<std::uint8_t>
    {
        if (refuses()) { return refusal_; }
        return std::uint8_t{0x6D};
    }
    auto answer(modbus::diagnostics::request const& asked)
    {
        auto const repeats = modbus::diagnostics::echoes_data(asked.sub_function()) and is_faithful();
        return made(repeats ? drivecodec::result<modbus::diagnostics::response>{asked.reply()}
                            : asked.reply_with(words(is_faithful() ? 1 : count_)));
    }
    auto answer(modbus::get_comm_event_counter::request const&)
    {
        using response = modbus::get_comm_event_counter::response;
        return made(drivecodec::result<response>{response{.busy = count_ % 2 == 0, .event_count = 0x0108}});
    }
    auto answer(modbus::get_comm_event_log::request const&)
    {
        return made(modbus::get_comm_event_log::response::make(count_ % 2 == 0, 1, 2, log(64)));
    }
    auto answer(modbus::report_server_id::request const&) { return given(log(251)); }
    auto answer(modbus::read_file_record::request const& asked)
    {
        std::size_t count = 0;
        for (auto const range : asked.records()) {
            auto const is_wrong = how_ == manner::miscounting and count == count_ % 35;
            auto const values   = modbus::file_values::make(words(is_wrong ? 1 + count_ % 124 : range.count()));
            FUZZ_ASSERT(values.has_value());
            file_[count++] = *values;
        }
        return given(modbus::record_list<modbus::file_values>{std::span{file_}.first(count)});
    }
    auto answer(modbus::canopen_general_reference::request const& asked)
    {
        return made(modbus::canopen_general_reference::response::make(is_faithful() ? asked.payload() : log(251)));
    }
    auto answer(modbus::read_device_identification::request const& asked)
        -> modbus::answer<modbus::read_device_identification::response>
    {
        if (refuses()) { return refusal_; }
        for (std::size_t i = 0; i < objects_.size(); ++i) {
            objects_[i] = {.id    = static_cast<modbus::device_object_id>(i < 7 ? i : 0x80 + i),
                           .value = drivecodec::bytes{text_}.first(i * 17)};
        }
        auto const conformity = static_cast<modbus::device_conformity>(input_.u8());
        return modbus::read_device_identification::answer(asked, conformity, objects_);
    }

    /// So many bytes, or as many as the input tells.
    [[nodiscard]] drivecodec::bytes log(std::size_t most) const
    {
        return drivecodec::bytes{text_}.first(is_faithful() ? 1 + count_ % most : count_);
    }

    static constexpr modbus::file_values no_values = *modbus::file_values::make(modbus::register_view::of_wire({}, 1));

    manner                                how_;
    fuzz_input&                           input_;
    modbus::exception_code                refusal_{};
    std::size_t                           count_ = 0;
    unsigned                              calls_ = 0;
    std::array<std::uint16_t, 300>        words_{};
    std::array<std::uint8_t, 300>         text_{};
    std::array<bool, 2000>                states_{};
    std::array<modbus::device_object, 12> objects_{};

    template <std::size_t... I>
    static constexpr std::array<modbus::file_values, sizeof...(I)> filled(std::index_sequence<I...>)
    {
        return {(static_cast<void>(I), no_values)...};
    }
    std::array<modbus::file_values, 35> file_ = filled(std::make_index_sequence<35>{});
};

}  // namespace oracle
