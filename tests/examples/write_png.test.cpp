// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include "text_to_mesh/write_png.hpp"

#include "scratch_folder.hpp"
#include "written_alone.hpp"

using namespace text_to_mesh;

TEST_CASE("a PNG begins with its signature and the picture's size", "[write_png]")
{
    scratch_folder folder;
    const std::vector<unsigned char> pixels(300 * 2 * 3, 127);
    REQUIRE(written_alone(write_png, pixels, 300, 2, folder.file("grey.png")) == "");
    const std::vector<unsigned char> bytes = bytes_of(folder.file("grey.png"));
    const std::vector<unsigned char> start = {0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13, 'I',
                                              'H',  'D', 'R', 0,   0,  1,  44, 0,  0, 0, 2, 8,  2};
    REQUIRE(bytes.size() > start.size());
    CHECK(std::vector<unsigned char>(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(start.size())) ==
          start);
}

TEST_CASE("a picture whose size does not fit its pixels is refused", "[write_png]")
{
    scratch_folder folder;
    const std::vector<unsigned char> pixels(12);
    CHECK_FALSE(written_alone(write_png, pixels, 2, 3, folder.file("bad.png")).empty());
    CHECK_FALSE(written_alone(write_png, pixels, -2, -2, folder.file("bad.png")).empty());
    CHECK(folder.count() == 0);
}
