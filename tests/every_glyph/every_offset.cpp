// SPDX-License-Identifier: MIT
//
//     every_offset [--compare] [--quality low|normal|high|best]... [--step N] [NAME=]FILE_OR_FOLDER...
//
// Sweeps every glyph of every face of the fonts (variable ones also at each axis' ends and at mixed corners) inwards at
// widths from 0.5 to 30 % of the em, with joins and without, in one band and in four, and checks the laws of
// support/swept_laws.hpp. --compare: compares the area within each level with the slow wavefront's and, if this was built
// with CGAL, mitred levels with the level sets of its skeleton. Prints broken laws and a table; the status is 0 if no law
// is broken.

#include "offset_laws.hpp"
#include "support/glyph_arguments.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
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
    std::size_t compared = 0, differ = 0, failed = 0;  // slices, and glyphs without a skeleton from CGAL
    std::vector<double> skeleton_ms;
    double sweep_ms = 0.0;  // of the same glyphs, at 2 % of the em, in one band
};

#ifdef TYPEMESH_TEST_WITH_CGAL
constexpr double compared_widths[] = {0.005, 0.01, 0.02, 0.03, 0.05};  // em
constexpr double same_area = 5e-5;                                     // square em

/// What a child process found out about one glyph. CGAL needs its own process, because it does not always end.
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

void look_at(const test::glyph_arguments& arguments, const test::glyph_job& job, bool comparing, totals& sum)
{
    test::offset_laws laws;
    arguments.each_glyph(job, [&](auto& font, std::uint32_t g) {
        const std::string name = job.face.name() + " " + std::to_string(g);
        ++sum.glyphs;
        for (const test::quality_named& q : arguments.wanted) {
            const test::offset_findings f = laws.examine(font, g, q.tolerance, comparing);
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
            if (comparing && !f.blank) compare(laws.region_of(font, g, q.tolerance), name, sum);
#endif
        }
    });
}

}  // namespace

int main(int argc, char** argv)
{
    test::glyph_arguments arguments;
    bool comparing = false, understood = true;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--compare") == 0)
            comparing = true;
        else
            understood = understood && arguments.take(argc, argv, i);
    }
    if (const int status = arguments.start(understood, "every_offset [--compare]", 2, 3); status != 0) return status;
    totals sum;
    for (const test::glyph_group& g : arguments.groups()) sum.faces += g.faces;
    for (const test::glyph_job& job : arguments.jobs())
        look_at(arguments, job, comparing, sum);  // CGAL needs processes

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
