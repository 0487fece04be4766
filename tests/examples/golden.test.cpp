// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#if __has_include(<stb/stb_image.h>)
#include <stb/stb_image.h>
#else
#include <stb_image.h>
#endif

#include "scratch_folder.hpp"

namespace {

struct picture {
    int width = 0, height = 0;
    std::unique_ptr<unsigned char, void (*)(void*)> rgb{nullptr, stbi_image_free};
};

picture read(const std::string& path)
{
    picture p;
    int channels = 0;
    p.rgb.reset(stbi_load(path.c_str(), &p.width, &p.height, &channels, 3));
    INFO(path);
    REQUIRE(p.rgb != nullptr);
    return p;
}

}  // namespace

// The whole chain in one look: font, shaping, curves, triangles, normals, light. Compilers may round a pixel differently, so
// pictures are compared with a tolerance; a missing triangle or a wrong normal is far beyond it.
TEST_CASE("the picture of the README is what text_to_mesh draws today", "[golden]")
{
    const char* const font = "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf";
    if (std::filesystem::file_size(font) != 139512) {
        WARN("left out: " << font << " is not the one that the picture was drawn with (Debian 12's, 139512 bytes)");
        return;
    }
    scratch_folder folder;
    const std::string drawn = folder.file("hello.png");
    const std::string command =
        std::string{"'" TYPEMESH_TEXT_TO_MESH "' 'Hello world!' --font "} + font + " --picture '" + drawn + "'";
    REQUIRE(std::system(command.c_str()) == 0);

    const picture today = read(drawn), golden = read(TYPEMESH_TEST_DATA "/../docs/pictures/hello.png");
    REQUIRE(today.width == golden.width);
    REQUIRE(today.height == golden.height);
    const int bytes = 3 * today.width * today.height;
    int different = 0;
    double sum = 0.0;
    for (int i = 0; i < bytes; ++i) {
        const int off = std::abs(int(today.rgb.get()[i]) - int(golden.rgb.get()[i]));
        sum += off;
        different += off > 8;
    }
    CHECK(sum / bytes < 0.05);
    CHECK(different < bytes / 2000);
}
