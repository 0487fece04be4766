// SPDX-License-Identifier: MIT
//
// The same glyph through both font libraries, every glyph of every smoke font.
//
// Tolerated differences, each with a law of its own that is tested in its place:
//
//   start       A contour may begin at another of its points: HarfBuzz and FreeType choose differently where TrueType leaves
//               the choice. The curves must agree in order.
//   fractions   FreeType (2.12, psft.c) draws unhinted CFF at "unity scale" and rounds down to whole units. Such outlines
//               must agree exactly once HarfBuzz's are rounded down too. Fonts: David CLM and Nachlieli CLM (culmus).
//   components  FreeType (2.12, ttgload.c) rounds the place of a component to whole units after it has varied it. Each contour
//               of a varied font must agree up to a shift of at most one unit (half a unit for each of two levels of
//               components). Fonts: Inter, away from its masters.
#include "support/catch.hpp"
#include "support/font_file.hpp"

#include <typemesh/adapt/freetype.hpp>
#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include <cmath>
#include <set>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

constexpr double tolerance = 1.0 / 64;

/// Rounds another source's outlines down to whole units.
template <class Source>
struct floored {
    Source& source;

    template <class Sink>
    struct flooring {
        Sink& to;
        static point down(point p) noexcept { return {std::floor(p.x), std::floor(p.y)}; }
        void move(point p) noexcept { to.move(down(p)); }
        void line(point p) noexcept { to.line(down(p)); }
        void quadratic(point c, point p) noexcept { to.quadratic(down(c), down(p)); }
        void cubic(point c, point d, point p) noexcept { to.cubic(down(c), down(d), down(p)); }
        void close() noexcept { to.close(); }
    };

    double units_per_em() const noexcept { return source.units_per_em(); }
    fill_rule fill() const noexcept { return source.fill(); }
    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        flooring<Sink> through{sink};
        return source.outline(id, through);
    }
};

bool agree(point a, point b, point shift)
{
    return std::fabs(a.x + shift.x - b.x) <= tolerance && std::fabs(a.y + shift.y - b.y) <= tolerance;
}

bool agree(const curve& a, const curve& b, point shift)
{
    if (a.degree != b.degree) return false;
    for (std::uint32_t i = 0; i <= a.degree; ++i)
        if (!agree(a.p[i], b.p[i], shift)) return false;
    return true;
}

/// Whether two contours agree from some start on, the first shifted by at most `most` along each axis.
bool agree(std::span<const curve> a, std::span<const curve> b, double most)
{
    if (a.size() != b.size()) return false;
    for (std::size_t start = 0; start < b.size(); ++start) {
        point shift;
        if (most > 0.0) {
            shift = b[start].p[0] - a[0].p[0];
            if (std::fabs(shift.x) > most + tolerance || std::fabs(shift.y) > most + tolerance) continue;
        }
        std::size_t i = 0;
        while (i < a.size() && agree(a[i], b[(start + i) % b.size()], shift)) ++i;
        if (i == a.size()) return true;
    }
    return false;
}

/// The contours' points all agree within their tolerance, shifts or none.
bool agree(const outline& a, const outline& b, double most)
{
    if (a.contour_count() != b.contour_count()) return false;
    for (std::uint32_t k = 0; k < a.contour_count(); ++k) {
        const auto contour = [k](const outline& o) { return o.curves.view().subspan(o.starts[k], o.starts[k + 1] - o.starts[k]); };
        if (!agree(contour(a), contour(b), most)) return false;
    }
    return true;
}

struct tally {
    std::size_t compared = 0;
    std::set<std::string> fractions;   // the files where each exception was needed
    std::set<std::string> components;
};

std::string short_name(const std::string& path) { return std::filesystem::path{path}.stem().string(); }

