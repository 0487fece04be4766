// SPDX-License-Identifier: MIT
//
// Discretisers on all curves of a font, streamed: no loop over one curve, which trains the branch predictor.
//
//     certified    the default
//     wang         equal steps of t, as many as Wang's bound asks: what keeps the tolerance with least thought
//     stage        discretise(): certified, snapping and all, glyph by glyph
//
// The argument is the tolerance, 1/160 em and so on (less the snap, as discretise() hands it on). Three rows each:
// `quadratic` and `cubic` are the curves of that degree of all installed fonts of tests/workload/smoke-fonts.tsv, 64
// glyphs of every face at most, taken at equal steps; `comic_neue` is the whole of ComicNeue-Regular. All are scaled to
// 2048 units per em. The report's context lists how many faces of which package there were.
//
//     ns_a_curve   time of one curve                       segments   how many chords it becomes
//     over_wang    certified's time over wang's, measured in turns in the same run
//     ns_point     time of stage over the points left      points_glyph   how many these are
//
// Curves are timed in slices of 2,000, the least time of each counts: a busy machine spoils long passes more than short
// ones. Of stage, the median. A row without a font is left out with a word.
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
#include <filesystem>
#include <numeric>
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

    template <class Put>
    void operator()(const quadratic& q, double tolerance, Put&& put) const noexcept
    {
        const point b = 2.0 * (q.p1 - q.p0), a = q.p0 - 2.0 * q.p1 + q.p2;
        const int n = bounded(std::sqrt(0.25 * length(a) / tolerance));
        const double step = 1.0 / n;
        for (int i = 1; i < n; ++i) {
            const double t = i * step;
            put(q.p0 + t * (b + t * a), t);
        }
        put(q.p2, 1.0);
    }

    template <class Put>
    void operator()(const cubic& q, double tolerance, Put&& put) const noexcept
    {
        const point b = 3.0 * (q.p1 - q.p0), d = q.p0 - 2.0 * q.p1 + q.p2, e = q.p1 - 2.0 * q.p2 + q.p3;
        const int n = bounded(std::sqrt(0.75 * std::sqrt((std::max)(dot(d, d), dot(e, e))) / tolerance));
        const point c = 3.0 * d, a = e - d;
        const double step = 1.0 / n;
        for (int i = 1; i < n; ++i) {
            const double t = i * step;
            put(q.p0 + t * (b + t * (c + t * a)), t);
        }
        put(q.p3, 1.0);
    }
};
static_assert(discretiser<uniform_steps>);

constexpr unsigned units_per_em = 2048;

