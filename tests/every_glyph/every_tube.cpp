// SPDX-License-Identifier: MIT
//
//     every_tube [--quality low|normal|high|best]... [--step N] [--threads N] [NAME=]FILE_OR_FOLDER...
//
// Makes tubes along the outline of every glyph of every face of the fonts, thin and thick, with and without the points
// beside sharp corners, and checks the laws of fuzz/tubes.hpp. Prints broken laws and a table; the status is 0 if no law
// is broken.

#include "fuzz/tubes.hpp"
#include "support/glyph_arguments.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <mutex>
#include <string>

namespace {

using namespace typemesh;

struct totals {
    std::size_t glyphs = 0, blank = 0, solids = 0, wrong = 0;
};

/// Examines glyphs on one thread.
class worker {
public:
    worker(const test::glyph_arguments& arguments, totals& sum, std::mutex& lock)
        : arguments_{arguments}, sum_{sum}, lock_{lock}
    {
    }

    void operator()(const test::glyph_job& job)
    {
        totals found;
        arguments_.each_glyph(job, [&](auto& font, std::uint32_t g) {
            ++found.glyphs;
            for (const test::quality_named& q : arguments_.wanted) {
                const std::string wrong = examine(font, g, q.tolerance, found);
                if (wrong.empty()) continue;
                ++found.wrong;
                const std::lock_guard held{lock_};
                std::printf("%s %u, %s: %s\n", job.face.name().c_str(), g, q.name, wrong.c_str());
            }
        });
        const std::lock_guard held{lock_};
        sum_.glyphs += found.glyphs, sum_.blank += found.blank, sum_.solids += found.solids, sum_.wrong += found.wrong;
    }

private:
    /// All tubes of a glyph; what is wrong with the first one that is.
    template <class Font>
    std::string examine(Font& font, std::uint32_t g, double tolerance_em, totals& found)
    {
        fuzz::solid_laws::drawn_region from;
        const auto read = record(font, g, drawn_);
        if (read) from.made = test::region_of(from.caps, drawn_, font.units_per_em(), tolerance_em);
        if (from.made.points().empty()) return ++found.blank, "";
        from.em = test::em_of(from.made);
        for (const float radius : {0.005f, 0.02f, 0.06f, 0.3f})
            for (const float cut : {0.0f, 0.5f, 1.0f}) {
                const tubed how{.radius = radius, .sides = 4, .corner_cut = cut};
                ++found.solids;
                if (const std::string wrong = fuzz::tube_laws::of_tubed(how, from, true); !wrong.empty())
                    return wrong + ", radius " + std::to_string(radius) + ", corner_cut " + std::to_string(cut);
            }
        return {};
    }

    const test::glyph_arguments& arguments_;
    totals& sum_;
    std::mutex& lock_;
    outline drawn_;
};

}  // namespace

int main(int argc, char** argv)
{
    test::glyph_arguments arguments;
    bool understood = true;
    for (int i = 1; i < argc; ++i) understood = understood && arguments.take(argc, argv, i);
    if (const int status = arguments.start(understood, "every_tube", 0, 1); status != 0) return status;
    totals all;
    std::mutex lock;
    arguments.work([&] { return worker{arguments, all, lock}; });
    std::printf("glyphs %zu (%zu blank), solids %zu, wrong %zu\n", all.glyphs, all.blank, all.solids, all.wrong);
    return all.wrong == 0 ? 0 : 1;
}