void compare(const std::string& path, const font_options& options, bool away_from_default, std::uint32_t step, tally& seen)
{
    INFO(path << ", face " << options.face);
    auto harfbuzz = harfbuzz_font::open(path.c_str(), options);
    auto freetype = freetype_font::open(path.c_str(), options);
    REQUIRE(bool(harfbuzz) == bool(freetype));
    if (!harfbuzz) {
        CHECK(harfbuzz.error() == error::no_outlines);
        CHECK(freetype.error() == error::no_outlines);
        return;
    }
    REQUIRE(harfbuzz->units_per_em() == freetype->units_per_em());
    REQUIRE(harfbuzz->glyph_count() == freetype->glyph_count());

    outline a, b;
    floored<harfbuzz_font> rounded_down{*harfbuzz};
    std::uint32_t wrong = 0, first_wrong = 0;
    for (glyph_id id = 0; id < harfbuzz->glyph_count(); id += step) {
        const error ea = record(*harfbuzz, id, a), eb = record(*freetype, id, b);
        ++seen.compared;
        bool fine = !ea && !eb && agree(a, b, 0.0);
        if (!fine && !ea && !eb) {
            if (away_from_default && agree(a, b, 1.0)) {
                seen.components.insert(short_name(path));
                fine = true;
            } else if (!record(rounded_down, id, a) && agree(a, b, 0.0)) {
                seen.fractions.insert(short_name(path));
                fine = true;
            }
        }
        if (!fine && wrong++ == 0) first_wrong = id;
    }
    INFO("first difference: glyph " << first_wrong);
    CHECK(wrong == 0);
}

std::vector<hb_ot_var_axis_info_t> axes_of(const harfbuzz_font& font)
{
    hb_face_t* face = hb_font_get_face(font.handle());
    unsigned count = hb_ot_var_get_axis_count(face);
    std::vector<hb_ot_var_axis_info_t> axes(count);
    if (count != 0) hb_ot_var_get_axis_infos(face, 0, &count, axes.data());
    return axes;
}

}  // namespace

TEST_CASE("HarfBuzz and FreeType draw every glyph of the smoke fonts alike, to 1/64 unit", "[conformance]")
{
    const bool all = std::getenv("TYPEMESH_EVERY_GLYPH") != nullptr;
    tally seen;
    for (const font_package& package : smoke_fonts()) {
        const auto files = font_files(package);
        if (files.empty()) WARN("left out: " << package.name << " is not installed");
        for (const std::string& path : files) {
            // The largest package alone takes longer than all others: every seventh glyph, unless all are asked for.
            const std::uint32_t step = package.required || all ? 1 : 7;
            std::uint32_t faces = 1;
            if (auto first = harfbuzz_font::open(path.c_str())) {
                hb_blob_t* blob = hb_face_reference_blob(hb_font_get_face(first->handle()));
                faces = hb_face_count(blob);
                hb_blob_destroy(blob);
            }
            for (std::uint32_t face = 0; face < faces; ++face) compare(path, {face, {}}, false, step, seen);

            auto font = harfbuzz_font::open(path.c_str());
            if (!font) continue;
            const auto axes = axes_of(*font);
            if (axes.empty()) continue;
            for (const float along : {0.0f, 1.0f, 0.63f}) {
                std::vector<variation> at;
                for (const auto& axis : axes) {
                    variation v;
                    hb_tag_to_string(axis.tag, v.tag);
                    v.value = axis.min_value + along * (axis.max_value - axis.min_value);
                    at.push_back(v);
                }
                INFO(along << " of the way along every axis");
                compare(path, {0, at}, true, 3, seen);
            }
        }
    }
    CHECK(seen.compared > 200000);

    // The exceptions are these fonts and no other.
    for (const std::string& name : seen.fractions) {
        INFO(name);
        CHECK((name.rfind("DavidCLM", 0) == 0 || name.rfind("NachlieliCLM", 0) == 0));
    }
    for (const std::string& name : seen.components) {
        INFO(name);
        CHECK(name.rfind("Inter", 0) == 0);
    }
}
