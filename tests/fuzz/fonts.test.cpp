// SPDX-License-Identifier: MIT

#include "fonts.hpp"
#include "replay.hpp"

TEST_CASE("damaged fonts that are kept, and random ones, give closed meshes or clear errors", "[fuzz]")
{
    fuzz::replay("fonts", fuzz::fonts, 1200, 96);
}
