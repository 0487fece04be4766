// SPDX-License-Identifier: MIT
#pragma once

// The cells of the thesis' protocol: one text, one font, one quality, one algorithm, one solid. See protocol.cpp.

#include "full_vertex.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <concepts>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace bench {

using namespace typemesh;

/// The texts of one kind in one script: the characters, the phrases, the long text.
struct text_group {
    const char* script;
    const char* category;
    std::vector<std::string> texts;
};

/// A font of the thesis by the free one that stands in for it, and the texts that it draws.
struct protocol_font {
    const char* name;
    const char* stands_for;
    harfbuzz_font font;
    std::vector<const text_group*> groups;
};

struct quality_preset {
    const char* name;
    thesis_quality::preset of_thesis;
    double tolerance;
};
inline constexpr quality_preset qualities[] = {{"low", thesis_quality::low, quality::low},
                                               {"normal", thesis_quality::normal, quality::normal},
                                               {"high", thesis_quality::high, quality::high},
                                               {"best", thesis_quality::best, quality::best}};

/// What a mesher is made of, in words.
struct cell_name {
    const char* solid;
    const char* triangulator;
    const char* discretiser;
    const quality_preset* quality;
};

inline double seconds_of_processor()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct stage_clock {
    using clock = std::chrono::steady_clock;
    double microseconds[7] = {};
    stage now = stage::idle;
    clock::time_point since;

    void operator()(stage next) noexcept
    {
        const auto t = clock::now();
        microseconds[static_cast<int>(now)] += std::chrono::duration<double, std::micro>(t - since).count();
        now = next;
        since = t;
    }
};

/// All texts of a group by one mesher. The texts follow each other in every run: no text is repeated at once, which would train
/// the branch predictor.
class cell_row {
public:
    cell_row(const protocol_font& font, const text_group& group, cell_name name)
        : font_{font}, group_{group}, name_{name}, of_text_(group.texts.size())
    {
    }
    cell_row(const cell_row&) = delete;
    cell_row& operator=(const cell_row&) = delete;
    virtual ~cell_row() = default;

    /// After one run that is not counted.
    void time(int runs)
    {
        for (const std::string& text : group_.texts) build(text);
        const double start = seconds_of_processor();
        for (int run = 0; run < runs; ++run)
            for (std::size_t i = 0; i < group_.texts.size(); ++i) {
                const auto from = std::chrono::steady_clock::now();
                build(group_.texts[i]);
                const std::chrono::duration<double, std::micro> each = std::chrono::steady_clock::now() - from;
                of_text_[i].push_back(each.count());
            }
        seconds_ += seconds_of_processor() - start;
    }

    /// A row for each text, and one for the group by the processor's clock.
    void print()
    {
        const auto n = static_cast<double>(group_.texts.size());
        const auto runs = static_cast<double>(of_text_[0].size());
        for (std::size_t i = 0; i < group_.texts.size(); ++i) {
            build(group_.texts[i]);
            std::vector<double>& times = of_text_[i];
            double sum = 0;
            for (const double t : times) sum += t;
            const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
            std::nth_element(times.begin(), middle, times.end());
            start_row("thesis");
            std::printf("\t%zu\t%zu\t%.4f\t%.4f\t%zu\t%zu\n", i + 1, times.size(), sum / runs, *middle,
                        vertices_.size(), indices_.size() / 3);
        }
        start_row("thesis_group");
        std::printf("\t%.0f\t%.0f\t%.4f\n", n, runs, 1e6 * seconds_ / runs / n);
        print_more();
    }

protected:
    virtual void build(const std::string& text) = 0;
    virtual void print_more() {}
    void start_row(const char* kind) const
    {
        std::printf("%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s", kind, name_.solid, name_.triangulator, name_.discretiser,
                    name_.quality->name, font_.name, font_.stands_for, group_.script, group_.category);
    }

    const protocol_font& font_;
    const text_group& group_;
    cell_name name_;
    std::vector<full_vertex> vertices_;
    std::vector<std::uint32_t> indices_;

private:
    std::vector<std::vector<double>> of_text_;
    double seconds_ = 0;
};

/// Stages are timed of flat texts only: they are what the thesis tells the shares of.
template <bool Staged, class Make>
class cell_row_of final : public cell_row {
public:
    cell_row_of(const protocol_font& font, const text_group& group, cell_name name, Make make)
        : cell_row{font, group, name}, make_{make}, mesher_{make()}
    {
    }

private:
    void build(const std::string& text) override
    {
        if (!mesher_.build(text, into(vertices_, indices_), options())) std::abort();
    }

    void print_more() override
    {
        if constexpr (Staged) print_stages();
    }

    /// Each stage's median over some runs, text by text; their means over the texts.
    void print_stages()
    {
        constexpr int runs = 7, stages = 6;
        stage_clock clock;
        auto staged = make_().with(observer_ref{clock});
        std::vector<std::array<std::vector<double>, stages>> of_text(group_.texts.size());
        for (int run = -1; run < runs; ++run)
            for (std::size_t i = 0; i < of_text.size(); ++i) {
                clock = {};
                if (!staged.build(group_.texts[i], into(vertices_, indices_), options())) std::abort();
                for (std::size_t s = 0; run >= 0 && s < stages; ++s) of_text[i][s].push_back(clock.microseconds[s]);
            }
        start_row("thesis_stages");
        for (std::size_t s = 0; s < stages; ++s) {
            double sum = 0;
            for (auto& times : of_text) {
                std::nth_element(times[s].begin(), times[s].begin() + runs / 2, times[s].end());
                sum += times[s][runs / 2];
            }
            std::printf("\t%.4f", sum / static_cast<double>(of_text.size()));
        }
        std::putchar('\n');
    }

    [[nodiscard]] text_options options() const
    {
        return {.tolerance = name_.quality->tolerance, .unit = output_unit::unit_box, .reuse = false};
    }

    Make make_;
    std::invoke_result_t<Make> mesher_;
};

using cell_rows = std::vector<std::unique_ptr<cell_row>>;

/// The rows of one solid: both triangulators, both ways to flatten curves, the four qualities.
template <class Solid>
void add_rows(cell_rows& rows, protocol_font& f, const char* solid_name, const Solid& solid)
{
    for (const text_group* group : f.groups)
        for (const quality_preset& q : qualities) {
            const auto add = [&](const char* triangulator, const char* discretiser, auto make) {
                rows.push_back(std::make_unique<cell_row_of<std::same_as<Solid, flat>, decltype(make)>>(
                    f, *group, cell_name{solid_name, triangulator, discretiser, &q}, make));
            };
            const auto add_both = [&](const char* discretiser, auto flatten) {
                const auto base = [&font = f.font, flatten, solid] {
                    return text_mesher{font}.with(flatten).with(solid);
                };
                add("monotone", discretiser, [base] { return base().with(monotone{}); });
                add("constrained Delaunay", discretiser, [base] { return base().with(constrained_delaunay{}); });
            };
            add_both("thesis", thesis_quality{q.of_thesis, f.font.units_per_em()});
            add_both("certified", certified{});
        }
}

void add_flat_rows(cell_rows& rows, protocol_font& f);
void add_extruded_rows(cell_rows& rows, protocol_font& f);
void add_bevelled_rows(cell_rows& rows, protocol_font& f);

}  // namespace bench
