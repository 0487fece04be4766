// SPDX-License-Identifier: MIT
//
// Discretisers on all curves of a font, streamed: no loop over one curve, which trains the branch predictor.
//
//     certified    the default
//     wang         equal steps of t, as many as Wang's bound asks: what keeps the tolerance with least thought
//     stage        discretise(): certified, snapping and all, glyph by glyph
//
// The argument is the tolerance, 1/160 em and so on (less the snap, as discretise() hands it on). Items are curves;
// `ns_curve` is the time of one and `chords` how many it becomes. In the lines of certified, `over_wang` is its time over
// wang's in the same run, measured in turns;
// `ns_point` of stage is its time over the points left. Medians. A font that is not installed is left out with a word.
#include <typemesh/core/grid.hpp>
#include <typemesh/discretise/certified.hpp>
#include <typemesh/discretise/discretise.hpp>

#include <benchmark/benchmark.h>
#include <hb.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

struct uniform_steps {
    [[nodiscard]] static int bounded(double count) noexcept
    {
        return count < 1.0 ? 1 : count > 65536.0 ? 65536 : static_cast<int>(std::ceil(count));
    }

    template <class Emit>
    void operator()(const quadratic& q, double tolerance, Emit&& emit) const noexcept
    {
        const point b = 2.0 * (q.p1 - q.p0), a = q.p0 - 2.0 * q.p1 + q.p2;
        const int n = bounded(std::sqrt(0.25 * length(a) / tolerance));
        const double step = 1.0 / n;
        for (int i = 1; i < n; ++i) {
            const double t = i * step;
            emit(q.p0 + t * (b + t * a), t);
        }
        emit(q.p2, 1.0);
    }

    template <class Emit>
    void operator()(const cubic& q, double tolerance, Emit&& emit) const noexcept
    {
        const point b = 3.0 * (q.p1 - q.p0), d = q.p0 - 2.0 * q.p1 + q.p2, e = q.p1 - 2.0 * q.p2 + q.p3;
        const int n = bounded(std::sqrt(0.75 * std::sqrt((std::max)(dot(d, d), dot(e, e))) / tolerance));
        const point c = 3.0 * d, a = e - d;
        const double step = 1.0 / n;
        for (int i = 1; i < n; ++i) {
            const double t = i * step;
            emit(q.p0 + t * (b + t * (c + t * a)), t);
        }
        emit(q.p3, 1.0);
    }
};
static_assert(discretiser<uniform_steps>);

struct font_outlines {
    std::vector<outline> glyphs;
    std::vector<curve> bent;  // the quadratics and cubics of all of them
    double units_per_em = 0.0;
    std::string trouble;
};

/// What HarfBuzz draws, as outlines.
struct recorder {
    std::vector<outline> glyphs;
    point start, at;
    bool open = false;

    void add(const curve& c)
    {
        outline& o = glyphs.back();
        if (!o.curves.push_back(c)) std::abort();
        for (std::uint32_t i = 0; i <= c.degree; ++i) o.bounds.add(c.p[i]);
        at = c.end();
    }
    void close()
    {
        if (!open) return;
        if (!(at == start)) add(curve::from(at, start));
        if (!glyphs.back().starts.push_back(static_cast<std::uint32_t>(glyphs.back().curves.size()))) std::abort();
        open = false;
    }
    static recorder& of(void* data) { return *static_cast<recorder*>(data); }
    static point from(float x, float y) { return {double{x}, double{y}}; }
};

font_outlines load(const std::string& name)
{
    const char* given = std::getenv("TYPEMESH_FONT_DIR");
    const std::string path = (given != nullptr ? std::string{given} : std::string{"/usr/share/fonts"}) + "/" + name;
    font_outlines out;
    hb_blob_t* blob = hb_blob_create_from_file(path.c_str());
    hb_face_t* face = hb_face_create(blob, 0);
    hb_font_t* font = hb_font_create(face);
    const unsigned units = hb_face_get_upem(face);
    out.units_per_em = units;
    hb_font_set_scale(font, static_cast<int>(units), static_cast<int>(units));

    hb_draw_funcs_t* calls = hb_draw_funcs_create();
    hb_draw_funcs_set_move_to_func(
        calls,
        [](hb_draw_funcs_t*, void* d, hb_draw_state_t*, float x, float y, void*) {
            recorder& r = recorder::of(d);
            r.close();
            r.start = r.at = recorder::from(x, y);
            r.open = true;
        },
        nullptr, nullptr);
    hb_draw_funcs_set_line_to_func(
        calls,
        [](hb_draw_funcs_t*, void* d, hb_draw_state_t*, float x, float y, void*) {
            recorder& r = recorder::of(d);
            r.add(curve::from(r.at, recorder::from(x, y)));
        },
        nullptr, nullptr);
    hb_draw_funcs_set_quadratic_to_func(
        calls,
        [](hb_draw_funcs_t*, void* d, hb_draw_state_t*, float cx, float cy, float x, float y, void*) {
            recorder& r = recorder::of(d);
            r.add(curve::from(quadratic{r.at, recorder::from(cx, cy), recorder::from(x, y)}));
        },
        nullptr, nullptr);
    hb_draw_funcs_set_cubic_to_func(
        calls,
        [](hb_draw_funcs_t*, void* d, hb_draw_state_t*, float cx, float cy, float ex, float ey, float x, float y,
           void*) {
            recorder& r = recorder::of(d);
            r.add(curve::from(cubic{r.at, recorder::from(cx, cy), recorder::from(ex, ey), recorder::from(x, y)}));
        },
        nullptr, nullptr);
    hb_draw_funcs_set_close_path_func(
        calls, [](hb_draw_funcs_t*, void* d, hb_draw_state_t*, void*) { recorder::of(d).close(); }, nullptr, nullptr);

    recorder r;
    for (unsigned id = 0; id < hb_face_get_glyph_count(face); ++id) {
        r.glyphs.emplace_back();
        if (!r.glyphs.back().starts.push_back(0)) std::abort();
#if HB_VERSION_ATLEAST(7, 0, 0)
        hb_font_draw_glyph(font, id, calls, &r);
#else
        hb_font_get_glyph_shape(font, id, calls, &r);
#endif
        r.close();
        for (const curve& c : r.glyphs.back().curves)
            if (c.degree != 1) out.bent.push_back(c);
    }
    hb_draw_funcs_destroy(calls);
    hb_font_destroy(font);
    hb_face_destroy(face);
    hb_blob_destroy(blob);
    out.glyphs = std::move(r.glyphs);
    if (out.bent.empty()) out.trouble = "no curves in " + path + ": install the font, or set TYPEMESH_FONT_DIR";
    return out;
}

struct emitted {
    point p;
    double t;
};

/// Everything once; the points go to memory, as they would in a mesh.
template <class D>
std::size_t pass(const D& how, const std::vector<curve>& curves, double tolerance, std::vector<emitted>& room)
{
    emitted* next = room.data();
    const emitted* const last = room.data() + room.size() - 70000;
    std::size_t count = 0;
    for (const curve& c : curves) {
        if (next > last) {
            count += static_cast<std::size_t>(next - room.data());
            next = room.data();
        }
        const auto emit = [&next](point p, double t) noexcept { *next++ = {p, t}; };
        if (c.degree == 2)
            how(c.as_quadratic(), tolerance, emit);
        else
            how(c.as_cubic(), tolerance, emit);
    }
    benchmark::ClobberMemory();
    return count + static_cast<std::size_t>(next - room.data());
}

template <class F>
double seconds(const F& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double>& of)
{
    if (of.empty()) return 0.0;
    const auto middle = of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2);
    std::nth_element(of.begin(), middle, of.end());
    return *middle;
}

template <class D>
void curves(benchmark::State& state, const font_outlines& font)
{
    if (!font.trouble.empty()) return state.SkipWithError(font.trouble.c_str());
    std::vector<emitted> room(200000);
    const double tolerance = font.units_per_em / static_cast<double>(state.range(0)) - grid{}.snap_error();
    std::size_t count = 0;
    std::vector<double> mine, wang;
    for (auto _ : state) {
        const double s = seconds([&] { count = pass(D{}, font.bent, tolerance, room); });
        state.SetIterationTime(s);
        mine.push_back(s);
        if constexpr (!std::is_same_v<D, uniform_steps>)
            wang.push_back(seconds([&] { pass(uniform_steps{}, font.bent, tolerance, room); }));
    }
    const double n = static_cast<double>(font.bent.size()), middle = median(mine);
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(font.bent.size()));
    state.counters["ns_curve"] = middle * 1e9 / n;
    state.counters["chords"] = static_cast<double>(count) / n;
    if (!wang.empty()) state.counters["over_wang"] = middle / median(wang);
}

void stage(benchmark::State& state, const font_outlines& font)
{
    if (!font.trouble.empty()) return state.SkipWithError(font.trouble.c_str());
    const double tolerance = font.units_per_em / static_cast<double>(state.range(0));
    contours out;
    std::size_t points = 0, all = 0;
    std::vector<double> mine;
    for (const outline& o : font.glyphs) all += o.curves.size();
    for (auto _ : state) {
        const double s = seconds([&] {
            points = 0;
            for (const outline& o : font.glyphs) {
                const error e = discretise(o, certified{}, tolerance, grid{}, out);
                if (e) std::abort();
                points += out.points.size();
                benchmark::DoNotOptimize(out.points.data());
            }
        });
        state.SetIterationTime(s);
        mine.push_back(s);
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(all));
    state.counters["points_glyph"] = static_cast<double>(points) / static_cast<double>(font.glyphs.size());
    state.counters["ns_point"] = median(mine) * 1e9 / static_cast<double>(points);
}

}  // namespace

int main(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    const struct {
        const char* name;
        const char* file;
    } fonts[] = {{"quadratic", "truetype/liberation/LiberationSans-Regular.ttf"},
                 {"cubic", "opentype/comic-neue/ComicNeue-Regular.otf"}};
    std::vector<std::unique_ptr<font_outlines>> loaded;
    for (const auto& f : fonts) {
        loaded.push_back(std::make_unique<font_outlines>(load(f.file)));
        const font_outlines& font = *loaded.back();
        if (!font.trouble.empty()) std::fprintf(stderr, "%s\n", font.trouble.c_str());
        const auto add = [&](const char* what, void (*run)(benchmark::State&, const font_outlines&)) {
            const std::string name = std::string{what} + "/" + f.name;
            benchmark::RegisterBenchmark(name.c_str(), [run, &font](benchmark::State& state) { run(state, font); })
                ->Arg(160)
                ->Arg(800)
                ->Arg(16000)
                ->UseManualTime()
                ->Unit(benchmark::kMicrosecond);
        };
        add("certified", curves<certified>);
        add("wang", curves<uniform_steps>);
        add("stage", stage);
    }
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
