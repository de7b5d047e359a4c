// SPDX-License-Identifier: MIT
//
// Prints the state machine of CiA 402 as a Mermaid diagram, from the table that the library itself uses:
//
//     state_diagram >states.mmd
#include <drivecodec/text/cia402.hpp>

#include <iostream>
#include <string>

int main()
{
    drivecodec::text_writer measure;
    drivecodec::cia402::write_state_diagram(measure);

    std::string             diagram(measure.needed(), '\0');
    drivecodec::text_writer out{diagram};
    drivecodec::cia402::write_state_diagram(out);
    std::cout << out.view();
}
