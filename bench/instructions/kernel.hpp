// SPDX-License-Identifier: MIT
//
// What the programs of kernels share. A kernel is work to count instructions of, which no other load on the machine changes:
// PROGRAM KERNEL TIMES does it that many times and prints how many units that was each time. A kernel streams over whole fonts
// or texts; one whose unit is the byte only prints a number of bytes. Without arguments a program prints the names, units and
// meanings of its kernels, a line each. The programs compile against older revisions, too.
#pragma once

#include "../../tests/support/font_path.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <utility>

namespace bench {

using namespace typemesh;

constexpr const char* sans = "truetype/liberation/LiberationSans-Regular.ttf";
constexpr const char* comic = "opentype/comic-neue/ComicNeue-Regular.otf";
constexpr const char* mplus = "opentype/mplus/Mplus1-Regular.otf";

inline harfbuzz_font open_font(const char* file, const font_options& options = {})
{
    auto font = harfbuzz_font::open(font_path(file).string().c_str(), options);
    if (!font) std::fprintf(stderr, "%s: %s\n", file, font.error().message()), std::exit(1);
    return std::move(*font);
}

inline std::string first_line(const char* file)
{
    std::ifstream in{std::string{TYPEMESH_TEST_DATA "/workload/"} + file};
    std::string text;
    std::getline(in, text);
    return text;
}

struct kernel {
    const char *name, *unit, *what;
    std::size_t (*run)(int times);
};
template <std::size_t Count>
int run_one_of(const kernel (&kernels)[Count], int argc, char** argv)
{
    for (const kernel& k : kernels) {
        if (argc < 3) std::printf("%s\t%s\t%s\n", k.name, k.unit, k.what);
        if (argc == 3 && std::strcmp(argv[1], k.name) == 0) return std::printf("%zu\n", k.run(std::atoi(argv[2]))), 0;
    }
    return argc < 3 ? 0 : 2;
}

}  // namespace bench
