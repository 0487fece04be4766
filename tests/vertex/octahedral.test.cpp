// SPDX-License-Identifier: MIT

#include <typemesh/vertex/octahedral.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "directions.hpp"
#include "support/catch.hpp"

using namespace typemesh;
using test::degrees_between;
using test::directions;

namespace {

template <class Packed>
double worst(int n)
{
    double most = 0.0;
    for (const vec3 v : directions(n)) {
        const vec3 d = Packed{v.x, v.y, v.z}.decoded();
        most = (std::max)(most, degrees_between(v, d));
        if (std::abs(degrees_between(d, d)) > 0.0 ||
            std::abs(std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z) - 1.0f) > 1e-6f)
            FAIL("not of unit length");
    }
    return most;
}

}  // namespace

TEST_CASE("octahedral vectors keep their error bounds", "[vertex]")
{
    const double in_two_bytes = worst<octahedral16>(400'000), in_four = worst<octahedral32>(400'000);
    INFO(in_two_bytes << " and " << in_four << " degrees");
    CHECK(in_two_bytes < 0.64);
    CHECK(in_four < 0.0025);
}

TEST_CASE("no pattern of an octahedral vector is clearly closer than the chosen one", "[vertex]")
{
    for (const vec3 v : directions(60)) {
        const double chosen = degrees_between(octahedral16{v.x, v.y, v.z}.decoded(), v);
        double closest = 180.0;
        for (int x = -127; x <= 127; ++x)
            for (int y = -127; y <= 127; ++y) {
                octahedral16 o;
                o.x = snorm8::from_bits(static_cast<std::int8_t>(x));
                o.y = snorm8::from_bits(static_cast<std::int8_t>(y));
                closest = (std::min)(closest, degrees_between(o.decoded(), v));
            }
        INFO(v.x << ' ' << v.y << ' ' << v.z);
        CHECK(chosen <= closest * 1.06 + 1e-5);  // the four around it, not all: as the paper has it
    }
}

TEST_CASE("octahedral vectors store the axes exactly", "[vertex]")
{
    for (const vec3 v : {vec3{1, 0, 0}, vec3{-1, 0, 0}, vec3{0, 1, 0}, vec3{0, -1, 0}, vec3{0, 0, 1}, vec3{0, 0, -1}}) {
        CHECK(octahedral16{v.x, v.y, v.z}.decoded() == v);
        CHECK(octahedral32{v.x, v.y, v.z}.decoded() == v);
        CHECK(octahedral32{7.0f * v.x, 7.0f * v.y, 7.0f * v.z}.decoded() == v);
    }
}

TEST_CASE("every pattern of two bytes is decoded and encoded to the same vector", "[vertex]")
{
    for (int x = -127; x <= 127; ++x)
        for (int y = -127; y <= 127; ++y) {
            octahedral16 o;
            o.x = snorm8::from_bits(static_cast<std::int8_t>(x));
            o.y = snorm8::from_bits(static_cast<std::int8_t>(y));
            const vec3 v = o.decoded();
            if (degrees_between(octahedral16{v.x, v.y, v.z}.decoded(), v) > 1e-4) FAIL(x << ", " << y);
        }
    SUCCEED();
}
