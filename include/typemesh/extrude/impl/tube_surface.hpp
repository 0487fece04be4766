// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/extrude/placement.hpp>
#include <typemesh/extrude/side_point.hpp>
#include <typemesh/extrude/texture.hpp>
#include <typemesh/extrude/texture_tangent.hpp>
#include <typemesh/vertex/surface_point.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// How the tube along an open line ends.
enum class tube_end : std::uint32_t {
    flat,  ///< in a polygon across the line
    round  ///< in half a ball around the line's end
};

namespace detail {

inline constexpr double right_angle = 1.57079632679489661923;

/// A point of a tube's path, and its mitre: the way to the right corner, in cells.
struct tube_joint {
    grid_point at;
    vec2 lean;
};

/// The tube along one path.
struct tube_path {
    float radius = 0.0f;        ///< in em; 0: there is no tube
    std::uint32_t open = 0;     ///< 1: the path is open
    std::uint32_t doubled = 0;  ///< the number of its points that have two rings
};

/// A regular polygon in the unit circle. Its first corner lies on the right of the path, the next one towards the
/// reader; the last corner repeats the first. Sine and cosine are multiples of 2^-22, so that their product with a
/// float is exact.
class tube_section {
public:
    static constexpr std::uint32_t min_sides = 3, max_sides = 128;

    /// The error for options of tubes that are out of range, or none: of a tubed or a tube_style.
    template <class Options>
    [[nodiscard]] static error refused(const Options& of) noexcept
    {
        if (!is_finite(as_double(of.radius)) || !(of.radius > 0.0f)) return error::bad("radius");
        if (of.sides < min_sides || of.sides > max_sides) return error::bad("sides");
        if (!is_crease_angle(of.crease_degrees)) return error::bad("crease_degrees");
        const bool cuts = is_finite(as_double(of.corner_cut)) && of.corner_cut >= 0.0f && of.corner_cut <= 1.0f;
        return cuts ? error{} : error::bad("corner_cut");
    }

    explicit tube_section(std::uint32_t sides) noexcept : sides_{sides}
    {
        const double step = 4.0 * right_angle / sides;
        for (std::uint32_t k = 0; k < sides; ++k) {
            right_[k] = steady(std::cos(step * k));
            up_[k] = steady(std::sin(step * k));
        }
        right_[sides] = right_[0];
        up_[sides] = up_[0];
    }

    [[nodiscard]] std::uint32_t sides() const noexcept { return sides_; }
    [[nodiscard]] double right(std::uint32_t k) const noexcept { return right_[k]; }
    [[nodiscard]] double up(std::uint32_t k) const noexcept { return up_[k]; }

    /// The smallest distance between two corners of a tube's rings, in radii; of those in round ends, too.
    [[nodiscard]] static double least_step(std::uint32_t sides) noexcept
    {
        const double steps = (sides + 2) / 4;
        return 2.0 * std::sin(2.0 * right_angle / sides) * sine_of_quarter(1.0 / steps);
    }

    /// The sine of a part of a quarter turn.
    [[nodiscard]] static double sine_of_quarter(double part) noexcept { return steady(std::sin(right_angle * part)); }

private:
    [[nodiscard]] static double steady(double v) noexcept { return std::floor(v * 0x1p22 + 0.5) * 0x1p-22; }

    std::uint32_t sides_;
    double right_[max_sides + 1];
    double up_[max_sides + 1];
};

/// The tubes along paths: rings of vertices around the points, and triangles between them.
///
///     path     a ring at each point; two where the normals before and after it differ
///     ring     sides + 1 vertices, the last at the place of the first, with another texture coordinate
///     end      flat: `sides` vertices; round: further rings, and a tip
struct tube_surface {
    array_view<const std::uint32_t> starts;
    array_view<const side_point> sides;
    array_view<const tube_joint> joints;
    array_view<const tube_path> paths;
    std::uint32_t sides_around = 16;
    tube_end end = tube_end::round;
    texture_mapping texture = texture_mapping::em;

    [[nodiscard]] std::uint32_t ring() const noexcept { return sides_around + 1; }
    /// The number of steps from the rim of a round end to its tip.
    [[nodiscard]] std::uint32_t end_steps() const noexcept { return (sides_around + 2) / 4; }

    [[nodiscard]] std::uint64_t vertex_count(std::size_t path) const noexcept
    {
        const tube_path& p = paths[path];
        if (!(p.radius > 0.0f)) return 0;
        const std::uint64_t rings = std::uint64_t{starts[path + 1]} - starts[path] + p.doubled;
        return rings * ring() + (p.open != 0 ? 2 * end_vertices() : 0);
    }
    [[nodiscard]] std::uint64_t triangle_count(std::size_t path) const noexcept
    {
        const tube_path& p = paths[path];
        if (!(p.radius > 0.0f)) return 0;
        const std::uint64_t edges = std::uint64_t{starts[path + 1]} - starts[path] - p.open;
        return edges * 2 * sides_around + (p.open != 0 ? 2 * end_triangles() : 0);
    }

