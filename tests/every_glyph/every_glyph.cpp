// SPDX-License-Identifier: MIT
//
//     every_glyph [--quality low|normal|high|best]... [--step N] [--threads N] [NAME=]FILE_OR_FOLDER...
//
// Checks every glyph of every face of the fonts (variable ones also at each axis' ends and at mixed corners) by the laws of
// glyph_laws.hpp. Prints broken laws and a table; the status is 0 if no law is broken. FILE@FACE:GLYPH names one glyph;
// fonts with the same NAME make one row.

#include "glyph_laws.hpp"
#include "support/glyph_arguments.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <mutex>
#include <string>
#include <vector>

namespace {

struct total {
    std::string name;
    std::size_t faces = 0, glyphs = 0, blank = 0, resolved = 0, touching = 0, crowded = 0, broken = 0, points = 0,
                refined = 0, unsettled = 0, bent_more = 0;
    double moved = 0;

    void add(const total& t)
    {
        faces += t.faces, glyphs += t.glyphs, blank += t.blank, resolved += t.resolved, touching += t.touching;
        crowded += t.crowded, broken += t.broken, points += t.points, refined += t.refined;
        unsettled += t.unsettled, bent_more += t.bent_more, moved = (std::max)(moved, t.moved);
    }
    void add(const test::glyph_findings& f)
    {
        total t;
        t.blank = f.blank, t.resolved = f.resolved, t.touching = f.touching, t.crowded = f.crowded;
        t.broken = !f.wrong.empty(), t.points = f.points, t.refined = f.refined;
        t.unsettled = f.unsettled, t.bent_more = f.bent_more, t.moved = f.moved;
        add(t);
    }
    void print() const
    {
        const std::string shown = name.size() > 52 ? "..." + name.substr(name.size() - 49) : name;
        std::printf("%-52s %6zu %8zu %9zu %9zu %8zu %9zu %9zu %9zu %11zu %6zu %6.3f %7zu\n", shown.c_str(), faces,
                    glyphs, blank, resolved, refined, unsettled, touching, crowded, points, bent_more, moved, broken);
    }
};

/// The work of all threads.
class trial {
public:
    explicit trial(const test::glyph_arguments& arguments) : arguments_{arguments}
    {
        for (const test::glyph_group& g : arguments.groups()) totals_.push_back({g.name, g.faces});
    }

    void run()
    {
        arguments_.work(
            [&] { return [&, laws = test::glyph_laws{}](const test::glyph_job& job) mutable { look_at(job, laws); }; });
        std::fprintf(stderr, "\n");
    }
    [[nodiscard]] const std::vector<total>& totals() const { return totals_; }

private:
    void look_at(const test::glyph_job& job, test::glyph_laws& laws)
    {
        total sum;
        arguments_.each_glyph(job, [&](auto& font, std::uint32_t g) {
            ++sum.glyphs;
            for (const test::quality_named& q : arguments_.wanted) {
                const test::glyph_findings f = laws.examine(font, g, q.tolerance);
                sum.add(f);
                if (f.wrong.empty()) continue;
                ++broken_;
                const std::lock_guard guard{lock_};
                std::printf("%s@%u:%u %s %s: %s\n", job.face.path.c_str(), job.face.face, g, job.face.name().c_str(),
                            q.name, f.wrong.c_str());
                std::fflush(stdout);
            }
            ++done_;
        });
        const std::lock_guard guard{lock_};
        totals_[job.group].add(sum);
        std::fprintf(stderr, "\r%zu of %zu glyphs, %.0f s, %zu broken laws ", done_.load(), arguments_.glyphs(),
                     arguments_.seconds(), broken_.load());
    }

    const test::glyph_arguments& arguments_;
    std::vector<total> totals_;
    std::atomic<std::size_t> done_{0}, broken_{0};
    std::mutex lock_;
};

}  // namespace

int main(int argc, char** argv)
{
    test::glyph_arguments arguments;
    bool understood = true;
    for (int i = 1; i < argc; ++i) understood = understood && arguments.take(argc, argv, i);
    if (const int status = arguments.start(understood, "every_glyph", 0, 3); status != 0) return status;
    trial all{arguments};
    all.run();

    std::printf("%-52s %6s %8s %9s %9s %8s %9s %9s %9s %11s %6s %6s %7s\n", "", "faces", "glyphs", "blank", "resolved",
                "refined", "unsettled", "touching", "crowded", "points", "bent", "moved", "broken");
    total sum{.name = "all"};
    for (const total& t : all.totals()) {
        t.print();
        sum.add(t);
    }
    sum.print();
    std::printf(
        "over %zu qualities. resolved: contours meet; refined: curves became finer because only chords met; unsettled: "
        "meetings that could not be decided; crowded: vertical edges with more than two faces; bent: rounded crossings "
        "made new ones; moved: the worst area of those, over its bound\n",
        arguments.wanted.size());
    std::printf("%.0f s\n", arguments.seconds());
    return sum.broken == 0 ? 0 : 1;
}
