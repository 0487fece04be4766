// SPDX-License-Identifier: MIT
//
//     every_refined [--most N] [--quality low|normal|high|best]... [--step N] [--threads N] [NAME=]FILE_OR_FOLDER...
//
// Refines every glyph of every face of the fonts with each refiner at three sizes, alone and merged with a copy that
// overlaps it, makes extruded, bevelled and hollow solids of it, and checks the laws of refined_laws.hpp. --most: so many
// glyphs of a face, spread over it. Prints broken laws and a table; the status is 0 if no law is broken.

#include "refined_laws.hpp"
#include "support/glyph_arguments.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <vector>

namespace {

constexpr const char* refiners[] = {"delaunay", "quadtree", "non_obtuse"};
constexpr std::size_t refiner_count = std::size(refiners);

/// A row of the table.
struct total {
    std::size_t glyphs = 0, invalid = 0;
    test::refined_findings all;

    void add(const total& t)
    {
        glyphs += t.glyphs, invalid += t.invalid;
        all.add(t.all);
    }
    void print(const char* name, const char* refiner) const
    {
        std::printf(
            "%-34s %-10s %7zu %8zu %8zu %11zu %7zu %6zu %6zu %8zu %8zu %7zu %7zu %6zu %6zu %7zu %6zu %6zu %8.3f "
            "%7.3f\n",
            name, refiner, glyphs, all.caps, all.solids, all.triangles, invalid, all.refused, all.narrowed,
            all.at_corners, all.crowded, all.small, all.small_in_bevels, all.wide, all.wide_in_bevels, all.wide_crowded,
            all.wide_at_slopes, all.long_edges, all.greatest, all.area_off);
    }
};

/// Examines glyphs on one thread.
class worker {
public:
    worker(const test::glyph_arguments& arguments, std::uint32_t most, std::vector<total>& totals, std::mutex& lock)
        : arguments_{arguments}, most_{most}, totals_{totals}, lock_{lock}
    {
    }

    void operator()(const test::glyph_job& job)
    {
        total sums[refiner_count];
        arguments_.each_glyph(job, [&](auto& font, std::uint32_t g) {
            if (!is_one_of_most(job, g)) return;
            for (total& sum : sums) ++sum.glyphs;
            for (const test::quality_named& q : arguments_.wanted)
                for (const bool merged : {false, true}) {
                    if (!laws_.take(font, g, q.tolerance, merged)) continue;
                    for (const float size : test::refined_laws::sizes) {
                        add(sums[0], laws_.examine_delaunay(size), job, g, merged, size, refiners[0]);
                        add(sums[1], laws_.examine_quadtree(size), job, g, merged, size, refiners[1]);
                        add(sums[2], laws_.examine_non_obtuse(size), job, g, merged, size, refiners[2]);
                    }
                }
        });
        const std::lock_guard guard{lock_};
        for (std::size_t r = 0; r < refiner_count; ++r) totals_[job.group * refiner_count + r].add(sums[r]);
        std::fprintf(stderr, "\r%.0f s ", arguments_.seconds());
    }

private:
    [[nodiscard]] bool is_one_of_most(const test::glyph_job& job, std::uint32_t g) const
    {
        const std::uint64_t count = job.face.glyph_count, most = (std::min)(most_, job.face.glyph_count);
        return job.last - job.first == 1 || g * most / count != (g + 1) * most / count;
    }
    void add(total& sum, const test::refined_findings& f, const test::glyph_job& job, std::uint32_t g, bool merged,
             float size, const char* refiner)
    {
        sum.all.add(f);
        sum.invalid += !f.wrong.empty();
        if (f.wrong.empty() && f.small == 0 && f.wide == 0 && f.small_in_bevels == 0 && f.wide_in_bevels == 0 &&
            f.long_edges == 0)
            return;
        const std::lock_guard guard{lock_};
        std::printf("%s@%u:%u%s %s at %g em: %s (%zu and %zu small, %zu and %zu wide, %zu long)\n",
                    job.face.path.c_str(), job.face.face, g, merged ? " merged" : "", refiner, double(size),
                    f.wrong.c_str(), f.small, f.small_in_bevels, f.wide, f.wide_in_bevels, f.long_edges);
        std::fflush(stdout);
    }

    const test::glyph_arguments& arguments_;
    std::uint32_t most_;
    std::vector<total>& totals_;
    std::mutex& lock_;
    test::refined_laws laws_;
};

void print(const test::glyph_arguments& arguments, const std::vector<total>& totals)
{
    std::printf("%-34s %-10s %7s %8s %8s %11s %7s %6s %6s %8s %8s %7s %7s %6s %6s %7s %6s %6s %8s %7s\n", "", "",
                "glyphs", "caps", "solids", "triangles", "invalid", "refus.", "narr.", "corners", "crowded", "small",
                "bevels", "wide", "bevels", "crowded", "slopes", "long", "greatest", "area");
    total all[refiner_count];
    for (std::size_t i = 0; i < totals.size(); ++i) {
        const std::string& name = arguments.groups()[i / refiner_count].name;
        totals[i].print((name.size() > 34 ? "..." + name.substr(name.size() - 31) : name).c_str(),
                        refiners[i % refiner_count]);
        all[i % refiner_count].add(totals[i]);
    }
    for (std::size_t r = 0; r < refiner_count; ++r) all[r].print("all", refiners[r]);
    std::printf(
        "triangles below %.2f degrees: at sharp corners, with edges below 8 cells (crowded), others (small), others in "
        "caps within bevels; wide: above 90 degrees beyond rounding; others in caps within bevels: in triangles lower "
        "than 8 cells (crowded), at edges of slopes without room for a foot (slopes), others (bevels); greatest: "
        "angle; area: the worst difference, as a "
        "share of (tolerance + 1 cell) x boundary\n%.0f s\n",
        test::refined_laws::least_angle, arguments.seconds());
}

}  // namespace

int main(int argc, char** argv)
{
    test::glyph_arguments arguments;
    std::uint32_t most = ~0u;
    bool understood = true;
    for (int i = 1; i < argc; ++i) {
        if (std::string{argv[i]} == "--most" && i + 1 < argc)
            most = static_cast<std::uint32_t>((std::max)(1, std::atoi(argv[++i])));
        else
            understood = understood && arguments.take(argc, argv, i);
    }
    if (const int status = arguments.start(understood, "every_refined [--most N]", 2, 3); status != 0) return status;
    std::vector<total> totals(arguments.groups().size() * refiner_count);
    std::mutex lock;
    arguments.work([&] { return worker{arguments, most, totals, lock}; });
    print(arguments, totals);
    return std::any_of(totals.begin(), totals.end(), [](const total& t) { return t.invalid != 0; }) ? 1 : 0;
}
