// SPDX-License-Identifier: MIT
#pragma once

// Policies, fonts, vertices and sinks as a user would write them, only from the concepts' comments, without a look at the
// library's own policies.

#include <typemesh/core/orientation.hpp>
#include <typemesh/discretise/discretiser.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/side_normals.hpp>
#include <typemesh/glyph/stage.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/outline/outline_source.hpp>
#include <typemesh/triangulate/triangulator.hpp>
#include <typemesh/vertex/mesh_sink.hpp>
#include <typemesh/vertex/stream_sink.hpp>
#include <typemesh/vertex/vertex_traits.hpp>

#include <array>
#include <cmath>
#include <cstdint>

namespace stranger {

using namespace typemesh;

/// Every curve in three lines.
struct thirds {
    template <class Curve, class Put>
    void operator()(const Curve& c, double, Put&& put) const noexcept
    {
        put(c.at(1.0 / 3.0), 1.0 / 3.0);
        put(c.at(2.0 / 3.0), 2.0 / 3.0);
        put(c.at(1.0), 1.0);
    }
};

/// Takes an edge, tries every point for a triangle that nothing disturbs, and continues with the triangle's other two
/// sides.
struct patient {
    struct side {
        std::uint32_t from, to;
    };

    error operator()(const region& r, workspace& space, triangle_list& out) const noexcept
    {
        const auto p = r.points();
        const auto n = static_cast<std::uint32_t>(p.size());
        workspace::scope scratch{space};
        const std::size_t most = 8 * std::size_t{n} + 8;  // edges, and each triangle's two new sides
        side* lines = scratch.take<side>(most);
        side* open = scratch.take<side>(most);
        if (lines == nullptr || open == nullptr) return error::out_of_memory;
        const std::size_t before = out.size();
        if (!out.reserve(before + r.triangle_count())) return error::out_of_memory;

        std::size_t line_count = 0, open_count = 0;
        for (std::uint32_t k = 0; k < r.loop_count(); ++k) {
            for (std::uint32_t i = r.starts()[k]; i < r.starts()[k + 1]; ++i) {
                lines[line_count++] = open[open_count++] = {i, i + 1 == r.starts()[k + 1] ? r.starts()[k] : i + 1};
            }
        }
        while (open_count != 0) {
            const side s = open[--open_count];
            for (std::uint32_t c = 0; c < n; ++c) {
                if (orientation(p[s.from], p[s.to], p[c]) <= 0 || holds_a_point(p, s.from, s.to, c)) continue;
                if (disturbed(p, {s.to, c}, lines, line_count) || disturbed(p, {c, s.from}, lines, line_count))
                    continue;
                out.push_back_unchecked({s.from, s.to, c});
                for (const side beside : {side{s.to, c}, side{c, s.from}}) {
                    std::size_t k = 0;
                    while (k < open_count && !(open[k].from == beside.from && open[k].to == beside.to)) ++k;
                    if (k < open_count) {
                        open[k] = open[--open_count];
                    } else {
                        open[open_count++] = {beside.to, beside.from};
                        lines[line_count++] = beside;
                    }
                }
                break;
            }
        }
        return {};
    }

private:
    static bool holds_a_point(std::span<const grid_point> p, std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
    {
        using typemesh::orientation;
        for (const auto q : p) {
            if (q == p[a] || q == p[b] || q == p[c]) continue;
            if (orientation(p[a], p[b], q) >= 0 && orientation(p[b], p[c], q) >= 0 && orientation(p[c], p[a], q) >= 0)
                return true;
        }
        return false;
    }
    static bool disturbed(std::span<const grid_point> p, side s, const side* lines, std::size_t count) noexcept
    {
        using typemesh::orientation;
        const auto sign = [](std::int64_t v) { return v > 0 ? 1 : v < 0 ? -1 : 0; };
        for (std::size_t i = 0; i < count; ++i) {
            const auto a = p[s.from], b = p[s.to], c = p[lines[i].from], d = p[lines[i].to];
            if (sign(orientation(a, b, c)) * sign(orientation(a, b, d)) < 0 &&
                sign(orientation(c, d, a)) * sign(orientation(c, d, b)) < 0)
                return true;
        }
        return false;
    }
};

/// Walls only, smooth all round, of a height in em: 2N vertices.
struct fence {
    float tall = 0.1f;

    using plan_data = plan_arrays<vec2>;  // the normals in the plane, one a point