    /// Calls put(surface_point<Wants>) for each vertex, path by path: the rings, the end at the first point, the end at
    /// the last point. `at` has heights in em.
    template <attribute Wants, class Axes, class Put>
    void vertices(const Axes& axes, const placement& at, Put& put) const noexcept
    {
        const auto write_with = [&](const auto& mapping) noexcept {
            write<Wants>(
                setting<std::remove_cvref_t<decltype(mapping)>, Axes>{mapping, axes, at, tube_section{sides_around}},
                put);
        };
        if constexpr (has(Wants, attribute::uv | attribute::tangent))
            with_mapping(texture, [&]<class Mapping>() noexcept { write_with(Mapping{at}); });
        else
            write_with(no_mapping{});
    }

    /// Calls put(a, b, c) for each triangle; `first` is the number of the first vertex.
    template <class Put>
    void triangles(std::uint32_t first, Put& put) const noexcept
    {
        for (std::size_t k = 0; k < paths.size(); ++k) {
            if (!(paths[k].radius > 0.0f)) continue;
            const bool open = paths[k].open != 0;
            std::uint32_t next = first;  // the ring that follows
            const std::uint32_t begin = starts[k], end_of_path = starts[k + 1];
            for (std::uint32_t i = begin; i < end_of_path; ++i) {
                next += (sides[i].doubled ? 2 : 1) * ring();
                const bool last = i + 1 == end_of_path;
                if (!last || !open) join(next - ring(), last ? first : next, put);
            }
            if (open) {
                close(first, next, true, put);
                close(next - ring(), next + static_cast<std::uint32_t>(end_vertices()), false, put);
            }
            first += static_cast<std::uint32_t>(vertex_count(k));
        }
    }

private:
    struct no_mapping {};

    [[nodiscard]] std::uint64_t end_vertices() const noexcept
    {
        return end == tube_end::flat ? sides_around : std::uint64_t{end_steps() - 1} * ring() + 1;
    }
    [[nodiscard]] std::uint64_t end_triangles() const noexcept
    {
        return end == tube_end::flat ? sides_around - 2 : std::uint64_t{2 * end_steps() - 1} * sides_around;
    }

    /// Two triangles for each side between two rings, the second one farther along the path.
    template <class Put>
    void join(std::uint32_t a, std::uint32_t b, Put& put) const noexcept
    {
        for (std::uint32_t k = 0; k < sides_around; ++k, ++a, ++b) {
            put(a, b, b + 1);
            put(a, b + 1, a + 1);
        }
    }

    /// The end behind a ring, whose own vertices begin at `own`; before the path or after it.
    template <class Put>
    void close(std::uint32_t rim, std::uint32_t own, bool before, Put& put) const noexcept
    {
        const auto turned = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept {
            if (before)
                put(a, b, c);
            else
                put(a, c, b);
        };
        if (end == tube_end::flat) {
            for (std::uint32_t k = 1; k + 1 < sides_around; ++k) turned(own, own + k, own + k + 1);
            return;
        }
        for (std::uint32_t step = 1; step < end_steps(); ++step, rim = own, own += ring()) {
            if (before)
                join(own, rim, put);
            else
                join(rim, own, put);
        }
        for (std::uint32_t k = 0; k < sides_around; ++k) turned(own, rim + k, rim + k + 1);
    }

    /// A ring to be written.
    struct ring_place {
        point at;            // its middle
        vec2 lean;           // to its right corner
        float height;        // the radius, in em
        float girth;         // the radius of the tube, in em
        vec2 right;          // the normal on the right
        vec2 forwards = {};  // the part of the normal along the path; 0 except in a round end
        float share = 1.0f;  // of the normal across the path
        float along = 0.0f;  // as in side_point

        [[nodiscard]] bool is_end() const noexcept { return forwards != vec2{}; }
    };

    /// What all vertices need.
    template <class Mapping, class Axes>
    struct setting {
        const Mapping& mapping;
        const Axes& axes;
        const placement& at;
        tube_section around;
    };

    template <attribute Wants, class Mapping, class Axes, class Put>
    void write(const setting<Mapping, Axes>& in, Put& put) const noexcept
    {
        const auto ring_at = [&](const ring_place& r) noexcept {
            for (std::uint32_t k = 0; k <= sides_around; ++k) put(vertex<Wants>(in, k, r));
        };
        for (std::size_t path = 0; path < paths.size(); ++path) {
            if (!(paths[path].radius > 0.0f)) continue;
            const auto place_of = [&](std::uint32_t i) noexcept {
                const float radius = paths[path].radius;
                return ring_place{placement::exact(joints[i].at),
                                  joints[i].lean,
                                  radius,
                                  radius,
                                  sides[i].before,
                                  {},
                                  1.0f,
                                  sides[i].along};
            };
            for (std::uint32_t i = starts[path]; i < starts[path + 1]; ++i) {
                ring_place r = place_of(i);
                ring_at(r);
                if (!sides[i].doubled) continue;
                r.right = sides[i].after;
                if constexpr (has(Wants, attribute::uv))
                    if (sides[i].seam) r.along = Mapping::after_seam(r.along);
                ring_at(r);
            }
            if (paths[path].open == 0) continue;
            write_end<Wants>(place_of(starts[path]), -1.0, in, put);
            write_end<Wants>(place_of(starts[path + 1] - 1), 1.0, in, put);
        }
    }

