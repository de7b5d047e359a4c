#include <drivecodec/text/drives/vlt6000/choices.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

namespace {

using namespace drivecodec::vlt6000;

TEST(text_vlt6000_choices, have_a_name_for_every_enumerator)
{
    EXPECT_EQ(names_of_all_values<protocol>(),
              (std::set<std::string_view>{"fc_protocol", "metasys_n2", "landis_staefa_fln"}));
    EXPECT_EQ(names_of_all_values<baud_rate>(),
              (std::set<std::string_view>{"baud_300", "baud_600", "baud_1200", "baud_2400", "baud_4800", "baud_9600"}));
    EXPECT_EQ(names_of_all_values<language>(), (std::set<std::string_view>{"english", "danish"}));
    EXPECT_EQ(names_of_all_values<large_display_read_out>(), (std::set<std::string_view>{"lcp_display_text"}));
    EXPECT_EQ(names_of_all_values<process_unit>(), (std::set<std::string_view>{"kilowatt"}));
}

TEST(text_vlt6000_choices, are_named_as_the_manual_numbers_them)
{
    VERIFY(to_string(protocol{0}) == "fc_protocol" and to_string(protocol{1}) == "metasys_n2");
    VERIFY(to_string(protocol{2}) == "landis_staefa_fln" and to_string(protocol{3}).empty());
    VERIFY(to_string(baud_rate{0}) == "baud_300" and to_string(baud_rate{1}) == "baud_600");
    VERIFY(to_string(baud_rate{2}) == "baud_1200" and to_string(baud_rate{3}) == "baud_2400");
    VERIFY(to_string(baud_rate{4}) == "baud_4800" and to_string(baud_rate{5}) == "baud_9600");
    VERIFY(to_string(language{0}) == "english" and to_string(language{1}) == "danish");
    VERIFY(to_string(large_display_read_out{27}) == "lcp_display_text" and to_string(process_unit{20}) == "kilowatt");
}

}  // namespace
