// SPDX-License-Identifier: MIT
//
// The benchmark of the thesis ("Study of mesh generation and optimization techniques applied to parametric forms", J.
// Vandenbergh, 2020, chapter 7): its 219 texts in the fonts that stand in for its own (five for Latin, one for each other
// script), four qualities, both triangulators, its way to flatten curves and `certified`; flat, extruded, bevelled. Timed is
// the whole way from the text to vertices and indices in arrays that are there, nothing kept from one text to the next,
// every letter built anew, the result fit into [-1, 1]; opening fonts is not timed.
//
//     bench_thesis time RUNS BEVELLED_RUNS     rows (../README.md): times of each text, of groups, of stages, and of floors
//     bench_thesis triangles                   each text flat, monotone, quality normal: lines for pages/sheets.py
//
// Means of groups are by the processor's clock, those of texts and medians by the wall's. Floors: HarfBuzz's shaping and
// outlines; a sort of the flat mesh's points as 64-bit keys; a memcpy of the extruded mesh.
// Fonts are looked for under $TYPEMESH_FONT_DIR (default /usr/share/fonts).

#include "cells.hpp"

#include <cstring>
#include <fstream>
#include <list>

namespace {

using namespace bench;

/// Fails where the file is not there: the texts lie beside the sources.
std::vector<std::string> lines_of(const std::string& file)
{
    std::ifstream in{TYPEMESH_TEST_DATA "/workload/" + file};
    std::vector<std::string> all;
    for (std::string line; std::getline(in, line);) all.push_back(line);
    if (all.empty()) std::fprintf(stderr, "no texts: %s\n", file.c_str()), std::exit(1);
    return all;
}

std::list<text_group> all_groups()
{
    std::list<text_group> groups;
    for (const char* script : {"latin", "arabic", "chinese", "japanese"}) {
        groups.push_back({script, "character", lines_of(std::string{"chars-"} + script + ".txt")});
        groups.push_back({script, "phrase", lines_of(std::string{"phrases-"} + script + ".txt")});
    }
    groups.push_back({"latin", "long", lines_of("long-latin.txt")});
    return groups;
}

struct stand_in {
    const char *script, *name, *stands_for, *file, *package;
};
constexpr stand_in stand_ins[] = {
    {"latin", "DejaVu Sans", "Tahoma", "truetype/dejavu/DejaVuSans.ttf", "fonts-dejavu-core"},
    {"latin", "Liberation Sans", "Arial", "truetype/liberation/LiberationSans-Regular.ttf", "fonts-liberation"},
    {"latin", "Comic Neue", "Comic Sans MS", "opentype/comic-neue/ComicNeue-Regular.otf", "fonts-comic-neue"},
    {"latin", "Liberation Serif", "Times New Roman", "truetype/liberation/LiberationSerif-Regular.ttf",
     "fonts-liberation"},
    {"latin", "Liberation Mono", "Courier New", "truetype/liberation/LiberationMono-Regular.ttf", "fonts-liberation"},
    {"arabic", "Amiri", "-", "opentype/fonts-hosny-amiri/Amiri-Regular.ttf", "fonts-hosny-amiri"},
    {"chinese", "WenQuanYi Micro Hei", "-", "truetype/wqy/wqy-microhei.ttc", "fonts-wqy-microhei"},
    {"japanese", "Sawarabi Mincho", "-", "truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf",
     "fonts-sawarabi-mincho"},
};

std::list<protocol_font> open_fonts(const std::list<text_group>& groups)
{
    const char* folder = std::getenv("TYPEMESH_FONT_DIR");
    std::list<protocol_font> fonts;
    for (const stand_in& s : stand_ins) {
        auto opened =
            harfbuzz_font::open((std::string{folder != nullptr ? folder : "/usr/share/fonts"} + "/" + s.file).c_str());
        if (!opened) {
            std::printf("skipped\t%s\t%s Debian has it in %s.\n", s.name, opened.error().message(), s.package);
            continue;
        }
        fonts.push_back({s.name, s.stands_for, std::move(*opened), {}});
        for (const text_group& g : groups)
            if (std::strcmp(g.script, s.script) == 0) fonts.back().groups.push_back(&g);
    }
    return fonts;
}

/// The mean time of work(text) over the texts of a group, by the processor's clock.
template <class Work>
double microseconds_each(const text_group& group, int runs, Work&& work)
{
    for (const std::string& text : group.texts) work(text);
    const double start = seconds_of_processor();
    for (int run = 0; run < runs; ++run)
        for (const std::string& text : group.texts) work(text);
    return 1e6 * (seconds_of_processor() - start) / runs / static_cast<double>(group.texts.size());
}

void print_floors(protocol_font& f, const text_group& group, const quality_preset& q, int runs)
{
    glyph_run run;
    plain_layout layout;
    ignore_outline sink;
    const double outline = microseconds_each(group, runs, [&](const std::string& text) {
        if (!layout(f.font, text, {}, {}, run)) std::abort();
        for (const placed_glyph& g : run.glyphs)
            if (f.font.outline(g.id, sink)) std::abort();
    });

    struct finished {
        std::vector<std::uint64_t> keys;
        std::vector<full_vertex> vertices;
        std::vector<std::uint32_t> indices;
    };
    std::vector<finished> all;
    for (const std::string& text : group.texts) {
        finished& m = all.emplace_back();
        const text_options options{.tolerance = q.tolerance, .reuse = false};
        if (!text_mesher{f.font}.with(flat{}).build(text, into(m.vertices, m.indices), options)) std::abort();
        for (const full_vertex& v : m.vertices)
            m.keys.push_back(std::uint64_t(std::int64_t(1e6F * v.position.x) + (1LL << 31)) << 32 |
                             std::uint64_t(std::int64_t(1e6F * v.position.y) + (1LL << 31)));
        m.vertices.clear(), m.indices.clear();
        if (!text_mesher{f.font}.build(text, into(m.vertices, m.indices), options)) std::abort();
    }
    const auto each_mesh = [&](auto&& work) {
        std::size_t i = 0;
        return microseconds_each(group, runs, [&](const std::string&) { work(all[i++ % all.size()]); });
    };
    std::vector<std::uint64_t> keys;
    const double sort = each_mesh([&](const finished& m) {
        keys = m.keys;
        std::sort(keys.begin(), keys.end());
    });
    std::vector<full_vertex> vertices;
    std::vector<std::uint32_t> indices;
    const double copy = each_mesh([&](const finished& m) {
        vertices.resize(m.vertices.size());
        indices.resize(m.indices.size());
        std::memcpy(static_cast<void*>(vertices.data()), m.vertices.data(), m.vertices.size() * sizeof(full_vertex));
        std::memcpy(indices.data(), m.indices.data(), 4 * m.indices.size());
    });
    std::printf("thesis_floor\t%s\t%s\t%s\t%s\t%.4f\t%.4f\t%.4f\n", q.name, f.name, group.script, group.category,
                outline, sort, copy);
}

int time_all(int runs, int bevelled_runs)
{
    const auto groups = all_groups();
    auto fonts = open_fonts(groups);
    struct solid {
        void (*add)(cell_rows&, protocol_font&);
        int runs;
        cell_rows rows;
    };
    std::array<solid, 3> solids{
        {{add_flat_rows, runs, {}}, {add_extruded_rows, runs, {}}, {add_bevelled_rows, bevelled_runs, {}}}};
    for (solid& s : solids)
        for (protocol_font& f : fonts) s.add(s.rows, f);

    const char* cell = "solid\ttriangulator\tdiscretiser\tquality\tfont\tstands_for\tscript\tcategory";
    std::printf("columns\tthesis\t%s\ttext\truns\tmean_us\tmedian_us\tvertices\ttriangles\n", cell);
    std::printf("columns\tthesis_group\t%s\ttexts\truns\tmean_us\n", cell);
    std::printf(
        "columns\tthesis_stages\t%s\tshape_us\toutline_us\tdiscretise_us\tfill_us\ttriangulate_us\textrude_us\n", cell);
    std::printf("columns\tthesis_floor\tquality\tfont\tscript\tcategory\toutline_us\tsort_us\tmemcpy_us\n");

    // All take turns, so that what else the machine does falls on all.
    const int rounds = std::min({5, runs, bevelled_runs});
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < solids[0].rows.size(); ++i) {
            for (solid& s : solids) s.rows[i]->time(s.runs / rounds);
            if (i % 32 == 0) {
                const auto done = static_cast<double>(static_cast<std::size_t>(round) * solids[0].rows.size() + i);
                std::fprintf(stderr, "at %.0f %%\n",
                             98 * done / static_cast<double>(rounds) / static_cast<double>(solids[0].rows.size()));
            }
        }
    for (solid& s : solids)
        for (auto& row : s.rows) row->print();
    for (protocol_font& f : fonts)
        for (const text_group* group : f.groups)
            for (const quality_preset& q : qualities) print_floors(f, *group, q, runs);
    return 0;
}