    result<part_sizes> plan(const region& r, plan_data& data) const noexcept
    {
        const std::size_t n = r.points().size();
        vec2* mine = data.of<vec2>().append(n);
        if (mine == nullptr && n != 0) return error::out_of_memory;
        for (std::uint32_t k = 0; k < r.loop_count(); ++k) {
            const std::uint32_t first = r.starts()[k], end = r.starts()[k + 1];
            for (std::uint32_t i = first; i < end; ++i) {
                const auto before = r.points()[i == first ? end - 1 : i - 1],
                           after = r.points()[i + 1 == end ? first : i + 1];
                const double dx = double(after.x) - before.x, dy = double(after.y) - before.y,
                             l = std::hypot(dx, dy) + 1e-300;
                mine[i] = {static_cast<float>(dy / l), static_cast<float>(-dx / l)};
            }
        }
        part_sizes sizes;
        sizes.vertices[part::side] = sizes.triangles[part::side] = static_cast<std::uint32_t>(2 * n);
        return sizes;
    }
    height_range heights() const noexcept { return {0.0, tall}; }

    template <attribute Wants, class Put>
    void vertices(part p, const solid_with<plan_data>& s, const placement& at, Put&& put) const noexcept
    {
        if (p != part::side) return;
        const auto normals = s.data.of<vec2>();
        for (std::size_t i = 0; i < s.points.size(); ++i) {
            for (const double height : {static_cast<double>(tall), 0.0}) {
                surface_point<Wants> v;
                if constexpr (has(Wants, attribute::position)) v.position = at.position(s.points[i], at.height(height));
                if constexpr (has(Wants, attribute::normal)) v.normal = at.normal(normals[i]);
                if constexpr (has(Wants, attribute::uv)) v.uv = {static_cast<float>(i), static_cast<float>(height)};
                put(v);
            }
        }
    }
    template <class Put>
    void triangles(part p, const solid& s, const first_vertices& first, Put&& put) const noexcept
    {
        if (p != part::side) return;
        for (std::size_t k = 0; k + 1 < s.starts.size(); ++k) {
            for (std::uint32_t i = s.starts[k]; i < s.starts[k + 1]; ++i) {
                const std::uint32_t j = i + 1 == s.starts[k + 1] ? s.starts[k] : i + 1, base = first[p];
                put(base + 2 * i, base + 2 * i + 1, base + 2 * j + 1);
                put(base + 2 * i, base + 2 * j + 1, base + 2 * j);
            }
        }
    }
};

/// A style of normals: every wall flat, so every point is doubled.
struct faceted {
    static constexpr bool shares_caps = false;

    error operator()(const region& r, std::span<side_point> sides) const noexcept
    {
        for (std::uint32_t k = 0; k < r.loop_count(); ++k) {
            for (std::uint32_t i = r.starts()[k]; i < r.starts()[k + 1]; ++i) {
                const std::uint32_t j = i + 1 == r.starts()[k + 1] ? r.starts()[k] : i + 1;
                const double dx = double(r.points()[j].x) - r.points()[i].x,
                             dy = double(r.points()[j].y) - r.points()[i].y;
                const double l = std::sqrt(dx * dx + dy * dy);
                sides[i].after = sides[j].before = {static_cast<float>(dy / l), static_cast<float>(-dx / l)};
                sides[i].doubled = true;
            }
        }
        return {};
    }
};

/// A font of three signs, shaper and outline source in one: "[" is a box, "o" a ring, "~" a wave; each is an em wide.
class stamps {
public:
    double units_per_em() noexcept { return 100.0; }
    fill_rule fill() noexcept { return fill_rule::even_odd; }
    line_metrics metrics(direction) noexcept { return {80.0, -20.0, 10.0}; }

