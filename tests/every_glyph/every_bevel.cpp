// SPDX-License-Identifier: MIT
//
//     every_bevel [--delaunay] [--compare N] [--most N] [--quality low|normal|high|best]... [--step N] [--threads N]
//                 [NAME=]FILE_OR_FOLDER...
//
// Bevels every glyph of every face of the fonts (variable ones also at each axis' ends and at mixed corners) at widths from
// 0.5 to 30 % of the em, and checks the laws of bevel_laws.hpp. --delaunay: with constrained_delaunay instead of monotone.
// --compare: compares each Nth glyph, if it has at most 100 points, with the slow wavefront. --most: so many glyphs of a
// face, spread over it. Prints broken laws and a table; the status is 0 if no law is broken.

#include "bevel_laws.hpp"
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

constexpr std::size_t width_count = std::size(test::bevel_laws::widths);

/// A row of the table.
struct total {
    std::size_t glyphs = 0, meshes = 0, invalid = 0, narrowed = 0, compared = 0;
    double volume_error = 0.0, height_error = 0.0;

    void add(const total& t)
    {
        glyphs += t.glyphs, meshes += t.meshes, invalid += t.invalid, narrowed += t.narrowed, compared += t.compared;
        volume_error = (std::max)(volume_error, t.volume_error);
        height_error = (std::max)(height_error, t.height_error);
    }
    void add(const test::bevel_findings& f)
    {
        add({1, f.meshes, f.wrong.empty() ? 0u : 1u, f.narrowed, f.compared, f.volume_error, f.height_error});
    }
    void print(const char* name, const char* width) const
    {
        std::printf("%-44s %7s %8zu %9zu %8zu %9zu %9zu %9.3f %9.3f\n", name, width, glyphs, meshes, invalid, narrowed,
                    compared, volume_error, height_error);
    }
};

struct options {
    bool delaunay = false;
    std::uint32_t compare_each = 1;
    std::uint32_t most = ~0u;
};

/// Examines glyphs on one thread.
class worker {
public:
    worker(const test::glyph_arguments& arguments, const options& how, std::vector<total>& totals, std::mutex& lock)
        : arguments_{arguments}, how_{how}, totals_{totals}, lock_{lock}
    {
        laws_.delaunay = how.delaunay;
    }

    void operator()(const test::glyph_job& job)
    {
        total sums[width_count];
        std::uint32_t looked_at = 0;
        arguments_.each_glyph(job, [&](auto& font, std::uint32_t g) {
            if (!is_one_of_most(job, g)) return;
            const bool compared = looked_at++ % how_.compare_each == 0;
            for (const test::quality_named& q : arguments_.wanted) {
                if (!laws_.take(font, g, q.tolerance)) continue;
                laws_.max_compared = compared ? 100 : 0;
                for (std::size_t w = 0; w < width_count; ++w) {
                    const test::bevel_findings f = laws_.examine(laws_.widths[w]);
                    sums[w].add(f);
                    if (!f.wrong.empty() || f.narrowed != 0) report(job, g, q.name, laws_.widths[w], f);
                }
            }
        });
        const std::lock_guard guard{lock_};
        for (std::size_t w = 0; w < width_count; ++w) totals_[job.group * width_count + w].add(sums[w]);
        std::fprintf(stderr, "\r%.0f s ", arguments_.seconds());
    }

private:
    [[nodiscard]] bool is_one_of_most(const test::glyph_job& job, std::uint32_t g) const
    {
        const std::uint64_t count = job.face.glyph_count, most = (std::min)(how_.most, job.face.glyph_count);
        return job.last - job.first == 1 || g * most / count != (g + 1) * most / count;
    }
    void report(const test::glyph_job& job, std::uint32_t g, const char* quality, double width,
                const test::bevel_findings& f)
    {
        const std::lock_guard guard{lock_};
        std::printf("%s@%u:%u %s %s at %g em: %s\n", job.face.path.c_str(), job.face.face, g, job.face.name().c_str(),
                    quality, width, f.wrong.empty() ? "narrowed" : f.wrong.c_str());
        std::fflush(stdout);
    }

    const test::glyph_arguments& arguments_;
    const options& how_;
    std::vector<total>& totals_;
    std::mutex& lock_;
    test::bevel_laws laws_;
};

void print(const test::glyph_arguments& arguments, const std::vector<total>& totals)
{
    std::printf("%-44s %7s %8s %9s %8s %9s %9s %9s %9s\n", "", "width", "glyphs", "meshes", "invalid", "narrowed",
                "compared", "volume", "height");
    total all;
    for (std::size_t i = 0; i < totals.size(); ++i) {
        const std::string& name = arguments.groups()[i / width_count].name;
        char width[16];
        std::snprintf(width, sizeof width, "%g %%", 100.0 * test::bevel_laws::widths[i % width_count]);
        totals[i].print((name.size() > 44 ? "..." + name.substr(name.size() - 41) : name).c_str(), width);
        all.add(totals[i]);
    }
    all.glyphs /= width_count;
    all.print("all", "");
    std::printf(
        "compared: meshes, with the slow wavefront; volume: the worst error, as a share of perimeter x 2 cells x "
        "depth; "
        "height: the worst error, in cells in the plane\n%.0f s\n",
        arguments.seconds());
}

}  // namespace

int main(int argc, char** argv)
{
    test::glyph_arguments arguments;
    options how;
    bool understood = true;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const auto number = [&] { return static_cast<std::uint32_t>((std::max)(1, std::atoi(argv[++i]))); };
        if (word == "--delaunay")
            how.delaunay = true;
        else if (word == "--compare" && i + 1 < argc)
            how.compare_each = number();
        else if (word == "--most" && i + 1 < argc)
            how.most = number();
        else
            understood = understood && arguments.take(argc, argv, i);
    }
    if (const int status = arguments.start(understood, "every_bevel [--delaunay] [--compare N] [--most N]", 2, 3);
        status != 0)
        return status;
    std::vector<total> totals(arguments.groups().size() * width_count);
    std::mutex lock;
    arguments.work([&] { return worker{arguments, how, totals, lock}; });
    print(arguments, totals);
    return std::any_of(totals.begin(), totals.end(), [](const total& t) { return t.invalid != 0; }) ? 1 : 0;
}
