// SPDX-License-Identifier: MIT
#pragma once

// What the native programs of the peers share:
//
//     PROGRAM time TEXTS SECONDS      a row "time" for each way and text, see ../README.md
//     PROGRAM meshes FOLDER FONT      the mesh of each character of a set, for the judge: FOLDER/PROGRAM.WAY.FONT.meshes
//
// TEXTS has a line a text: name, font file, text, parted by tabs. Times are of the processor, in this process, with the font
// open; the median of as many runs as fit into SECONDS, at least three, after one that is not counted. What takes half a second
// is run once.

#include "mesh_file.hpp"

#include <algorithm>
#include <cstring>
#include <ctime>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace peers {

constexpr double depth = 0.2;         ///< of all solids, in em
constexpr double bevel_width = 0.02;  ///< of bevels, in em

/// One way in which a peer makes a mesh of a text.
struct way {
    std::string setting;  ///< how fine
    std::string solid;    ///< extruded, bevelled, flat
    std::string state;    ///< see ../README.md; and placed: letters are kept and only placed, no mesh is written
    std::function<bool(const std::string& utf8)> build;  ///< what is timed
    std::function<mesh()> made;                          ///< what build() has made, as one mesh
    const char* peer = nullptr;                          ///< instead of the program's
};
using open_font = std::function<std::vector<way>(const std::string& file)>;

/// ASCII and Latin up to U+024F: what the judge looks at.
inline std::vector<std::uint32_t> judged_characters()
{
    std::vector<std::uint32_t> all;
    for (std::uint32_t c = 0x21; c < 0x250; ++c)
        if (c < 0x7F || (c > 0xA0 && c != 0xAD)) all.push_back(c);
    return all;
}

inline std::string utf8_of(std::uint32_t c)
{
    const auto last = [](std::uint32_t bits) { return char(0x80 | (bits & 0x3F)); };
    if (c < 0x80) return {char(c)};
    if (c < 0x800) return {char(0xC0 | (c >> 6)), last(c)};
    return {char(0xE0 | (c >> 12)), last(c >> 6), last(c)};
}

inline std::u32string characters_of(const std::string& utf8)
{
    std::u32string all;
    for (std::size_t i = 0; i < utf8.size();) {
        const auto first = static_cast<unsigned char>(utf8[i++]);
        char32_t c = first < 0x80 ? first : first < 0xE0 ? first & 0x1F : first < 0xF0 ? first & 0xF : first & 7;
        for (; i < utf8.size() && (utf8[i] & 0xC0) == 0x80; ++i) c = c << 6 | (utf8[i] & 0x3F);
        all += c;
    }
    return all;
}

inline double microseconds_of_processor()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) * 1e6 + double(now.tv_nsec) * 1e-3;
}

/// The median of runs of work(); quick work is run several times between two looks at the clock.
template <class Work>
double microseconds_each(double seconds, Work&& work)
{
    double start = microseconds_of_processor();
    work();
    const double once = microseconds_of_processor() - start;
    if (once > 5e5) return once;
    const int times = 1 + int(100.0 / (1.0 + once));
    std::vector<double> runs;
    double left = seconds * 1e6;
    while (runs.size() < 3 || (left > 0 && runs.size() < 1000)) {
        start = microseconds_of_processor();
        for (int i = 0; i < times; ++i) work();
        const double all = microseconds_of_processor() - start;
        runs.push_back(all / times);
        left -= all;
    }
    std::nth_element(runs.begin(), runs.begin() + std::ptrdiff_t(runs.size() / 2), runs.end());
    return runs[runs.size() / 2];
}

inline void print_row(const char* peer, const way& w, const std::string& text, double microseconds, const mesh& m)
{
    std::printf("time\t%s\t%s\t%s\t%s\t%s\t%.3f\t%zu\t%zu\tnative\n", w.peer != nullptr ? w.peer : peer,
                w.setting.c_str(), w.solid.c_str(), w.state.c_str(), text.c_str(), microseconds, m.triangles(),
                m.vertices());
    std::fflush(stdout);
}

inline int time_texts(const char* peer, const char* texts, double seconds, const open_font& open)
{
    std::ifstream in(texts);
    std::string open_file;
    std::vector<way> ways;
    for (std::string line; std::getline(in, line);) {
        std::istringstream parts(line);
        std::string name, file, text;
        std::getline(std::getline(std::getline(parts, name, '\t'), file, '\t'), text);
        if (file != open_file) ways = open(open_file = file);
        for (const way& w : ways) {
            if (!w.build(text)) continue;
            const double each = microseconds_each(seconds, [&] { w.build(text); });
            const mesh m = w.made ? w.made() : mesh{};
            print_row(peer, w, name, each, m);
        }
    }
    return 0;
}

inline int write_meshes(const char* peer, const char* program, const std::string& folder, const char* font,
                        const open_font& open)
{
    int number = 0;
    std::set<std::string> written;
    for (const way& w : open(font)) {
        ++number;
        mesh_file all{peer, w.setting + (w.solid == "extruded" ? "" : ", " + w.solid), font, {}};
        if (w.solid == "wrapped" || !w.made || !written.insert(all.setting).second) continue;  // one state is enough
        for (const std::uint32_t c : judged_characters())
            if (w.build(utf8_of(c))) all.glyphs.push_back({c, w.made()});
        std::string name = program + std::string(".") + std::to_string(number) + "." + font;
        std::replace(name.begin(), name.end(), '/', '_');
        if (!all.glyphs.empty() && !all.write(folder + "/" + name + ".meshes")) return 1;
    }
    return 0;
}

inline int run(int argc, char** argv, const char* peer, const open_font& open)
{
    const char* slash = std::strrchr(argv[0], '/');
    if (argc == 4 && std::strcmp(argv[1], "time") == 0) return time_texts(peer, argv[2], std::atof(argv[3]), open);
    if (argc == 4 && std::strcmp(argv[1], "meshes") == 0)
        return write_meshes(peer, slash != nullptr ? slash + 1 : argv[0], argv[2], argv[3], open);
    std::fprintf(stderr, "usage: %s time TEXTS SECONDS | meshes FOLDER FONT\n", argv[0]);
    return 2;
}

}  // namespace peers
