// SPDX-License-Identifier: MIT
//
// Policies of your own: a discretiser that gives every curve the same number of pieces, and a fan-shaped outline source
// that needs no font at all. Both are plain structs; the concepts list what they must provide.
//
//     04_own_policy

#include <typemesh/typemesh.hpp>

#include <cmath>
#include <cstdio>
#include <vector>

/// Every curve becomes `pieces` lines, whatever its size: cheap to reason about, and wrong for large curves.
struct equal_steps {
    static constexpr bool keeps_no_tolerance = true;  // a finer one would change nothing
    int pieces = 4;

    /// What distinguishes its glyphs in a glyph_cache.
    typemesh::option_bits cache_key() const noexcept { return {pieces}; }

    template <class Curve, class Put>
    void operator()(const Curve& curve, double /*tolerance*/, Put&& put) const noexcept
    {
        for (int i = 1; i < pieces; ++i) put(curve.at(double(i) / pieces), double(i) / pieces);
        put(curve.at(1.0), 1.0);
    }
};
static_assert(typemesh::discretiser<equal_steps>);

/// Glyph g is a pie slice of 1/(g + 1).
struct pies {
    double units_per_em() const noexcept { return 1000.0; }
    typemesh::fill_rule fill() const noexcept { return typemesh::fill_rule::non_zero; }

    template <typemesh::outline_sink Sink>
    typemesh::error outline(typemesh::glyph_id g, Sink& sink) const noexcept
    {
        const double angle = 6.283185307179586 / (g + 1.0), k = 4.0 / 3.0 * std::tan(angle / 16.0), r = 400.0;
        sink.move({0, 0});
        sink.line({r, 0});
        for (int i = 0; i < 4; ++i) {  // four cubics make the arc
            const double a = angle * i / 4, b = angle * (i + 1) / 4;
            const typemesh::point p{r * std::cos(a), r * std::sin(a)}, q{r * std::cos(b), r * std::sin(b)};
            sink.cubic({p.x - k * p.y, p.y + k * p.x}, {q.x + k * q.y, q.y - k * q.x}, q);
        }
        sink.close();
        return {};
    }
};
static_assert(typemesh::outline_source<pies>);

struct vertex {
    float x, y, z;
};
template <>
struct typemesh::vertex_traits<vertex> {
    static constexpr auto wants = attribute::position;
    vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {s.position.x, s.position.y, s.position.z};
    }
};

int main()
{
    pies source;
    typemesh::glyph_run run;  // made by hand: no shaper
    for (unsigned g = 1; g <= 5; ++g)
        if (!run.glyphs.push_back({.id = g, .cluster = g, .origin = {900.0 * g, 0}})) return 1;

    auto mesher = typemesh::text_mesher{source}.with(equal_steps{6});
    std::vector<vertex> vertices;
    std::vector<std::uint32_t> indices;
    const auto made = mesher.build(run, typemesh::into(vertices, indices));
    if (!made) return std::puts(made.error().message()), 1;
    std::printf("%u slices, %zu vertices, %zu triangles\n", made->glyphs, vertices.size(), indices.size() / 3);
}
