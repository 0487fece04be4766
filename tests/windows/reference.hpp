// SPDX-License-Identifier: MIT
#pragma once

// Outlines of other font libraries, written on one system and read on another: a file a face.
//
//     line of text    path of the font, face, units per em, number of glyphs in the face
//     glyphs          id, then what each library draws: number of contours, each with its number of curves,
//                     each with its degree and its points

#include <typemesh/outline/outline_recorder.hpp>

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace test {

using drawn_contours = std::vector<std::vector<typemesh::curve>>;

inline drawn_contours contours_of(const typemesh::outline& o)
{
    drawn_contours all(o.contour_count());
    for (std::uint32_t k = 0; k < o.contour_count(); ++k)
        all[k].assign(o.curves.begin() + o.starts[k], o.curves.begin() + o.starts[k + 1]);
    return all;
}

/// One glyph by both libraries, and by FreeType with the font's hints followed at one pixel a unit.
struct reference_glyph {
    typemesh::glyph_id id = 0;
    drawn_contours harfbuzz, freetype, hinted;
};

struct reference_face {
    std::string path;
    std::uint32_t face = 0;
    std::uint32_t units_per_em = 0;
    std::uint32_t glyph_count = 0;
    std::vector<reference_glyph> glyphs;
};

namespace reference_file {

template <class T>
void put(std::ostream& out, T value)
{
    out.write(reinterpret_cast<const char*>(&value), sizeof value);
}
template <class T>
T get(std::istream& in)
{
    T value{};
    in.read(reinterpret_cast<char*>(&value), sizeof value);
    return value;
}

inline void put(std::ostream& out, const drawn_contours& contours)
{
    put(out, static_cast<std::uint32_t>(contours.size()));
    for (const auto& curves : contours) {
        put(out, static_cast<std::uint32_t>(curves.size()));
        for (const typemesh::curve& c : curves) {
            put(out, static_cast<std::uint8_t>(c.degree));
            for (std::uint32_t k = 0; k <= c.degree; ++k) {
                put(out, static_cast<float>(c.p[k].x));
                put(out, static_cast<float>(c.p[k].y));
            }
        }
    }
}
inline drawn_contours get_contours(std::istream& in)
{
    drawn_contours contours(get<std::uint32_t>(in));
    for (auto& curves : contours) {
        curves.resize(get<std::uint32_t>(in));
        for (typemesh::curve& c : curves) {
            typemesh::point p[4];
            const std::uint32_t degree = get<std::uint8_t>(in);
            for (std::uint32_t k = 0; k <= degree && k < 4; ++k) {
                p[k].x = double{get<float>(in)};
                p[k].y = double{get<float>(in)};
            }
            c = degree == 1   ? typemesh::curve::from(p[0], p[1])
                : degree == 2 ? typemesh::curve::from(typemesh::quadratic{p[0], p[1], p[2]})
                              : typemesh::curve::from(typemesh::cubic{p[0], p[1], p[2], p[3]});
        }
    }
    return contours;
}

inline void write(const std::string& path, const reference_face& face)
{
    std::ofstream out{path, std::ios::binary};
    out << face.path << '\t' << face.face << '\t' << face.units_per_em << '\t' << face.glyph_count << '\t'
        << face.glyphs.size() << '\n';
    for (const reference_glyph& g : face.glyphs) {
        put(out, g.id);
        put(out, g.harfbuzz);
        put(out, g.freetype);
        put(out, g.hinted);
    }
}

inline reference_face read(const std::string& path)
{
    std::ifstream in{path, std::ios::binary};
    reference_face face;
    std::string line;
    std::getline(in, line);
    std::istringstream words{line};
    std::size_t count = 0;
    std::getline(words, face.path, '\t');
    words >> face.face >> face.units_per_em >> face.glyph_count >> count;
    face.glyphs.resize(count);
    for (reference_glyph& g : face.glyphs) {
        g.id = get<typemesh::glyph_id>(in);
        g.harfbuzz = get_contours(in);
        g.freetype = get_contours(in);
        g.hinted = get_contours(in);
    }
    if (!in) face.glyphs.clear();
    return face;
}

}  // namespace reference_file

}  // namespace test
