// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/vertex/affine3.hpp>
#include <typemesh/vertex/bounds3.hpp>
#include <typemesh/vertex/surface_point.hpp>

#include <cmath>
#include <cstdint>
#include <limits>

namespace typemesh::inline TYPEMESH_ABI {

/// An affine map, prepared for many surface points: positions, normals (by the inverse transpose), tangents and the
/// order of a triangle's corners. The identity changes no bit.
///
/// The factors are floats, so their products are exact in double precision, and no result depends on whether a compiler
/// fuses products and sums.
class letter_move {
public:
    letter_move() noexcept = default;
    explicit letter_move(const affine3& map) noexcept : map_{map}
    {
        const bool straight =
            map.x == vec3{1.0f, 0.0f, 0.0f} && map.y == vec3{0.0f, 1.0f, 0.0f} && map.z == vec3{0.0f, 0.0f, 1.0f};
        if (straight) {
            how_ = map.origin == vec3{} ? kind::as_it_is : kind::shift;
            return;
        }
        find_normals();
    }

    [[nodiscard]] const affine3& map() const noexcept { return map_; }
    /// Whether it is the identity.
    [[nodiscard]] bool is_identity() const noexcept { return how_ == kind::as_it_is; }
    /// Whether two corners of each triangle must be swapped.
    [[nodiscard]] bool mirrors() const noexcept { return mirrors_; }

    /// Moves the attributes that the point has. Texture coordinates and letter data stay.
    template <attribute Wants>
    void operator()(surface_point<Wants>& s) const noexcept
    {
        if (how_ == kind::shift) {
            if constexpr (has(Wants, attribute::position))
                s.position = {s.position.x + map_.origin.x, s.position.y + map_.origin.y, s.position.z + map_.origin.z};
            return;
        }
        if constexpr (has(Wants, attribute::position)) s.position = map_(s.position);
        if constexpr (has(Wants, attribute::normal)) s.normal = normal(s.normal);
        if constexpr (has(Wants, attribute::tangent)) {
            const vec3 t =
                unit(map_.direction({s.tangent.x, s.tangent.y, s.tangent.z}), {s.tangent.x, s.tangent.y, s.tangent.z});
            s.tangent = {t.x, t.y, t.z, mirrors_ ? -s.tangent.w : s.tangent.w};
        }
    }

    /// The box of everything in a box, after the move; larger by at most a float's step on each side.
    [[nodiscard]] bounds3 operator()(const bounds3& b) const noexcept
    {
        if (is_identity()) return b;
        const vec3 first = moved(b.low);
        bounds3 all{first, first};
        for (unsigned corner = 1; corner < 8; ++corner)
            all.add(moved({(corner & 1) != 0 ? b.high.x : b.low.x, (corner & 2) != 0 ? b.high.y : b.low.y,
                           (corner & 4) != 0 ? b.high.z : b.low.z}));
        constexpr float most = (std::numeric_limits<float>::max)();
        all.low = {std::nextafter(all.low.x, -most), std::nextafter(all.low.y, -most),
                   std::nextafter(all.low.z, -most)};
        all.high = {std::nextafter(all.high.x, most), std::nextafter(all.high.y, most),
                    std::nextafter(all.high.z, most)};
        return all;
    }

private:
    enum class kind : std::uint8_t { as_it_is, shift, similar, any };

    [[nodiscard]] vec3 moved(vec3 p) const noexcept
    {
        surface_point<attribute::position> s;
        s.position = p;
        (*this)(s);
        return s.position;
    }

    /// The direction of a vector; `otherwise` if it has none.
    [[nodiscard]] static vec3 unit(vec3 v, vec3 otherwise) noexcept
    {
        const double x = as_double(v.x), y = as_double(v.y), z = as_double(v.z);
        const double length = std::sqrt(x * x + y * y + z * z);
        if (!(length > 0.0)) return otherwise;
        return {static_cast<float>(x / length), static_cast<float>(y / length), static_cast<float>(z / length)};
    }

    [[nodiscard]] vec3 normal(vec3 n) const noexcept
    {
        const vec3 image = normals_.direction(n);
        return how_ == kind::similar ? image : unit(image, n);
    }

    /// Finds the map of normals: the map's cofactors, with the sign of its determinant. If the map only turns, mirrors
    /// and scales, these need no square root for each normal: they are then divided by their length here, and a
    /// normal's length is 1 up to 2^-20.
    void find_normals() noexcept
    {
        struct column {
            double x, y, z;
        };
        const auto of = [](vec3 v) noexcept { return column{as_double(v.x), as_double(v.y), as_double(v.z)}; };
        const auto cross = [](const column& a, const column& b) noexcept {
            return column{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
        };
        const auto dot = [](const column& a, const column& b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; };
        const column x = of(map_.x), y = of(map_.y), z = of(map_.z);
        const column c[] = {cross(y, z), cross(z, x), cross(x, y)};
        const double determinant = dot(x, c[0]);
        mirrors_ = determinant < 0.0;

        const double xx = dot(x, x), allowed = 0x1p-20 * xx;
        const auto is = [allowed](double value, double wanted) noexcept {
            return std::fabs(value - wanted) <= allowed;
        };
        const bool turns = xx > 0.0 && is(dot(y, y), xx) && is(dot(z, z), xx) && is(dot(x, y), 0.0) &&
                           is(dot(y, z), 0.0) && is(dot(z, x), 0.0);
        how_ = turns ? kind::similar : kind::any;

        double length = turns ? xx : 0.0;
        if (!turns)
            for (const column& one : c)
                for (const double v : {one.x, one.y, one.z}) length = std::fmax(length, std::fabs(v));
        if (!(length > 0.0)) {  // all that it maps lies on one line
            normals_ = {};
            return;
        }
        const double by = (mirrors_ ? -1.0 : 1.0) / length;
        const auto rounded = [by](const column& a) noexcept {
            return vec3{static_cast<float>(a.x * by), static_cast<float>(a.y * by), static_cast<float>(a.z * by)};
        };
        normals_ = {rounded(c[0]), rounded(c[1]), rounded(c[2]), {}};
    }

    affine3 map_ = {};
    affine3 normals_ = {};
    kind how_ = kind::as_it_is;
    bool mirrors_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI
