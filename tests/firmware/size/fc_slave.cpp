#include "fc_slave.hpp"

#include <drivecodec/fc.hpp>

namespace fc = drivecodec::fc;

namespace {

struct drive {
    fc::process_status operator()(fc::process_command const& said) const
    {
        if (said.is_data_valid()) {
            control_word = said.control_word();
            reference    = said.reference().raw();
        }
        return {status_word, fc::output_frequency::from_raw(output_frequency)};
    }

    fc::parameter_answer operator()(fc::parameter_request const& asked) const
    {
        if (not exists(asked.number())) { return fc::parameter_error::parameter_does_not_exist; }
        auto& parameter = parameters[asked.number() - first_parameter];
        switch (asked.command()) {
        case fc::ak_command::read_value: break;
        case fc::ak_command::write_word:
        case fc::ak_command::write_word_to_eeprom: parameter = static_cast<std::uint16_t>(asked.pwe); break;
        default: return fc::parameter_error::data_type_does_not_match;
        }
        return fc::parameter_answer::value(parameter);
    }
};

}  // namespace

std::size_t serve(std::uint8_t const* request, std::size_t size)
{
    return fc::serve(fc::address::long_format(7), {request, size}, reply, drive{}).size();
}
