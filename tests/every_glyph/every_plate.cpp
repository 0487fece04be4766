// SPDX-License-Identifier: MIT
//
//     every_plate [--quality low|normal|high|best]... [--step N] [NAME=]FILE_OR_FOLDER...
//
// Makes plates of every glyph of every face of the fonts: standing, engraved, cut, as an inlay and as a stencil, plain
// and with rims. Each solid must be closed, strictly 2-manifold unless the plate says otherwise, and have the volume of
// its slabs; the plate and the inlay in it add up to the plate alone; a stencil's plate is in one piece, unless the
// plate counts loose islands, and its bridges are as wide as asked. Prints what is wrong and a table; the status is 0 if
// nothing is wrong.

#include "support/glyph_arguments.hpp"

#include <typemesh/inspect/manifoldness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/plate/name_plate.hpp>
#include <typemesh/typemesh.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

namespace {

using namespace typemesh;

struct totals {
    std::size_t glyphs = 0, blank = 0, plates = 0, refused = 0, touching = 0, islands = 0, bridges = 0, loose = 0,
                narrower = 0, wrong = 0;
};

struct solid_mesh {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
};

/// The number of pieces of a closed mesh whose places are joined.
std::size_t pieces_of(const solid_mesh& m)
{
    std::vector<std::uint32_t> order(m.vertices.size()), root(m.vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::iota(root.begin(), root.end(), 0u);
    const auto key = [&](std::uint32_t i) {
        const vec3& p = m.vertices[i];
        return std::array{p.x, p.y, p.z};
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    const auto find = [&](std::uint32_t i) {
        while (root[i] != i) i = root[i] = root[root[i]];
        return i;
    };
    for (std::size_t i = 1; i < order.size(); ++i)
        if (key(order[i]) == key(order[i - 1])) root[find(order[i])] = find(order[i - 1]);
    for (std::size_t i = 0; i + 2 < m.indices.size(); i += 3) {
        root[find(m.indices[i + 1])] = find(m.indices[i]);
        root[find(m.indices[i + 2])] = find(m.indices[i]);
    }
    std::size_t pieces = 0;
    std::vector<bool> used(root.size());
    for (const std::uint32_t i : m.indices) {
        const std::uint32_t r = find(i);
        pieces += !used[r];
        used[r] = true;
    }
    return pieces;
}

/// What is wrong with a solid of a plate.
const char* fault_of(const name_plate& plate, std::size_t k, const solid_mesh& m)
{
    const inspect::mesh_view view{m.vertices, m.indices};
    const auto faults = inspect::check_manifoldness(view);
    if (faults.open_edges != 0) return "an edge is open";
    if (plate.is_manifold() && !faults.is_manifold()) return "it is not strictly 2-manifold";
    const double unit = plate.placement().at.unit_per_cell, volume = unit * unit * plate.solid(k).volume(),
                 is = inspect::measure(view).volume;
    if (!(std::fabs(is - volume) <= 1e-4 * volume + 1e-9)) return "it has another volume than its slabs";
    return nullptr;
}

/// Makes all plates of a run. Returns what is wrong.
template <class Plan>
std::string examine(const Plan& text, name_plate& plate, totals& sum)
{
    constexpr auto position = [](const surface_point<attribute::position>& p) noexcept { return p.position; };
    solid_mesh m;
    for (const bool with_rims : {false, true})
        for (const plate_style style :
             {plate_style::standing, plate_style::engraved, plate_style::cut, plate_style::inlay})
            for (const bool stencil : {false, true}) {
                if (stencil && style != plate_style::cut) continue;
                plate_options how{.style = style};
                if (with_rims) {
                    how.bevel = 0.01f;
                    how.fillet = 0.02f;
                }
                if (stencil) how.bridge_width = 0.03f;
                const auto made = plate.plan(text, how, monotone{});
                if (!made && made.error() == error::bad_option) return {};  // no outline
                if (!made) {
                    ++sum.refused;
                    return std::string{"refused: "} + made.error().message();
                }
                ++sum.plates;
                sum.touching += !plate.is_manifold();
                sum.narrower += plate.rims().bevel < how.bevel ||
                                (style == plate_style::standing && plate.rims().fillet < how.fillet);
                for (std::size_t k = 0; k < plate.solid_count(); ++k) {
                    m.vertices.clear();
                    m.indices.clear();
                    if (!plate.write(k, into(m.vertices, m.indices, position))) return "a solid was not written";
                    if (const char* fault = fault_of(plate, k, m)) return fault;
                    if (stencil && plate.stencil().loose == 0 && plate.is_manifold() && pieces_of(m) != 1)
                        return "a stencil is in several pieces";
                }
                if (stencil) {
                    sum.islands += plate.stencil().islands;
                    sum.bridges += plate.stencil().bridges;
                    sum.loose += plate.stencil().loose;
                    const double least = 0.03 / plate.placement().at.unit_per_cell * plate.unit_per_em() - 1.0;
                    for (const stencil_bar& bar : plate.stencil_bars())
                        if (bar.width() < least) return "a bridge is narrower than asked";
                }
                if (style == plate_style::inlay && !with_rims) {
                    const double both = plate.solid(0).volume() + plate.solid(1).volume();
                    const double whole = 0.5 * static_cast<double>(plate.cells().doubled_area(name_plate::body())) *
                                         plate.unit_per_em() * static_cast<double>(how.thickness);
                    if (!(std::fabs(both - whole) <= 1e-5 * whole)) return "plate and inlay are not the whole";
                }
            }
    return {};
}

void look_at(const test::glyph_arguments& arguments, const test::glyph_job& job, totals& sum)
{
    name_plate plate;
    arguments.each_glyph(job, [&](auto& font, std::uint32_t g) {
        ++sum.glyphs;
        text_mesher mesher{font, flat{}};
        for (const test::quality_named& q : arguments.wanted) {
            glyph_run run;
            run.units_per_em = font.units_per_em();
            (void)run.glyphs.push_back({.id = g});
            const auto text = mesher.plan(run, {.tolerance = q.tolerance});
            if (!text || text->size().vertices == 0) {
                ++sum.blank;
                continue;
            }
            const std::string wrong = examine(*text, plate, sum);
            if (wrong.empty()) continue;
            ++sum.wrong;
            std::printf("%s %u, %s: %s\n", job.face.name().c_str(), g, q.name, wrong.c_str());
        }
    });
}

}  // namespace

int main(int argc, char** argv)
{
    test::glyph_arguments arguments;
    bool understood = true;
    for (int i = 1; i < argc; ++i) understood = understood && arguments.take(argc, argv, i);
    if (const int status = arguments.start(understood, "every_plate", 1, 2); status != 0) return status;
    totals all;
    for (const test::glyph_job& job : arguments.jobs()) look_at(arguments, job, all);
    std::printf(
        "glyphs %zu (%zu blank), plates %zu, refused %zu, with touching corners %zu, with narrower rims %zu; "
        "islands %zu, bridges %zu, loose islands %zu; wrong %zu\n",
        all.glyphs, all.blank, all.plates, all.refused, all.touching, all.narrower, all.islands, all.bridges, all.loose,
        all.wrong);
    return all.wrong == 0 ? 0 : 1;
}