    typemesh::error shape(typemesh::text_view text, const typemesh::text_item& item, const typemesh::shape_options&,
                          typemesh::buffer<typemesh::shaped_glyph>& glyphs) noexcept
    {
        for (std::uint32_t i = item.first; i < item.last; ++i) {
            const std::uint32_t c = text.unit(i);
            typemesh::shaped_glyph g;
            g.id = c == '[' ? 1 : c == 'o' ? 2 : c == '~' ? 3 : c == ' ' ? 4 : 0;
            g.cluster = i;
            g.advance = 100.0;
            if (g.id == 0) g.flags = typemesh::glyph_flags::missing;
            if (!glyphs.push_back(g)) return typemesh::error::out_of_memory;
        }
        return {};
    }

    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        switch (id) {
        case 1: box(sink, 10, 0, 90, 80); return {};
        case 2:
            box(sink, 10, 0, 90, 80);
            sink.move({50, 20});
            sink.quadratic({80, 20}, {80, 40});
            sink.quadratic({80, 60}, {50, 60});
            sink.quadratic({20, 60}, {20, 40});
            sink.quadratic({20, 20}, {50, 20});
            sink.close();
            return {};
        case 3:
            sink.move({0, 30});
            sink.cubic({30, 0}, {70, 60}, {100, 30});
            sink.line({100, 50});
            sink.cubic({70, 80}, {30, 20}, {0, 50});
            return {};  // left open: it is closed with a line
        case 4: return {};
        default: return error::unknown_glyph;
        }
    }

private:
    template <class Sink>
    static void box(Sink& sink, double x0, double y0, double x1, double y1) noexcept
    {
        sink.move({x0, y0});
        sink.line({x1, y0});
        sink.line({x1, y1});
        sink.line({x0, y1});
        sink.close();
    }
};

/// A vertex of an engine of their own.
struct vertex {
    float place[3];
    std::int8_t normal[4];
    float uv[2];
};

/// A writer with state: positions as 16-bit numbers in a box, with a colour beside them.
struct packed_vertex {
    std::uint16_t place[3];
    std::uint32_t colour;
};
struct packing_writer {
    static constexpr auto wants = attribute::position;
    float low, high;
    std::uint32_t colour;

    packed_vertex operator()(const surface_point<wants>& s) const noexcept
    {
        const auto pack = [this](float v) {
            return static_cast<std::uint16_t>((v - low) / (high - low) * 65535.0f + 0.5f);
        };
        return {{pack(s.position.x), pack(s.position.y), pack(s.position.z)}, colour};
    }
};

/// A sink that keeps nothing but the volume inside the mesh, and positions for its corners.
struct volume {
    static constexpr auto wants = attribute::position;
    std::array<vec3, 4096> corners;
    std::size_t count = 0, triangles = 0;
    double six_times = 0.0;
    bool ended = false;

    error begin(mesh_size exact) noexcept
    {
        count = triangles = 0;
        six_times = 0.0;
        ended = false;
        if (exact.vertices > corners.size()) return {error::buffer_too_small, exact.vertices};
        return {};
    }
    void vertex(const surface_point<wants>& s) noexcept { corners[count++] = s.position; }
    void triangle(std::uint32_t i, std::uint32_t j, std::uint32_t k) noexcept
    {
        const auto a = corners[i], b = corners[j], c = corners[k];
        six_times += double(a.x) * (double(b.y) * c.z - double(b.z) * c.y) -
                     double(a.y) * (double(b.x) * c.z - double(b.z) * c.x) +
                     double(a.z) * (double(b.x) * c.y - double(b.y) * c.x);
        ++triangles;
    }
    void end() noexcept { ended = true; }
    double value() const noexcept { return six_times / 6.0; }
};

/// A stream in a format of their own: normals in four signed bytes.
struct byte_normals {
    static constexpr auto wants = attribute::normal;
    std::array<std::int8_t, 4>* data;
    std::size_t capacity;

    void put(std::size_t i, const surface_point<wants>& s) const noexcept
    {
        const auto byte = [](float f) { return static_cast<std::int8_t>(f * 127.0f); };
        data[i] = {byte(s.normal.x), byte(s.normal.y), byte(s.normal.z), 0};
    }
};

/// An observer that counts.
struct stage_counter {
    std::array<int, 7> seen{};
    void operator()(stage s) noexcept { ++seen[static_cast<std::size_t>(s)]; }
};

}  // namespace stranger

template <>
struct typemesh::vertex_traits<stranger::vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv;

    stranger::vertex operator()(const surface_point<wants>& s) const noexcept
    {
        const auto byte = [](float f) { return static_cast<std::int8_t>(f * 127.0f); };
        return {{s.position.x, s.position.y, s.position.z},
                {byte(s.normal.x), byte(s.normal.y), byte(s.normal.z), 0},
                {s.uv.x, s.uv.y}};
    }
};

static_assert(typemesh::discretiser<stranger::thirds>);
static_assert(typemesh::triangulator<stranger::patient>);
static_assert(!typemesh::proving_triangulator<stranger::patient>);
static_assert(typemesh::extruder<stranger::fence>);
static_assert(typemesh::side_normals<stranger::faceted>);
static_assert(typemesh::shaper<stranger::stamps>);
static_assert(typemesh::outline_source<stranger::stamps>);
static_assert(typemesh::mesh_vertex<stranger::vertex>);
static_assert(typemesh::vertex_writer<stranger::packing_writer>);
static_assert(typemesh::mesh_sink<stranger::volume>);
static_assert(typemesh::vertex_stream<stranger::byte_normals>);
static_assert(typemesh::stage_observer<stranger::stage_counter>);