/// A line a text: script, font, text, then "x y ..." of the vertices, then "a b c ..." of the triangles; parted by tabs.
int print_triangles()
{
    const auto groups = all_groups();
    auto fonts = open_fonts(groups);

    for (protocol_font& f : fonts) {
        if (std::strcmp(f.groups.front()->script, "latin") == 0 && std::strcmp(f.name, "Liberation Serif") != 0)
            continue;  // one font a script
        for (const text_group* group : f.groups)
            for (const std::string& text : group->texts) {
                std::vector<full_vertex> vertices;
                std::vector<std::uint32_t> indices;
                if (!text_mesher{f.font}.with(flat{}).build(text, into(vertices, indices),
                                                            {.tolerance = quality::normal}))
                    std::abort();
                std::printf("%s\t%s\t%s\t", group->script, f.name, text.c_str());
                for (const full_vertex& v : vertices)
                    std::printf("%.4f %.4f ", static_cast<double>(v.position.x), static_cast<double>(v.position.y));
                std::putchar('\t');
                for (const std::uint32_t i : indices) std::printf("%u ", i);
                std::putchar('\n');
            }
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc == 4 && std::strcmp(argv[1], "time") == 0) return time_all(std::atoi(argv[2]), std::atoi(argv[3]));
    if (argc == 2 && std::strcmp(argv[1], "triangles") == 0) return print_triangles();
    return std::fputs("usage: bench_thesis time RUNS BEVELLED_RUNS | triangles\n", stderr), 2;
}