    /// The vertices of an end beyond its rim; `way` is 1 after the path and -1 before it.
    template <attribute Wants, class Mapping, class Axes, class Put>
    void write_end(const ring_place& rim, double way, const setting<Mapping, Axes>& in, Put& put) const noexcept
    {
        const auto forwards = [way](vec2 right, double by) noexcept {
            return point{-way * by * as_double(right.y), way * by * as_double(right.x)};
        };
        const auto single = [](point p) noexcept { return vec2{static_cast<float>(p.x), static_cast<float>(p.y)}; };
        ring_place r = rim;
        if (end == tube_end::flat) {
            r.forwards = single(forwards(rim.right, 1.0));
            r.share = 0.0f;
            for (std::uint32_t k = 0; k < sides_around; ++k) put(vertex<Wants>(in, k, r));
            return;
        }
        const double steps = end_steps();
        const double arc = texture == texture_mapping::em
                               ? way * length(point{as_double(rim.lean.x), as_double(rim.lean.y)}) * right_angle
                               : 0.0;
        for (std::uint32_t step = 1; step <= end_steps(); ++step) {
            const bool tip = step == end_steps();
            const double out = tip ? 1.0 : tube_section::sine_of_quarter(step / steps);
            const double rest = tip ? 0.0 : tube_section::sine_of_quarter((steps - step) / steps);
            r.at = rim.at + forwards(rim.lean, out);
            r.lean = single(rest * point{as_double(rim.lean.x), as_double(rim.lean.y)});
            r.height = static_cast<float>(rest * as_double(rim.height));
            r.forwards = single(forwards(rim.right, out));
            r.share = static_cast<float>(rest);
            r.along = static_cast<float>(as_double(rim.along) + arc * step / steps);
            for (std::uint32_t k = 0; k <= (tip ? 0 : sides_around); ++k) put(vertex<Wants>(in, k, r));
        }
    }

    template <attribute Wants, class Mapping, class Axes>
    [[nodiscard]] surface_point<Wants> vertex(const setting<Mapping, Axes>& in, std::uint32_t k,
                                              const ring_place& r) const noexcept
    {
        surface_point<Wants> v;
        const double right = in.around.right(k), up = in.around.up(k);
        [[maybe_unused]] const point p{r.at.x + right * as_double(r.lean.x), r.at.y + right * as_double(r.lean.y)};
        if constexpr (has(Wants, attribute::position)) {
            v.position = in.axes.position(in.axes.foot(p), in.at.height(up * as_double(r.height)));
        }
        if constexpr (has(Wants, attribute::normal)) {
            const double across = as_double(r.share);
            v.normal =
                in.axes.direction(static_cast<float>(across * right * as_double(r.right.x) + as_double(r.forwards.x)),
                                  static_cast<float>(across * right * as_double(r.right.y) + as_double(r.forwards.y)),
                                  static_cast<float>(across * up));
        }
        if constexpr (has(Wants, attribute::uv | attribute::tangent)) {
            const double turn = static_cast<double>(k) / sides_around;
            const wall_place place{p, r.along, v_of(turn, r.girth, in.at), r.right};
            if constexpr (has(Wants, attribute::uv)) v.uv = in.mapping.uv(place);
            if constexpr (has(Wants, attribute::tangent))
                v.tangent = r.is_end() ? end_tangent(in, k, r) : in.mapping.tangent(in.axes, place);
        }
        return v;
    }

    /// The tangent beyond a rim: the path's direction, turned with the normal towards the tip or away from it.
    template <class Setting>
    [[nodiscard]] static vec4 end_tangent(const Setting& in, std::uint32_t k, const ring_place& r) noexcept
    {
        const point right{as_double(r.right.x), as_double(r.right.y)}, path{-right.y, right.x};
        const double lean = path.x * as_double(r.forwards.x) + path.y * as_double(r.forwards.y);
        const point t = as_double(r.share) * path - (lean * in.around.right(k)) * right;
        const vec3 u{static_cast<float>(t.x), static_cast<float>(t.y), static_cast<float>(-lean * in.around.up(k))};
        return texture_tangent{in.at.frame}.along(in.axes, u, 1.0f);
    }

    /// v grows from 0 to the length once around, in em; or from 0 to 1.
    [[nodiscard]] float v_of(double turn, float radius, const placement& at) const noexcept
    {
        const double length = texture == texture_mapping::cylindrical ? 1.0 : 4.0 * right_angle * as_double(radius);
        return planar_texture{texture_mapping::em, at}.turned(static_cast<float>(turn * length));
    }
};

}  // namespace detail

}  // namespace typemesh::inline TYPEMESH_ABI
