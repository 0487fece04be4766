// SPDX-License-Identifier: MIT
//
//     every_glyph [--quality low|normal|high|best]... [--step N] [--threads N] FILE_OR_FOLDER...
//
// Tries every glyph of every face of the fonts (variable ones at each axis' ends and at mixed corners as well) against
// the laws of glyph_laws.hpp. Prints what is broken, and a table; status 0 when nothing is. FILE@FACE:GLYPH names one
// glyph.

#include "glyph_laws.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <thread>

namespace {

struct job {
    test::face_instance face;
    std::uint32_t first, last;
    std::size_t group;
};

struct total {
    std::string name;
    std::size_t faces = 0, glyphs = 0, blank = 0, resolved = 0, touching = 0, crowded = 0, broken = 0, points = 0,
                refined = 0, unsettled = 0, bent_more = 0;
    double moved = 0;
};

struct quality_named {
    const char* name;
    double tolerance;
};
constexpr quality_named qualities[] = {{"low", typemesh::quality::low},
                                       {"normal", typemesh::quality::normal},
                                       {"high", typemesh::quality::high},
                                       {"best", typemesh::quality::best}};

bool is_font(const std::filesystem::path& p)
{
    const std::string e = p.extension().string();
    return e == ".ttf" || e == ".otf" || e == ".ttc" || e == ".otc" || e == ".TTF" || e == ".OTF";
}

int usage()
{
    std::fprintf(stderr,
                 "every_glyph [--quality low|normal|high|best]... [--step N] [--threads N] FILE_OR_FOLDER...\n");
    return 2;
}

}  // namespace

