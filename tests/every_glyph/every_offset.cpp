// SPDX-License-Identifier: MIT
//
//     every_offset [--quality low|normal|high|best] [--step N] [--compare] FILE...
//
// Sweeps every glyph of every face of the fonts (variable ones at each axis' ends and at mixed corners as well) inwards
// at widths from 0.5 to 30 % of the em, with joins and without, in one band and in four, and checks the laws of
// support/swept_laws.hpp. --compare: the area within each level with that of the slow wavefront too and, where this was
// built with CGAL, mitred levels with the level sets of its skeleton. Prints what is broken, and a table; status 0 when
// nothing is.

#include "glyph_laws.hpp"
#include "offset_laws.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#ifdef TYPEMESH_TEST_WITH_CGAL
#include "skeleton_peer.hpp"

#include <sys/wait.h>
#include <unistd.h>
#endif

namespace {

struct totals {
    std::size_t faces = 0, glyphs = 0, blank = 0, sweeps = 0, refused = 0, broken = 0;
    double farthest_off_plane = 0.0;
    std::size_t compared = 0, differ = 0, failed = 0;  // slices; glyphs of which CGAL gave no skeleton
    std::vector<double> skeleton_ms;
    double sweep_ms = 0.0;  // of the same glyphs, at 2 % of the em, in one band
};

struct quality_named {
    const char* name;
    double tolerance;
};
constexpr quality_named qualities[] = {{"low", typemesh::quality::low},
                                       {"normal", typemesh::quality::normal},
                                       {"high", typemesh::quality::high},
                                       {"best", typemesh::quality::best}};

#ifdef TYPEMESH_TEST_WITH_CGAL
constexpr double compared_widths[] = {0.005, 0.01, 0.02, 0.03, 0.05};  // em
constexpr double same_area = 5e-5;                                     // square em

/// What a child process found out about one glyph: in a process of its own, since CGAL does not always come to an end.
struct comparison {
    double skeleton_ms = -1.0, sweep_ms = 0.0;
    double difference[std::size(compared_widths)] = {};  // symmetric, in square em; -1: the sweep was refused
};

comparison compare_with_skeleton(const typemesh::region& r)
{
    using namespace typemesh;
    comparison found;
    test::skeleton_peer peer;
    if (!peer.build(r)) return found;
    found.skeleton_ms = 1000.0 * peer.seconds();
    const double em = r.grid().units_per_em * r.grid().cells;
    workspace space;
    triangle_list triangles;
    if (monotone{}(r, space, triangles)) return found;
    for (std::size_t i = 0; i < std::size(compared_widths); ++i) {
        const double levels[] = {0.0, std::floor(compared_widths[i] * em)};
        swept_region swept;
        const auto start = std::chrono::steady_clock::now();
        workspace::scope scratch{space};
        const error e = sweep_inwards(r, triangles.view(), {.levels = levels, .mitre_limit = 0.0}, scratch, swept);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        if (i == 2) found.sweep_ms = 1000.0 * took.count();
        found.difference[i] = -1.0;
        if (e) continue;
        const auto faces = peer.beyond(levels[1]);
        std::vector<inspect::loop> both{faces.begin(), faces.end()};
        for (const inspect::loop l : inspect::loops_of(swept.cap)) both.push_back(l);
        found.difference[i] = inspect::doubled_filled_area(both, fill_rule::even_odd) / 2 / em / em;
    }
    return found;
}

void compare(const typemesh::region& r, const std::string& name, totals& sum)
{
    int ends[2];
    if (r.is_touching() || pipe(ends) != 0) return;
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        alarm(20);
        const comparison found = compare_with_skeleton(r);
        const auto written = write(ends[1], &found, sizeof found);
        _exit(written == sizeof found ? 0 : 1);
    }
    close(ends[1]);
    comparison found;
    const bool came = child > 0 && read(ends[0], &found, sizeof found) == sizeof found && found.skeleton_ms >= 0;
    close(ends[0]);
    if (child > 0) waitpid(child, nullptr, 0);
    if (!came) {
        ++sum.failed;
        std::printf("%s: CGAL gives no skeleton\n", name.c_str());
        return;
    }
    sum.skeleton_ms.push_back(found.skeleton_ms);
    sum.sweep_ms += found.sweep_ms;
    for (std::size_t i = 0; i < std::size(compared_widths); ++i) {
        ++sum.compared;
        const double d = found.difference[i];
        if (d >= 0 && d <= same_area) continue;
        ++sum.differ;
        std::printf("%s at %g em: differs from CGAL's skeleton by %.2g em2\n", name.c_str(), compared_widths[i], d);
    }
}
#endif

