// SPDX-License-Identifier: MIT
//
// Reads the meshes of d3dx_create_text and typemesh_text and prints what they are worth: times, sizes, whether they are
// closed, and how far they are from the outlines of the font.
//
//     examine FONT_FOLDER MESHES...          FONT_FOLDER is searched for the fonts that the meshes name

#include "measured_mesh.hpp"
#include "support/mesh_laws.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <tuple>

namespace {

using namespace typemesh;

struct segment {
    point a, b;
};

/// From p to the nearest point of any of them.
double distance(point p, const std::vector<segment>& all)
{
    double best = 1e30;
    for (const segment& s : all) {
        const point d = s.b - s.a, w = p - s.a;
        const double along = dot(w, d), squared = dot(d, d);
        const point off = along <= 0.0 ? w : along >= squared ? p - s.b : w - (along / squared) * d;
        best = std::fmin(best, dot(off, off));
    }
    return std::sqrt(best);
}

/// The mesh's boundary as its walls have it: their edges in the plane z = 0.
std::vector<segment> boundary(const bench::measured_mesh& m)
{
    std::vector<segment> found;
    for (std::size_t i = 0; i + 2 < m.indices.size(); i += 3)
        for (int k = 0; k < 3; ++k) {
            const auto& a = m.vertices[m.indices[i + static_cast<std::size_t>(k)]];
            const auto& b = m.vertices[m.indices[i + static_cast<std::size_t>((k + 1) % 3)]];
            if (a[2] == 0.0f && b[2] == 0.0f && std::fabs(a[5]) < 0.5f && std::fabs(b[5]) < 0.5f)
                found.push_back({{double{a[0]}, double{a[1]}}, {double{b[0]}, double{b[1]}}});
        }
    return found;
}

/// A glyph's outline in the mesh's unit, in chords so short that they may stand for it. Empty for a glyph whose
/// contours meet: the boundary of what they fill is not all of them.
std::vector<segment> drawn(harfbuzz_font& font, char16_t letter, double scale)
{
    hb_codepoint_t id = 0;
    outline o;
    if (!hb_font_get_nominal_glyph(font.handle(), letter, &id) || !record(font, id, o)) return {};
    contours loops;
    workspace space;
    triangle_list triangles;
    const auto fitting = grid::fitting(font.units_per_em(), o.bounds);
    if (!fitting || !discretise(o, certified{}, 1e-4 * font.units_per_em(), *fitting, loops)) return {};
    orient(loops);
    if (!monotone{}.prove(loops, space, triangles)) return {};

    std::vector<segment> fine;
    for (const curve& c : o.curves) {
        const int pieces = c.degree == 1 ? 1 : 64;
        for (int i = 0; i < pieces; ++i)
            fine.push_back({scale * c.at(double(i) / pieces), scale * c.at(double(i + 1) / pieces)});
    }
    return fine;
}

/// The greatest distance from points of the one to the other, both ways.
double gap(const std::vector<segment>& mesh, const std::vector<segment>& true_outline)
{
    double worst = 0.0;
    for (const segment& s : mesh)
        for (int i = 0; i < 4; ++i) worst = std::fmax(worst, distance(lerp(s.a, s.b, i / 4.0), true_outline));
    for (const segment& s : true_outline) worst = std::fmax(worst, distance(s.a, mesh));
    return worst;
}

test::closedness examine(const bench::measured_mesh& m, double& volume)
{
    test::full_mesh mesh;
    for (const auto& v : m.vertices) mesh.vertices.push_back({{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {}});
    mesh.indices = m.indices;
    volume = test::volume(mesh.vertices, mesh.indices);
    return test::examine(mesh);
}

harfbuzz_font open(const std::string& folder, const std::string& name)
{
    for (const auto& entry : std::filesystem::recursive_directory_iterator{folder})
        if (entry.path().filename() == name)
            if (auto font = harfbuzz_font::open(entry.path().c_str())) return std::move(*font);
    std::fprintf(stderr, "no font file %s in %s\n", name.c_str(), folder.c_str());
    std::exit(1);
}

/// The font's cell height in font units, as GDI takes it: usWinAscent + usWinDescent.
double cell_height(const harfbuzz_font& font)
{
    hb_blob_t* os2 = hb_face_reference_table(hb_font_get_face(font.handle()), HB_TAG('O', 'S', '/', '2'));
    unsigned size = 0;
    const auto* bytes = reinterpret_cast<const unsigned char*>(hb_blob_get_data(os2, &size));
    if (size < 78) std::exit(1);
    const int height = (bytes[74] << 8 | bytes[75]) + (bytes[76] << 8 | bytes[77]);
    hb_blob_destroy(os2);
    return height;
}

struct gaps {
    double worst = 0.0;    ///< of all letters
    double in_text = 0.0;  ///< of the letters of the text
    char16_t letter = u'?';
    std::size_t letters = 0;
    std::size_t worse = 0;  ///< letters that are farther off than the first maker's
    std::size_t vertices = 0;
};

}  // namespace

int main(int argc, char** argv)
{
    if (argc < 3) return std::fputs("usage: examine FONT_FOLDER MESHES...\n", stderr), 2;
    std::map<std::string, harfbuzz_font> fonts;
    std::map<std::pair<std::string, char16_t>, std::vector<segment>> outlines;
    using key = std::tuple<std::string, double, std::string>;  // font, deviation, maker
    std::map<key, gaps, std::greater<key>> found;
    std::map<key, bench::measured_mesh, std::greater<key>> texts;
    std::map<std::tuple<std::string, double, char16_t>, double> before;  // the gaps of the first maker

    for (int i = 2; i < argc; ++i) {
        std::FILE* in = std::fopen(argv[i], "rb");
        if (in == nullptr) continue;
        for (bench::measured_mesh m; bench::read(in, m);) {
            const key where{m.font, m.deviation, m.maker};
            if (m.text.size() > 1) {
                const auto [place, fresh] = texts.try_emplace(where, m);
                if (!fresh && m.microseconds < place->second.microseconds) place->second = m;
                continue;
            }
            if (fonts.find(m.font) == fonts.end()) fonts.emplace(m.font, open(argv[1], m.font));
            harfbuzz_font& font = fonts.at(m.font);
            auto [outline, fresh] = outlines.try_emplace({m.font, m.text[0]});
            if (fresh) outline->second = drawn(font, m.text[0], 1.0 / cell_height(font));
            const auto mesh = boundary(m);
            if (outline->second.empty() || mesh.empty()) continue;
            const double error = gap(mesh, outline->second);
            gaps& all = found[where];
            const auto [first, new_letter] = before.try_emplace({m.font, m.deviation, m.text[0]}, error);
            if (!new_letter && error > first->second) ++all.worse;
            ++all.letters;
            all.vertices += m.vertices.size();
            if (error > all.worst) all.worst = error, all.letter = m.text[0];
            if (bench::hello.find(m.text[0]) != std::u16string::npos) all.in_text = std::fmax(all.in_text, error);
        }
        std::fclose(in);
    }

    std::printf(
        "\"Hello world!\", extrusion 0.3. Microseconds: the whole, median and shortest; what of it is layout, "
        "outlines, the\n"
        "rest; the whole with a glyph cache; layout and outlines the very first time\n");
    std::printf("%-27s %-6s %-40s %7s %7s %6s %7s %7s %6s %7s %6s %6s %5s %5s %8s\n", "font", "dev.", "maker", "median",
                "best", "layout", "outline", "meshing", "cached", "first", "vert.", "tri.", "open", "flat", "volume");
    for (const auto& [where, m] : texts) {
        double volume = 0.0;
        const auto closed = examine(m, volume);
        std::printf("%-27s %-6g %-40s %7.1f %7.1f %6.1f %7.1f %7.1f %6.1f %7.0f %6zu %6zu %5zu %5zu %8.4f\n",
                    m.font.c_str(), m.deviation, m.maker.c_str(), m.microseconds, m.best, m.layout, m.outlines,
                    m.meshing, m.cached, m.first_time, m.vertices.size(), m.indices.size() / 3, closed.unmatched_edges,
                    closed.zero_area, volume);
    }
    if (found.empty()) return 0;
    std::printf(
        "\nThe greatest distance between mesh and outline, in cell heights: over all letters, over the letters of the "
        "text\n");
    std::printf("%-27s %-6s %-40s %9s %9s %7s %7s %6s %8s\n", "font", "dev.", "maker", "letters", "hello", "worst",
                "letters", "worse", "vert.");
    for (const auto& [where, g] : found)
        std::printf("%-27s %-6g %-40s %9.6f %9.6f  U+%04X %7zu %6zu %8zu\n", std::get<0>(where).c_str(),
                    std::get<1>(where), std::get<2>(where).c_str(), g.worst, g.in_text, static_cast<unsigned>(g.letter),
                    g.letters, g.worse, g.vertices);
}
