// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/extrude/placement.hpp>
#include <typemesh/vertex/affine3.hpp>
#include <typemesh/vertex/bounds3.hpp>
#include <typemesh/vertex/surface_point.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace typemesh::inline TYPEMESH_ABI {

/// An affine map, prepared for the glyphs of a letter: for positions, normals (by the inverse transpose), tangents and
/// the order of a triangle's corners. The identity changes no bit.
class letter_move {
public:
    letter_move() noexcept = default;
    explicit letter_move(const affine3& map) noexcept : map_{map}
    {
        const bool straight =
            map.x == vec3{1.0f, 0.0f, 0.0f} && map.y == vec3{0.0f, 1.0f, 0.0f} && map.z == vec3{0.0f, 0.0f, 1.0f};
        if (!straight)
            find_normals();
        else
            how_ = map.origin == vec3{} ? kind::as_it_is : kind::shift;
    }

    [[nodiscard]] const affine3& map() const noexcept { return map_; }
    /// The map of normals.
    [[nodiscard]] const affine3& normals() const noexcept { return normals_; }
    /// Whether it is the identity.
    [[nodiscard]] bool is_identity() const noexcept { return how_ == kind::as_it_is; }
    /// Whether it leaves directions as they are.
    [[nodiscard]] bool is_shift() const noexcept { return how_ <= kind::shift; }
    /// Whether the map of normals keeps their lengths.
    [[nodiscard]] bool keeps_lengths() const noexcept { return how_ != kind::any; }
    /// Whether two corners of each triangle must be swapped.
    [[nodiscard]] bool mirrors() const noexcept { return mirrors_; }

    /// Moves the placement of a glyph, if the map only shifts, turns and scales: then points are not moved one by one.
    /// A shift in the text's plane costs nothing for each point. Returns false if the map does more, or mirrors.
    [[nodiscard]] bool move_placement(placement& at) const noexcept
    {
        if (how_ == kind::any || mirrors_) return false;
        if (is_identity()) return true;
        if (is_shift() && is_zero(along(at.frame.toward)))
            at.pen = at.pen + 1.0 / at.unit_per_cell * point{along(at.frame.right), along(at.frame.up)};
        else
            turn_placement(at);
        return true;
    }

    /// The map for points that are given relative to a glyph's origin, which is `pen`.
    [[nodiscard]] affine3 map_from(vec3 pen) const noexcept
    {
        affine3 from = map_;
        from.origin = map_(pen);
        return from;
    }

    /// The box of everything in a box, after the move. It is a little larger, for the rounding of positions: by 2^-20
    /// of the largest number that is added up for a coordinate.
    [[nodiscard]] bounds3 operator()(const bounds3& b) const noexcept
    {
        if (is_identity()) return b;
        const vec3 first = map_(b.low);
        bounds3 all{first, first};
        for (unsigned corner = 1; corner < 8; ++corner)
            all.add(map_({(corner & 1) != 0 ? b.high.x : b.low.x, (corner & 2) != 0 ? b.high.y : b.low.y,
                          (corner & 4) != 0 ? b.high.z : b.low.z}));
        float farthest = 0.0f;
        for (const vec3 p : {b.low, b.high, all.low, all.high})
            for (const float v : {p.x, p.y, p.z}) farthest = std::fabs(v) > farthest ? std::fabs(v) : farthest;
        const auto larger = [](float v, float w) noexcept { return (std::fmax)(std::fabs(v), std::fabs(w)); };
        const float x = larger(b.low.x, b.high.x), y = larger(b.low.y, b.high.y), z = larger(b.low.z, b.high.z);
        for (float vec3::* row : {&vec3::x, &vec3::y, &vec3::z})
            farthest = (std::fmax)(farthest, std::fabs(map_.x.*row) * x + std::fabs(map_.y.*row) * y +
                                                 std::fabs(map_.z.*row) * z + std::fabs(map_.origin.*row));
        const float more = farthest * 0x1p-20f;
        all.low = {all.low.x - more, all.low.y - more, all.low.z - more};
        all.high = {all.high.x + more, all.high.y + more, all.high.z + more};
        return all;
    }

private:
    enum class kind : std::uint8_t { as_it_is, shift, similar, any };