int usage()
{
    std::fprintf(stderr, "every_offset [--quality low|normal|high|best] [--step N] [--compare] FILE...\n");
    return 2;
}

void look_at(const test::face_instance& face, std::uint32_t step, double tolerance, bool comparing, totals& sum)
{
    auto font = face.open();
    if (!font) return;
    ++sum.faces;
    test::offset_laws laws;
    for (std::uint32_t g = 0; g < face.glyph_count; g += step) {
        const std::string name = face.name() + " " + std::to_string(g);
        const test::offset_findings f = laws.examine(*font, g, tolerance, comparing);
        ++sum.glyphs;
        sum.blank += f.blank;
        sum.sweeps += f.sweeps;
        sum.refused += f.refused;
        sum.farthest_off_plane = (std::max)(sum.farthest_off_plane, f.farthest_off_plane);
        if (!f.wrong.empty()) {
            ++sum.broken;
            std::printf("%s: %s\n", name.c_str(), f.wrong.c_str());
        }
        if (f.refused != 0) std::printf("%s: refused %zu times\n", name.c_str(), f.refused);
#ifdef TYPEMESH_TEST_WITH_CGAL
        if (comparing && !f.blank) compare(laws.region_of(*font, g, tolerance), name, sum);
#endif
    }
}

}  // namespace

int main(int argc, char** argv)
{
    double tolerance = typemesh::quality::high;
    std::uint32_t step = 1;
    bool comparing = false;
    std::vector<std::string> files;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--quality" && i + 1 < argc) {
            const std::string wanted = argv[++i];
            const auto* q = std::find_if(std::begin(qualities), std::end(qualities),
                                         [&](const quality_named& one) { return wanted == one.name; });
            if (q == std::end(qualities)) return usage();
            tolerance = q->tolerance;
        } else if (word == "--step" && i + 1 < argc) {
            step = static_cast<std::uint32_t>((std::max)(1, std::atoi(argv[++i])));
        } else if (word == "--compare") {
            comparing = true;
        } else if (word.rfind("--", 0) == 0) {
            return usage();
        } else {
            files.push_back(word);
        }
    }
    if (files.empty()) return usage();
    totals sum;
    for (const std::string& file : files)
        for (const test::face_instance& face : test::instances_of(file)) look_at(face, step, tolerance, comparing, sum);

    std::printf("faces %zu, glyphs %zu (%zu blank), sweeps %zu, refused %zu, broken %zu glyphs, off plane %.2f cells\n",
                sum.faces, sum.glyphs, sum.blank, sum.sweeps, sum.refused, sum.broken, sum.farthest_off_plane);
#ifdef TYPEMESH_TEST_WITH_CGAL
    if (!sum.skeleton_ms.empty()) {
        std::sort(sum.skeleton_ms.begin(), sum.skeleton_ms.end());
        const double count = static_cast<double>(sum.skeleton_ms.size());
        double all = 0.0;
        for (const double ms : sum.skeleton_ms) all += ms;
        std::printf(
            "CGAL: %zu slices compared, %zu differ by more than %g em2, no skeleton of %zu glyphs; a glyph's "
            "skeleton takes %.2f ms (median %.2f), its sweep to 2 %% of the em %.3f ms\n",
            sum.compared, sum.differ, same_area, sum.failed, all / count, sum.skeleton_ms[sum.skeleton_ms.size() / 2],
            sum.sweep_ms / count);
    }
#else
    if (comparing) std::printf("not compared with a skeleton: CGAL was not found when this was built\n");
#endif
    return sum.broken == 0 ? 0 : 1;
}
