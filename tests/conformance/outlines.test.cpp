// SPDX-License-Identifier: MIT
//
// The same glyph through both font libraries, every glyph of every smoke font.
//
// Tolerated differences, each with a law of its own that is tested in its place:
//
//   start       A contour may begin at another of its points: HarfBuzz and FreeType choose differently where TrueType
//               leaves the choice. The curves must agree in order.
//   fractions   FreeType (2.12, psft.c) draws unhinted CFF at "unity scale" and rounds down to whole units: each
//               coordinate may lie up to one unit below HarfBuzz's, and what becomes a line of no length is gone. Fonts:
//               those of culmus (with Debian 12, David CLM and Nachlieli CLM alone).
//   components  FreeType (2.12, ttgload.c) rounds the place of a component to whole units after it has varied it. Each
//               contour of a varied font must agree up to a shift of at most one unit (half a unit for each of two
//               levels of components). Fonts: Inter, away from its masters.
//   sums        FreeType adds up the deltas of several regions, and infers those between, in fixed point: up to 1/32
//               unit, in few glyphs. Fonts: Inter, away from its masters.
#include "support/catch.hpp"
#include "support/font_file.hpp"

#include <typemesh/adapt/freetype.hpp>
#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include <cmath>
#include <set>
#include <span>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

constexpr double tolerance = 1.0 / 64;

/// How far b's coordinates lie from a's, along one axis.
struct spread {
    double lowest = 1e300, highest = -1e300;

    void add(double difference)
    {
        lowest = std::fmin(lowest, difference);
        highest = std::fmax(highest, difference);
    }
};

/// The laws: what the differences, FreeType less HarfBuzz, of one contour may be.
bool equal(spread s) { return s.lowest >= -tolerance && s.highest <= tolerance; }
bool summed(spread s) { return s.lowest >= -2 * tolerance && s.highest <= 2 * tolerance; }
bool shifted(spread s) { return s.highest - s.lowest <= 4 * tolerance && std::fabs(s.highest + s.lowest) / 2 <= 1.0; }
bool rounded_down(spread s) { return s.lowest >= -1.0 - tolerance && s.highest <= tolerance; }

using law = bool (*)(spread);

/// Whether two contours agree by a law, along both axes and from some start on.
bool agree(std::span<const curve> a, std::span<const curve> b, law holds)
{
    if (a.size() != b.size()) return false;
    for (std::size_t start = 0; start < b.size(); ++start) {
        spread x, y;
        bool fine = true;
        for (std::size_t i = 0; i < a.size() && fine; ++i) {
            const curve &c = a[i], &d = b[(start + i) % b.size()];
            fine = c.degree == d.degree;
            for (std::uint32_t k = 0; k <= c.degree && fine; ++k) {
                x.add(d.p[k].x - c.p[k].x);
                y.add(d.p[k].y - c.p[k].y);
            }
            fine = fine && holds(x) && holds(y);
        }
        if (fine) return true;
    }
    return a.empty();
}

/// A contour's curves. `whole`: without the lines that have no length in whole units. Such are also those that close a
/// contour whose decimals (CFF) do not add up to nothing.
std::vector<curve> contour(const outline& o, std::uint32_t k, bool whole)
{
    const auto down = [](point p) { return point{std::floor(p.x + tolerance), std::floor(p.y + tolerance)}; };
    std::vector<curve> kept;
    for (const curve& c : o.curves.view().subspan(o.starts[k], o.starts[k + 1] - o.starts[k]))
        if (!whole || c.degree != 1 || down(c.start()) != down(c.end())) kept.push_back(c);
    return kept;
}

bool agree(const outline& a, const outline& b, law holds, bool whole = false)
{
    if (a.contour_count() != b.contour_count()) return false;
    for (std::uint32_t k = 0; k < a.contour_count(); ++k)
        if (!agree(contour(a, k, whole), contour(b, k, whole), holds)) return false;
    return true;
}

struct tally {
    std::size_t compared = 0;
    std::size_t varied = 0;
    std::size_t sums = 0;  // how often each exception was needed, and where
    std::set<std::string> fractions;
    std::set<std::string> components;
};

std::string short_name(const std::string& path) { return std::filesystem::path{path}.stem().string(); }

void compare(const std::string& path, const font_options& options, bool varied, tally& seen)
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
    std::uint32_t wrong = 0, first_wrong = 0;
    for (glyph_id id = 0; id < harfbuzz->glyph_count(); ++id) {
        const error ea = record(*harfbuzz, id, a).error(), eb = record(*freetype, id, b).error();
        ++seen.compared;
        seen.varied += varied ? 1 : 0;
        bool fine = !ea && !eb && agree(a, b, equal);
        if (!fine && !ea && !eb) {
            if (varied && agree(a, b, summed))
                ++seen.sums, fine = true;
            else if (varied && agree(a, b, shifted))
                seen.components.insert(short_name(path)), fine = true;
            else if (!varied && agree(a, b, rounded_down, true))
                seen.fractions.insert(short_name(path)), fine = true;
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
    tally seen;
    for (const font_package& package : smoke_fonts()) {
        const auto files = font_files(package);
        if (files.empty()) WARN("left out: " << package.name << " is not installed");
        for (const std::string& path : files) {
            std::uint32_t faces = 1;
            if (auto first = harfbuzz_font::open(path.c_str())) {
                hb_blob_t* blob = hb_face_reference_blob(hb_font_get_face(first->handle()));
                faces = hb_face_count(blob);
                hb_blob_destroy(blob);
            }
            for (std::uint32_t face = 0; face < faces; ++face) compare(path, {face, {}}, false, seen);

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
                compare(path, {0, at}, true, seen);
            }
        }
    }
    CHECK(seen.compared > 200000);

    // The exceptions are these fonts and no other.
    CHECK(seen.sums * 50 < seen.varied);
    for (const std::string& name : seen.fractions) CHECK((name.find("CLM") != name.npos ? "" : name) == "");
    for (const std::string& name : seen.components) CHECK((name.rfind("Inter", 0) == 0 ? "" : name) == "");
}
