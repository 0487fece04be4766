// SPDX-License-Identifier: MIT

#include "fonts.hpp"
#include "replay.hpp"

TEST_CASE("kept and random damaged fonts make closed meshes or clear errors", "[fuzz]")
{
    fuzz::replay("fonts", fuzz::fonts, 1200, 96);
}
