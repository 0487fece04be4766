// SPDX-License-Identifier: MIT
#pragma once

// What the programs of this folder hand to each other: meshes with the times that they took, one after the other in a
// file.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace bench {

/// A text's mesh, how it was asked for and how long it took. Only what position and normal need: 24 bytes a vertex.
struct measured_mesh {
    std::string maker;  ///< who made it: "Wine's D3DXCreateTextW", ...
    std::string font;   ///< the font file's name, without its folder
    std::u16string text;
    double deviation = 0.0;     ///< as D3DXCreateText understands it
    double microseconds = 0.0;  ///< for the whole, median; 0 when it was not timed
    double best = 0.0;          ///< the same, the shortest
    double layout = 0.0;        ///< what of that is layout,
    double outlines = 0.0;      ///< outlines, as the font library gives them,
    double meshing = 0.0;       ///< and the rest; medians
    double first_time = 0.0;    ///< layout and outlines the very first time
    double cached = 0.0;        ///< the whole with a glyph cache that knows the letters, median
    std::vector<std::array<float, 6>> vertices;
    std::vector<std::uint32_t> indices;
};

inline bool write(std::FILE* to, const measured_mesh& m)
{
    const auto put = [to](const void* data, std::size_t bytes) {
        return std::fwrite(data, 1, bytes, to) == bytes || bytes == 0;
    };
    const std::uint32_t sizes[5] = {
        static_cast<std::uint32_t>(m.maker.size()), static_cast<std::uint32_t>(m.font.size()),
        static_cast<std::uint32_t>(m.text.size()), static_cast<std::uint32_t>(m.vertices.size()),
        static_cast<std::uint32_t>(m.indices.size())};
    const double numbers[8] = {m.deviation, m.microseconds, m.best,       m.layout,
                               m.outlines,  m.meshing,      m.first_time, m.cached};
    return put(sizes, sizeof sizes) && put(numbers, sizeof numbers) && put(m.maker.data(), m.maker.size()) &&
           put(m.font.data(), m.font.size()) && put(m.text.data(), 2 * m.text.size()) &&
           put(m.vertices.data(), sizeof m.vertices[0] * m.vertices.size()) &&
           put(m.indices.data(), 4 * m.indices.size());
}

/// False at the file's end.
inline bool read(std::FILE* from, measured_mesh& m)
{
    const auto take = [from](void* data, std::size_t bytes) { return std::fread(data, 1, bytes, from) == bytes; };
    std::uint32_t sizes[5];
    double numbers[8];
    if (!take(sizes, sizeof sizes) || !take(numbers, sizeof numbers)) return false;
    m.maker.resize(sizes[0]), m.font.resize(sizes[1]), m.text.resize(sizes[2]);
    m.vertices.resize(sizes[3]), m.indices.resize(sizes[4]);
    m.deviation = numbers[0], m.microseconds = numbers[1], m.best = numbers[2];
    m.layout = numbers[3], m.outlines = numbers[4], m.meshing = numbers[5], m.first_time = numbers[6],
    m.cached = numbers[7];
    return take(m.maker.data(), sizes[0]) && take(m.font.data(), sizes[1]) && take(m.text.data(), 2 * sizes[2]) &&
           take(m.vertices.data(), sizeof m.vertices[0] * sizes[3]) && take(m.indices.data(), 4 * sizes[4]);
}

inline double median(std::vector<double>& of)
{
    std::nth_element(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2), of.end());
    return of[of.size() / 2];
}

/// Median and shortest of so many runs, in microseconds, after a tenth as many for warming up.
struct run_times {
    double median = 0.0;
    double best = 0.0;
};

template <class Work>
run_times time_of(int runs, Work&& work)
{
    using clock = std::chrono::steady_clock;
    for (int i = 0; i < runs / 10 + 1; ++i) work();
    std::vector<double> each;
    for (int i = 0; i < runs; ++i) {
        const auto start = clock::now();
        work();
        each.push_back(std::chrono::duration<double, std::micro>(clock::now() - start).count());
    }
    std::sort(each.begin(), each.end());
    return {each[each.size() / 2], each.front()};
}

/// The four qualities of the thesis, from coarse to fine.
inline constexpr double deviations[] = {0.1, 0.01, 0.005, 0.001};

/// Those, and others between and around them, at which single letters are made.
inline constexpr double letter_deviations[] = {0.3, 0.1, 0.03, 0.01, 0.005, 0.002, 0.001};

/// The text that is timed, and the letters of which each is meshed alone, to be measured against its outline.
inline const std::u16string hello = u"Hello world!";

inline std::u16string latin_letters()
{
    std::u16string all;
    for (char16_t c = 0x21; c < 0x100; ++c)
        if (c < 0x7F || (c > 0xA0 && c != 0xAD)) all += c;
    return all;
}

/// A file's name without its folder.
inline std::string name_of(const std::string& path)
{
    const auto slash = path.find_last_of("/\\");
    return slash == std::string::npos ? path : path.substr(slash + 1);
}

}  // namespace bench