    struct column {
        double x, y, z;

        explicit column(vec3 v) noexcept : x{as_double(v.x)}, y{as_double(v.y)}, z{as_double(v.z)} {}
        column(double a, double b, double c) noexcept : x{a}, y{b}, z{c} {}
        [[nodiscard]] vec3 times(double s) const noexcept
        {
            return {static_cast<float>(x * s), static_cast<float>(y * s), static_cast<float>(z * s)};
        }
    };
    [[nodiscard]] static column cross(const column& a, const column& b) noexcept
    {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
    [[nodiscard]] static double dot(const column& a, const column& b) noexcept
    {
        return a.x * b.x + a.y * b.y + a.z * b.z;
    }

    /// Turns the axes of a placement, and writes its origin in the turned axes. They are floats, and not quite at right
    /// angles: the pen knows.
    void turn_placement(placement& at) const noexcept
    {
        typemesh::frame& f = at.frame;
        const column pen = sum(at.unit_per_cell * at.pen.x, column{f.right}, at.unit_per_cell * at.pen.y, column{f.up});
        const column moved = sum(1.0, sum(pen.x, column{map_.x}, pen.y, column{map_.y}), 1.0,
                                 sum(pen.z, column{map_.z}, 1.0, column{map_.origin}));
        if (!is_shift()) {
            for (vec3* axis : {&f.right, &f.up, &f.toward}) *axis = normals_.direction(*axis);
            at.unit_per_cell *= scale_;
            at.unit_per_depth *= scale_;
        }
        const column x{f.right}, y{f.up}, z{f.toward}, yz = cross(y, z);
        const double by = 1.0 / dot(x, yz), per_unit = by / at.unit_per_cell;
        at.pen = {per_unit * dot(moved, yz), per_unit * dot(moved, cross(z, x))};
        at.rise = by * dot(moved, cross(x, y));
    }

    [[nodiscard]] static column sum(double a, const column& v, double b, const column& w) noexcept
    {
        return {a * v.x + b * w.x, a * v.y + b * w.y, a * v.z + b * w.z};
    }

    /// The part of a shift along an axis.
    [[nodiscard]] double along(vec3 axis) const noexcept { return dot(column{axis}, column{map_.origin}); }

    /// Finds the map of normals. If the map only turns, mirrors and scales, up to 2^-20, it is the map without its
    /// scale, and needs no square root for each normal. Otherwise it is the map's cofactors, with the sign of its
    /// determinant.
    void find_normals() noexcept
    {
        const column x{map_.x}, y{map_.y}, z{map_.z};
        const column c[] = {cross(y, z), cross(z, x), cross(x, y)};
        mirrors_ = dot(x, c[0]) < 0.0;

        const double xx = dot(x, x), allowed = 0x1p-20 * xx;
        const auto is = [allowed](double value, double wanted) noexcept {
            return std::fabs(value - wanted) <= allowed;
        };
        if (xx > 0.0 && is(dot(y, y), xx) && is(dot(z, z), xx) && is(dot(x, y), 0.0) && is(dot(y, z), 0.0) &&
            is(dot(z, x), 0.0)) {
            how_ = kind::similar;
            if (std::fabs(xx - 1.0) > 0x1p-20) scale_ = std::sqrt(xx);
            const double by = 1.0 / scale_;
            normals_ = {x.times(by), y.times(by), z.times(by), {}};
            return;
        }
        how_ = kind::any;
        double largest = 0.0;
        for (const column& one : c)
            for (const double v : {one.x, one.y, one.z}) largest = std::fmax(largest, std::fabs(v));
        if (!(largest > 0.0)) return;  // all that it maps lies on one line
        const double by = (mirrors_ ? -1.0 : 1.0) / largest;
        normals_ = {c[0].times(by), c[1].times(by), c[2].times(by), {}};
    }

    affine3 map_ = {};
    affine3 normals_ = {};
    double scale_ = 1.0;  // of a similar map
    kind how_ = kind::as_it_is;
    bool mirrors_ = false;
};

/// Coordinates of several points, for one instruction of the processor at a time.
struct point_block {
    static constexpr std::size_t size = 64;

