// SPDX-License-Identifier: MIT
#pragma once

// The common part of the programs every_*: their fonts, and which worker examines which glyphs.

#include "support/face_instances.hpp"

#include <typemesh/discretise/quality.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace test {

struct quality_named {
    const char* name;
    double tolerance;
};
inline constexpr quality_named qualities[] = {{"low", typemesh::quality::low},
                                              {"normal", typemesh::quality::normal},
                                              {"high", typemesh::quality::high},
                                              {"best", typemesh::quality::best}};

/// Some glyphs of one face.
struct glyph_job {
    face_instance face;
    std::uint32_t first = 0, last = 0;
    std::size_t group = 0;
};

/// A row of the table that a program prints.
struct glyph_group {
    std::string name;
    std::size_t faces = 0;
};

/// The words of a command line, except for those of one program only:
///
///     [--quality low|normal|high|best]... [--step N] [--threads N] [NAME=]FILE_OR_FOLDER...
///
/// FILE@FACE:GLYPH names one glyph. Fonts with the same NAME make one row of the table.
class glyph_arguments {
public:
    static constexpr const char* words =
        "[--quality low|normal|high|best]... [--step N] [--threads N] [NAME=]FILE_OR_FOLDER...";

    std::vector<quality_named> wanted;
    std::uint32_t step = 1;
    unsigned threads = (std::max)(1u, std::thread::hardware_concurrency());

    /// Takes word i and moves to the last one that belongs to it; false if it is none of these.
    [[nodiscard]] bool take(int argc, char** argv, int& i)
    {
        const std::string word = argv[i];
        const bool has_next = i + 1 < argc;
        if (word == "--quality" && has_next) {
            const std::string name = argv[++i];
            const auto* q = std::find_if(std::begin(qualities), std::end(qualities),
                                         [&](const quality_named& one) { return name == one.name; });
            if (q == std::end(qualities)) return false;
            wanted.push_back(*q);
        } else if (word == "--step" && has_next) {
            step = static_cast<std::uint32_t>((std::max)(1, std::atoi(argv[++i])));
        } else if (word == "--threads" && has_next) {
            threads = static_cast<unsigned>((std::max)(1, std::atoi(argv[++i])));
        } else if (word.rfind("--", 0) == 0) {
            return false;
        } else {
            paths_.push_back(word);
        }
        return true;
    }

    /// Ends the reading of the words: 0, or the exit status after a message. `usage` has the program and its own words;
    /// `first` to `last` are the qualities if none is named.
    [[nodiscard]] int start(bool understood, const char* usage, std::size_t first, std::size_t last)
    {
        if (!understood || paths_.empty()) return std::fprintf(stderr, "%s %s\n", usage, words), 2;
        if (wanted.empty()) wanted.assign(qualities + first, qualities + last);
        return open();
    }

    /// Finds the fonts. If there are none, says why and returns the exit status.
    [[nodiscard]] int open()
    {
        for (const std::string& path : paths_)
            if (const int status = open(path); status != 0) return status;
        return jobs_.empty() ? 1 : 0;
    }
    [[nodiscard]] const std::vector<glyph_group>& groups() const { return groups_; }
    [[nodiscard]] const std::vector<glyph_job>& jobs() const { return jobs_; }
    [[nodiscard]] std::size_t glyphs() const { return glyphs_; }

    /// Calls of(font, glyph) for the glyphs of a job.
    template <class F>
    void each_glyph(const glyph_job& job, const F& of) const
    {
        auto font = job.face.open();
        if (!font) return;
        for (std::uint32_t g = job.first; g < job.last; ++g)
            if (g % step == 0 || job.last - job.first == 1) of(*font, g);
    }

    /// Calls worker() on each thread, and calls the result for one job after another.
    template <class Worker>
    void work(const Worker& worker) const
    {
        std::atomic<std::size_t> next{0};
        const auto loop = [&] {
            auto look_at = worker();
            for (std::size_t j; (j = next++) < jobs_.size();) look_at(jobs_[j]);
        };
        std::vector<std::thread> others;
        for (unsigned i = 1; i < threads; ++i) others.emplace_back(loop);
        loop();
        for (std::thread& t : others) t.join();
    }

    [[nodiscard]] double seconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    [[nodiscard]] static bool is_font(const std::filesystem::path& p)
    {
        const std::string e = p.extension().string();
        return e == ".ttf" || e == ".otf" || e == ".ttc" || e == ".otc" || e == ".TTF" || e == ".OTF";
    }

    int open(const std::string& path)
    {
        const auto equals = path.find('=');
        std::string name = path.substr(0, equals), file = equals == std::string::npos ? path : path.substr(equals + 1);
        std::uint32_t only_face = ~0u, only_glyph = ~0u;
        if (const auto at = file.rfind('@'); at != std::string::npos) {
            if (std::sscanf(file.c_str() + at, "@%u:%u", &only_face, &only_glyph) != 2) {
                std::fprintf(stderr, "%s is not FILE@FACE:GLYPH\n", file.c_str());
                return 2;
            }
            file.resize(at);
        }
        std::vector<std::string> files;
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
        const auto same = std::find_if(groups_.begin(), groups_.end(), [&](const auto& g) { return g.name == name; });
        const auto group = static_cast<std::size_t>(same - groups_.begin());
        if (same == groups_.end()) groups_.push_back({name});
        for (const std::string& f : files) {
            for (const face_instance& face : instances_of(f)) {
                if (only_glyph == ~0u)
                    add_face(face, group);
                else if (face.face == only_face && face.variations.empty())
                    add({face, only_glyph, only_glyph + 1, group}, 1);
                else
                    continue;
                ++groups_[group].faces;
            }
        }
        return 0;
    }

    void add_face(const face_instance& face, std::size_t group)
    {
        constexpr std::uint32_t most = 2000;
        for (std::uint32_t g = 0; g < face.glyph_count; g += most) {
            const std::uint32_t end = (std::min)(g + most, face.glyph_count);
            add({face, g, end, group}, (end + step - 1) / step - (g + step - 1) / step);
        }
    }
    void add(const glyph_job& job, std::size_t glyphs)
    {
        jobs_.push_back(job);
        glyphs_ += glyphs;
    }

    std::vector<std::string> paths_;
    std::vector<glyph_group> groups_;
    std::vector<glyph_job> jobs_;
    std::size_t glyphs_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace test