int main(int argc, char** argv)
{
    std::vector<quality_named> wanted;
    std::uint32_t step = 1;
    unsigned threads = (std::max)(1u, std::thread::hardware_concurrency());
    std::vector<std::string> paths;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--quality" && i + 1 < argc) {
            ++i;
            const auto before = wanted.size();
            for (const auto& q : qualities)
                if (word.size() && std::strcmp(q.name, argv[i]) == 0) wanted.push_back(q);
            if (wanted.size() == before) return usage();
        } else if (word == "--step" && i + 1 < argc) {
            step = static_cast<std::uint32_t>((std::max)(1, std::atoi(argv[++i])));
        } else if (word == "--threads" && i + 1 < argc) {
            threads = static_cast<unsigned>((std::max)(1, std::atoi(argv[++i])));
        } else if (word.rfind("--", 0) == 0) {
            return usage();
        } else {
            paths.push_back(word);
        }
    }
    if (paths.empty()) return usage();
    if (wanted.empty()) wanted.assign(qualities, qualities + 3);

    std::vector<total> totals;
    std::vector<job> jobs;
    std::size_t all = 0;
    for (const std::string& path : paths) {
        std::vector<std::string> files;
        std::string file = path;
        std::uint32_t only_face = ~0u, only_glyph = ~0u;
        if (const auto at = path.rfind('@'); at != std::string::npos) {
            file = path.substr(0, at);
            if (std::sscanf(path.c_str() + at, "@%u:%u", &only_face, &only_glyph) != 2) return usage();
        }
        std::error_code none;
        if (std::filesystem::is_directory(file, none)) {
            for (const auto& entry : std::filesystem::recursive_directory_iterator{file})
                if (entry.is_regular_file() && is_font(entry.path())) files.push_back(entry.path().string());
            std::sort(files.begin(), files.end());
        } else if (std::filesystem::exists(file, none)) {
            files.push_back(file);
        } else {
            std::fprintf(stderr, "there is no %s\n", file.c_str());
            return 1;
        }
        totals.push_back({.name = path});
        for (const std::string& f : files) {
            for (const auto& face : test::instances_of(f)) {
                if (only_glyph != ~0u) {
                    if (face.face != only_face || !face.variations.empty()) continue;
                    jobs.push_back({face, only_glyph, only_glyph + 1, totals.size() - 1});
                    all += 1;
                } else {
                    for (std::uint32_t g = 0; g < face.glyph_count; g += 2000)
                        jobs.push_back({face, g, (std::min)(g + 2000, face.glyph_count), totals.size() - 1});
                    all += (face.glyph_count + step - 1) / step;
                }
                ++totals.back().faces;
            }
        }
    }

    std::atomic<std::size_t> next{0}, done{0}, broken{0};
    std::mutex lock;
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const auto work = [&] {
        test::glyph_laws laws;
        for (std::size_t j; (j = next++) < jobs.size();) {
            const job& it = jobs[j];
            auto font = it.face.open();
            total sum;
            if (!font) continue;
            for (std::uint32_t g = it.first; g < it.last; ++g) {
                if (g % step != 0 && it.last - it.first != 1) continue;
                ++sum.glyphs;
                for (const auto& q : wanted) {
                    const test::glyph_findings f = laws.examine(*font, g, q.tolerance);
                    sum.blank += f.blank;
                    sum.resolved += f.resolved;
                    sum.touching += f.touching;
                    sum.crowded += f.crowded;
                    sum.points += f.points;
                    sum.refined += f.refined;
                    sum.unsettled += f.unsettled;
                    sum.bent_more += f.bent_more;
                    sum.moved = (std::max)(sum.moved, f.moved);
                    if (f.wrong.empty()) continue;
                    ++sum.broken;
                    ++broken;
                    const std::lock_guard guard{lock};
                    std::printf("%s@%u:%u %s %s: %s\n", it.face.path.c_str(), it.face.face, g, it.face.name().c_str(),
                                q.name, f.wrong.c_str());
                    std::fflush(stdout);
                }
                ++done;
            }
            const std::lock_guard guard{lock};
            total& t = totals[it.group];
            t.glyphs += sum.glyphs;
            t.blank += sum.blank;
            t.resolved += sum.resolved;
            t.touching += sum.touching;
            t.crowded += sum.crowded;
            t.broken += sum.broken;
            t.points += sum.points;
            t.refined += sum.refined;
            t.unsettled += sum.unsettled;
            t.bent_more += sum.bent_more;
            t.moved = (std::max)(t.moved, sum.moved);
            std::fprintf(stderr, "\r%zu of %zu glyphs, %.0f s, %zu broken laws ", done.load(), all, seconds(),
                         broken.load());
        }
    };
    std::vector<std::thread> workers;
    for (unsigned i = 1; i < threads; ++i) workers.emplace_back(work);
    work();
    for (std::thread& w : workers) w.join();

    std::fprintf(stderr, "\n");
    std::printf("%-52s %6s %8s %9s %9s %8s %9s %9s %9s %11s %6s %6s %7s\n", "", "faces", "glyphs", "blank", "resolved",
                "refined", "unsettled", "touching", "crowded", "points", "bent", "moved", "broken");
    total sum{.name = "all"};
    const auto print = [](const total& t) {
        const std::string name = t.name.size() > 52 ? "..." + t.name.substr(t.name.size() - 49) : t.name;
        std::printf("%-52s %6zu %8zu %9zu %9zu %8zu %9zu %9zu %9zu %11zu %6zu %6.3f %7zu\n", name.c_str(), t.faces,
                    t.glyphs, t.blank, t.resolved, t.refined, t.unsettled, t.touching, t.crowded, t.points, t.bent_more,
                    t.moved, t.broken);
    };
    for (const total& t : totals) {
        print(t);
        sum.faces += t.faces, sum.glyphs += t.glyphs, sum.blank += t.blank, sum.resolved += t.resolved,
            sum.touching += t.touching;
        sum.refined += t.refined, sum.unsettled += t.unsettled, sum.bent_more += t.bent_more;
        sum.crowded += t.crowded, sum.points += t.points, sum.broken += t.broken,
            sum.moved = (std::max)(sum.moved, t.moved);
    }
    print(sum);
    std::printf(
        "over %zu qualities. resolved: contours meet; refined: curves made finer where only chords met; unsettled: "
        "meetings that stand though they could not be told; crowded: vertical edges with more than two faces; bent: "
        "rounded crossings made new ones; moved: the worst area of those, over its bound\n",
        wanted.size());
    std::printf("%.0f s\n", seconds());
    return sum.broken == 0 ? 0 : 1;
}