    float x[size] = {}, y[size] = {}, z[size] = {};

    void set(std::size_t i, vec3 p) noexcept
    {
        x[i] = p.x;
        y[i] = p.y;
        z[i] = p.z;
    }
    [[nodiscard]] vec3 operator[](std::size_t i) const noexcept { return {x[i], y[i], z[i]}; }
};

/// Maps the first `count` points of a block, and a few more. Every point of every mesh is moved by this one loop, so
/// that points that meet stay together, however a compiler rounds.
[[gnu::noinline]] inline void move_points(affine3 map, point_block& points, std::size_t count) noexcept
{
    constexpr std::size_t step = 8;
    static_assert(point_block::size % step == 0);
    for (std::size_t first = 0; first < count; first += step) {
        float *x = points.x + first, *y = points.y + first, *z = points.z + first;
        for (std::size_t i = 0; i < step; ++i) {
            const float u = x[i], v = y[i], w = z[i];
            x[i] = map.x.x * u + map.y.x * v + map.z.x * w + map.origin.x;
            y[i] = map.x.y * u + map.y.y * v + map.z.y * w + map.origin.y;
            z[i] = map.x.z * u + map.y.z * v + map.z.z * w + map.origin.z;
        }
    }
}

/// Collects the surface points of one letter and moves them, a block at a time.
template <attribute Wants>
class point_mover {
public:
    /// The next points belong to another letter.
    ///
    ///     map    of positions: the move's own, or another from letter_move::map_from()
    void start(const letter_move& move, const affine3& map) noexcept
    {
        map_ = map;
        normals_map_ = move.normals();
        keeps_lengths_ = move.keeps_lengths();
        mirrors_ = move.mirrors();
    }

    /// Takes a point. Returns whether the block is full: give() must then be called.
    [[nodiscard]] bool take(const surface_point<Wants>& s) noexcept
    {
        if constexpr (has(Wants, attribute::position)) positions_.set(count_, s.position);
        if constexpr (has(Wants, attribute::normal)) normals_.set(count_, s.normal);
        points_[count_] = s;
        return ++count_ == point_block::size;
    }

    /// Calls put(moved point) for all points that were taken, in order. Attributes other than position, normal and
    /// tangent stay.
    template <class Put>
    void give(const Put& put) noexcept
    {
        if constexpr (has(Wants, attribute::position)) move_points(map_, positions_, count_);
        if constexpr (has(Wants, attribute::normal)) move_points(normals_map_, normals_, count_);
        for (std::size_t i = 0; i < count_; ++i) {
            surface_point<Wants> moved = points_[i];
            if constexpr (has(Wants, attribute::position)) moved.position = positions_[i];
            if constexpr (has(Wants, attribute::normal))
                moved.normal = keeps_lengths_ ? normals_[i] : unit(normals_[i], moved.normal);
            if constexpr (has(Wants, attribute::tangent)) {
                const vec3 was{moved.tangent.x, moved.tangent.y, moved.tangent.z};
                const vec3 t = unit(map_.direction(was), was);
                moved.tangent = {t.x, t.y, t.z, mirrors_ ? -moved.tangent.w : moved.tangent.w};
            }
            put(moved);
        }
        count_ = 0;
    }

private:
    /// The direction of a vector; `otherwise` if it has none.
    [[nodiscard]] static vec3 unit(vec3 v, vec3 otherwise) noexcept
    {
        const double x = as_double(v.x), y = as_double(v.y), z = as_double(v.z);
        const double length = std::sqrt(x * x + y * y + z * z);
        if (!(length > 0.0)) return otherwise;
        const double by = 1.0 / length;
        return {static_cast<float>(x * by), static_cast<float>(y * by), static_cast<float>(z * by)};
    }

    point_block positions_, normals_;
    surface_point<Wants> points_[point_block::size] = {};
    std::size_t count_ = 0;
    affine3 map_, normals_map_;
    bool keeps_lengths_ = true, mirrors_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI
