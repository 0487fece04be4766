// SPDX-License-Identifier: MIT
//
// typemesh, at 1/800 em and at further tolerances, and the floor: HarfBuzz's shaping and outline extraction alone.
//
//     typemesh time TEXTS SECONDS [TOLERANCE...]       in em
//     typemesh meshes FOLDER FONT [TOLERANCE...]

#include "full_vertex.hpp"
#include "peer_program.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/paragraph/total_fit.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdlib>
#include <memory>

namespace {

using namespace typemesh;

struct output {
    std::vector<bench::full_vertex> vertices;
    std::vector<std::uint32_t> indices;

    [[nodiscard]] peers::mesh made() const
    {
        peers::mesh m;
        for (const bench::full_vertex& v : vertices)
            for (const float x : {v.position.x, v.position.y, v.position.z}) m.points.push_back(x);
        m.corners = indices;
        return m;
    }
};

std::string name_of(double tolerance)
{
    char text[32];
    std::snprintf(text, sizeof text, "1/%.0f em", 1.0 / tolerance);
    return text;
}

/// What text_mesher makes with this extruder: cold, with and without reuse, and from a cache.
template <class Extruder>
void add_ways(std::vector<peers::way>& ways, const std::shared_ptr<harfbuzz_font>& font, const std::string& setting,
              const char* solid, double tolerance, const Extruder& extruder)
{
    const auto to = std::make_shared<output>();
    const auto made = [to] { return to->made(); };
    const auto cold = std::make_shared<decltype(text_mesher{*font}.with(extruder))>(text_mesher{*font}.with(extruder));
    const auto build = [font, to, tolerance](auto& mesher, const std::string& text, bool reuse) {
        return bool(mesher.build(text, into(to->vertices, to->indices), {.tolerance = tolerance, .reuse = reuse}));
    };
    ways.push_back({setting, solid, "cold", [=](const std::string& t) { return build(*cold, t, false); }, made});
    ways.push_back({setting, solid, "reuse", [=](const std::string& t) { return build(*cold, t, true); }, made});
    const auto cache = std::make_shared<glyph_cache<>>();
    const auto kept = [&] { return text_mesher{*font}.with(extruder).with(cached_in{*cache, 1}); };
    const auto warm = std::make_shared<decltype(kept())>(kept());
    ways.push_back(
        {setting, solid, "warm", [=, keep = cache](const std::string& t) { return build(*warm, t, true); }, made});
    const auto instances = std::make_shared<std::vector<glyph_instance>>();
    ways.push_back({setting,
                    solid,
                    "placed",
                    [=, keep = cache](const std::string& t) {
                        const auto plan = warm->plan(t, {.tolerance = tolerance});
                        if (!plan) return false;
                        instances->clear();
                        plan->write_instances([&](const glyph_instance& i) noexcept { instances->push_back(i); });
                        return true;
                    },
                    {}});
}

/// A paragraph in justified lines of 12 em, broken as Knuth and Plass do.
template <class Mesher>
peers::way wrapped(const std::shared_ptr<harfbuzz_font>& font, const char* state, const std::shared_ptr<Mesher>& mesher)
{
    using words_type = decltype(paragraph{*font, heap(), unicode_analyser{}, total_fit{}});
    const auto words = std::make_shared<words_type>(*font, heap(), unicode_analyser{}, total_fit{});
    const auto run = std::make_shared<glyph_run>();
    const auto to = std::make_shared<output>();
    return {name_of(quality::high), "wrapped", state,
            [=, keep = font](const std::string& text) {
                return words->set(text).has_value() &&
                       words->lay_out({.width = 12.0, .align = alignment::justify}, *run).has_value() &&
                       bool(mesher->build(*run, into(to->vertices, to->indices)));
            },
            [to] { return to->made(); }};
}

peers::way floor_of(const std::shared_ptr<harfbuzz_font>& font)
{
    const auto run = std::make_shared<glyph_run>();
    const auto layout = std::make_shared<plain_layout>();
    return {"shaping and outlines",
            "-",
            "cold",
            [=](const std::string& text) {
                ignore_outline sink;
                if (!(*layout)(*font, text, {}, {}, *run)) return false;
                for (const placed_glyph& g : run->glyphs)
                    if (font->outline(g.id, sink)) return false;
                return true;
            },
            {},
            "floor"};
}

}  // namespace

int main(int argc, char** argv)
{
    std::vector<double> tolerances;
    for (; argc > 4; --argc) tolerances.insert(tolerances.begin(), std::atof(argv[argc - 1]));
    const bool times = argc == 4 && std::strcmp(argv[1], "time") == 0;
    return peers::run(argc, argv, "typemesh", [&](const std::string& file) -> std::vector<peers::way> {
        auto opened = harfbuzz_font::open(file.c_str());
        if (!opened) return {};
        const auto font = std::make_shared<harfbuzz_font>(std::move(*opened));
        std::vector<peers::way> ways;
        const float depth = peers::depth;
        if (times) ways.push_back(floor_of(font));
        add_ways(ways, font, name_of(quality::high), "extruded", quality::high, extruded<>{.depth = depth});
        const float width = peers::bevel_width;
        const bevelled bevel{.depth = depth, .width = width, .bevel_depth = width, .profile = round_profile(3)};
        add_ways(ways, font, name_of(quality::high), "bevelled", quality::high, bevel);
        const extruded<> plain{.depth = depth};
        static glyph_cache<> cache;
        cache.clear();
        using cold = decltype(text_mesher{*font}.with(plain));
        using warm = decltype(text_mesher{*font}.with(plain).with(cached_in{cache, 1}));
        if (times) {
            ways.push_back(wrapped(font, "reuse", std::make_shared<cold>(text_mesher{*font}.with(plain))));
            ways.push_back(wrapped(font, "warm",
                                   std::make_shared<warm>(text_mesher{*font}.with(plain).with(cached_in{cache, 1}))));
        }
        for (const double t : tolerances) add_ways(ways, font, name_of(t), "extruded", t, extruded<>{.depth = depth});
        return ways;
    });
}
