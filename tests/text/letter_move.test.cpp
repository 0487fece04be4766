// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/text/impl/letter_move.hpp>

#include <cmath>
#include <cstring>

using namespace typemesh;

namespace {

constexpr attribute lit = attribute::position | attribute::normal | attribute::tangent;

double product(vec3 a, vec3 b) { return double(a.x) * b.x + double(a.y) * b.y + double(a.z) * b.z; }
vec3 minus(vec3 a, vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

/// One moved point.
template <attribute Wants>
surface_point<Wants> moved(const letter_move& move, const surface_point<Wants>& s)
{
    point_mover<Wants> points;
    points.start(move, move.map());
    CHECK_FALSE(points.take(s));
    surface_point<Wants> out;
    points.give([&out](const surface_point<Wants>& p) { out = p; });
    return out;
}

/// A turn, a mirror image, a stretch and a shear.
const affine3 maps[] = {turned({0.6f, 0.0f, 0.8f}, 1.0),
                        scaled(-2.0f),
                        {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {5, 6, 7}},
                        {{3, 0, 0}, {0, 1, 0}, {0, 0, 0.25f}, {}},
                        {{1, 0, 0}, {0.5f, 1, 0}, {0.25f, -0.5f, -1}, {0, 1, 0}}};

}  // namespace

TEST_CASE("a moved normal has unit length, stands on the moved plane and stays outside", "[letters]")
{
    const vec3 a{1, 2, 3}, u{2.0f / 3, -1.0f / 3, 2.0f / 3}, v{-1.0f / 3, 2.0f / 3, 2.0f / 3};
    const vec3 n{-2.0f / 3, -2.0f / 3, 1.0f / 3};
    for (const affine3& map : maps) {
        const letter_move move{map};
        surface_point<lit> s;
        s.position = a;
        s.normal = n;
        s.tangent = {u.x, u.y, u.z, 1.0f};
        s = moved(move, s);
        const vec3 off = minus(s.position, map(a));
        CHECK(product(off, off) < 1e-11);
        CHECK(product(s.normal, s.normal) == Catch::Approx(1.0).epsilon(2e-6));
        CHECK(product(s.normal, map.direction(u)) == Catch::Approx(0.0).margin(1e-5));
        CHECK(product(s.normal, map.direction(v)) == Catch::Approx(0.0).margin(1e-5));
        CHECK(product(s.normal, map.direction(n)) > 0.0);
        const vec3 t{s.tangent.x, s.tangent.y, s.tangent.z};
        CHECK(product(t, t) == Catch::Approx(1.0).epsilon(2e-6));
        CHECK(product(t, map.direction(u)) > 0.0);
        CHECK(product(t, s.normal) == Catch::Approx(0.0).margin(1e-5));
        CHECK((s.tangent.w < 0.0f) == move.mirrors());
    }
    CHECK_FALSE(letter_move{maps[0]}.mirrors());
    CHECK(letter_move{maps[1]}.mirrors());
    CHECK(letter_move{maps[2]}.mirrors());
}

TEST_CASE("the identity changes no bit, and a flat map still gives unit normals", "[letters]")
{
    surface_point<lit> s;
    s.position = {-0.0f, 1.0f, -0.0f};
    s.normal = {-0.0f, -0.0f, -1.0f};
    const letter_move same{affine3{}};
    CHECK(same.is_identity());
    CHECK_FALSE(letter_move{shifted({0, 0, 1})}.is_identity());
    CHECK_FALSE(letter_move{scaled(0.5f)}.is_identity());

    const letter_move flat{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {}}};
    surface_point<lit> wall = s;
    wall.normal = {1, 0, 0};
    s = moved(flat, s);
    CHECK(s.normal == vec3{0, 0, -1});
    wall = moved(flat, wall);
    CHECK(product(wall.normal, wall.normal) == Catch::Approx(1.0));
    surface_point<lit> gone = s;
    gone = moved(letter_move{affine3{{}, {}, {}, {4, 5, 6}}}, gone);
    CHECK(gone.position == vec3{4, 5, 6});
    CHECK(product(gone.normal, gone.normal) == Catch::Approx(1.0));
}

TEST_CASE("a moved box holds every moved point, and not much more", "[letters]")
{
    const bounds3 box{{-1, 2, -0.3f}, {0.5f, 2.7f, 0}};
    for (const affine3& map : maps) {
        const bounds3 image = letter_move{map}(box);
        bounds3 seen{map(box.low), map(box.low)};
        for (int i = 0; i < 1000; ++i) {
            const auto at = [](int k, float low, float high) { return low + (high - low) * static_cast<float>(k) / 9; };
            surface_point<attribute::position> s;
            s.position = {at(i % 10, box.low.x, box.high.x), at(i / 10 % 10, box.low.y, box.high.y),
                          at(i / 100, box.low.z, box.high.z)};
            s = moved(letter_move{map}, s);
            CHECK(image.holds(s.position));
            seen.add(s.position);
        }
        const vec3 low = minus(seen.low, image.low), high = minus(image.high, seen.high);
        for (const float gap : {low.x, low.y, low.z, high.x, high.y, high.z}) CHECK(gap < 1e-5f);
    }
    CHECK(letter_move{}(box).low == box.low);
}