struct font_outlines {
    std::vector<outline> glyphs;
    std::vector<curve> bent;  // the quadratics and cubics of all of them
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

std::filesystem::path font_folder()
{
    const char* given = std::getenv("TYPEMESH_FONT_DIR");
    return given != nullptr ? given : "/usr/share/fonts";
}

/// Draws at most `most` glyphs of every face in a file, at equal steps; returns how many faces have outlines.
unsigned draw(const std::filesystem::path& path, unsigned most, recorder& out)
{
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

    hb_blob_t* blob = hb_blob_create_from_file(path.c_str());
    unsigned drawn = 0;
    for (unsigned index = 0; index < hb_face_count(blob); ++index) {
        hb_face_t* face = hb_face_create(blob, index);
        hb_font_t* font = hb_font_create(face);
        hb_font_set_scale(font, static_cast<int>(units_per_em), static_cast<int>(units_per_em));
        const unsigned count = hb_face_get_glyph_count(face), step = (std::max)(1u, (count + most - 1) / most);
        bool any = false;
        for (unsigned id = 0; id < count; id += step) {
            out.glyphs.emplace_back();
            if (!out.glyphs.back().starts.push_back(0)) std::abort();
#if HB_VERSION_ATLEAST(7, 0, 0)
            hb_font_draw_glyph(font, id, calls, &out);
#else
            hb_font_get_glyph_shape(font, id, calls, &out);
#endif
            out.close();
            any = any || !out.glyphs.back().curves.empty();
        }
        drawn += any ? 1 : 0;
        hb_font_destroy(font);
        hb_face_destroy(face);
    }
    hb_blob_destroy(blob);
    hb_draw_funcs_destroy(calls);
    return drawn;
}

/// The glyphs that have a curve of this degree and no bent curve of the other, and those curves.
font_outlines sort_out(const std::vector<outline>& glyphs, std::uint32_t degree)
{
    font_outlines out;
    for (const outline& o : glyphs) {
        bool wanted = false, other = false;
        for (const curve& c : o.curves) {
            wanted = wanted || c.degree == degree;
            other = other || c.degree == 5 - degree;
            if (c.degree == degree) out.bent.push_back(c);
        }
        if (!wanted || other) continue;
        out.glyphs.emplace_back();
        outline& copy = out.glyphs.back();
        for (const curve& c : o.curves)
            if (!copy.curves.push_back(c)) std::abort();
        for (const std::uint32_t start : o.starts)
            if (!copy.starts.push_back(start)) std::abort();
        copy.bounds = o.bounds;
    }
    if (out.bent.empty())
        out.trouble = "no such curves in " + font_folder().string() + ": install fonts, or set TYPEMESH_FONT_DIR";
    return out;
}

struct package {
    const char* name;
    const char* folder;  // below the folder of fonts
};

/// tests/workload/smoke-fonts.tsv
constexpr package packages[] = {
    {"fonts-dejavu-core", "truetype/dejavu"},
    {"fonts-liberation", "truetype/liberation"},
    {"fonts-wine", "../wine/fonts"},
    {"fonts-comic-neue", "opentype/comic-neue"},
    {"fonts-hosny-amiri", "opentype/fonts-hosny-amiri"},
    {"fonts-sil-awami-nastaliq", "truetype/awami"},
    {"fonts-lohit-deva", "truetype/lohit-devanagari"},
    {"fonts-tlwg-purisa-otf", "opentype/tlwg"},
    {"culmus", "truetype/culmus"},
    {"fonts-wqy-microhei", "truetype/wqy"},
    {"fonts-sawarabi-mincho", "truetype/sawarabi-mincho"},
    {"fonts-inter-variable", "truetype/inter-vf"},
    {"fonts-symbola", "truetype/ancient-scripts"},
    {"fonts-cegui", "truetype"},
    {"fonts-mplus", "opentype/mplus"},
};

/// All faces of a package, the files in order of their names.
unsigned draw(const package& of, recorder& r)
{
    const auto folder = font_folder() / of.folder;
    std::vector<std::filesystem::path> files;
    if (std::filesystem::is_directory(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            const auto kind = entry.path().extension();
            if (kind == ".ttf" || kind == ".otf" || kind == ".ttc") files.push_back(entry.path());
        }
    std::sort(files.begin(), files.end());
    unsigned faces = 0;
    for (const auto& file : files) faces += draw(file, 64, r);
    return faces;
}

struct emitted {
    point p;
    double t;
};

/// The curves [first, end) once; the points go to memory, as they would in a mesh.
template <class D>
std::size_t pass(const D& how, const std::vector<curve>& curves, std::size_t first, std::size_t end, double tolerance,
                 std::vector<emitted>& room)
{
    emitted* next = room.data();
    const emitted* const last = room.data() + room.size() - 70000;
    std::size_t count = 0;
    for (; first < end; ++first) {
        const curve& c = curves[first];
        if (next > last) {
            count += static_cast<std::size_t>(next - room.data());
            next = room.data();
        }
        const auto put = [&next](point p, double t) noexcept { *next++ = {p, t}; };
        if (c.degree == 2)
            how(c.as_quadratic(), tolerance, put);
        else
            how(c.as_cubic(), tolerance, put);
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
    const double tolerance = double{units_per_em} / static_cast<double>(state.range(0)) - grid{}.snap_error();
    std::size_t count = 0;
    constexpr std::size_t slice = 2000;
    const std::size_t slices = (font.bent.size() + slice - 1) / slice;
    std::vector<double> mine(slices, 1e9), wang(slices, 1e9);
    for (auto _ : state) {
        double whole = 0.0;
        count = 0;
        for (std::size_t i = 0; i < slices; ++i) {
            const std::size_t first = i * slice, end = (std::min)(first + slice, font.bent.size());
            const double s = seconds([&] { count += pass(D{}, font.bent, first, end, tolerance, room); });
            whole += s;
            mine[i] = (std::min)(mine[i], s);
            if constexpr (!std::is_same_v<D, uniform_steps>) {
                const double w = seconds([&] { pass(uniform_steps{}, font.bent, first, end, tolerance, room); });
                wang[i] = (std::min)(wang[i], w);
            }
        }
        state.SetIterationTime(whole);
    }
    const double n = static_cast<double>(font.bent.size()), least = std::accumulate(mine.begin(), mine.end(), 0.0);
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(font.bent.size()));
    state.counters["ns_a_curve"] = least * 1e9 / n;
    state.counters["segments"] = static_cast<double>(count) / n;
    if constexpr (!std::is_same_v<D, uniform_steps>)
        state.counters["over_wang"] = least / std::accumulate(wang.begin(), wang.end(), 0.0);
}

void stage(benchmark::State& state, const font_outlines& font)
{
    if (!font.trouble.empty()) return state.SkipWithError(font.trouble.c_str());
    const double tolerance = double{units_per_em} / static_cast<double>(state.range(0));
    contours out;
    std::size_t points = 0, all = 0;
    std::vector<double> mine;
    for (const outline& o : font.glyphs) all += o.curves.size();
    for (auto _ : state) {
        const double s = seconds([&] {
            points = 0;
            for (const outline& o : font.glyphs) {
                if (!discretise(o, certified{}, tolerance, grid{}, out)) std::abort();
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
    recorder all, one;
    std::string faces;
    for (const package& p : packages)
        faces += (faces.empty() ? "" : ", ") + std::string{p.name} + ' ' + std::to_string(draw(p, all));
    benchmark::AddCustomContext("faces", faces);
    draw(font_folder() / "opentype/comic-neue/ComicNeue-Regular.otf", 0xFFFFu, one);
    const struct {
        const char* name;
        font_outlines outlines;
    } rows[] = {{"quadratic", sort_out(all.glyphs, 2)},
                {"cubic", sort_out(all.glyphs, 3)},
                {"comic_neue", sort_out(one.glyphs, 3)}};
    for (const auto& row : rows) {
        const font_outlines& font = row.outlines;
        if (!font.trouble.empty()) std::fprintf(stderr, "%s: %s\n", row.name, font.trouble.c_str());
        const auto add = [&](const char* what, void (*run)(benchmark::State&, const font_outlines&)) {
            const std::string name = std::string{what} + "/" + row.name;
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
