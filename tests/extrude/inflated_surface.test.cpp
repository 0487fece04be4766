// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/inflated_surface.hpp>

#include "support/catch.hpp"

#include <cmath>

using namespace typemesh;

TEST_CASE("a limit flattens high membranes and leaves low ones, and is never reached", "[extrude]")
{
    const inflated_surface round{.height = 2.0f, .limit = 0.0f, .depth = 0.1f},
        pillow{.height = 2.0f, .limit = 0.1f, .depth = 0.1f};
    double before = 0.0;
    for (const float membrane : {0.0001f, 0.001f, 0.01f, 0.1f, 1.0f, 10.0f}) {
        CAPTURE(membrane);
        CHECK(round.raised(membrane) == Catch::Approx(2.0 * double{membrane}));
        const double z = pillow.raised(membrane);
        CHECK(z > before);
        CHECK(z < 0.1);
        if (membrane < 0.002f) CHECK(z == Catch::Approx(2.0 * double{membrane}).epsilon(0.001));
        before = z;
    }
    CHECK(before > 0.0999);
}

TEST_CASE("an inflated surface has the normals that its heights ask for", "[extrude]")
{
    // The membrane over a strip, along x: u = x (w - x) / 2.
    const double w = 0.2, x = 0.03, step = 1e-4;
    for (const float limit : {0.0f, 0.05f, 0.5f}) {
        for (const float height : {0.5f, 1.0f, 3.0f}) {
            CAPTURE(limit, height);
            const inflated_surface how{.height = height, .limit = limit, .depth = 0.1f};
            const auto membrane = [&](double at) { return static_cast<float>(std::sqrt(at * (w - at))); };
            inflated_surface::plan_data data;
            const grid_point place{0, 0};
            REQUIRE(data.of<membrane_point>().push_back({membrane(x), {static_cast<float>(0.5 * w - x), 0.0f}}));
            REQUIRE(data.of<membrane_lean>().push_back({}));
            solid_with<inflated_surface::plan_data> s{{{&place, 1}, {}, {}}, data.read()};
            placement at;
            at.unit_per_cell = at.em_per_cell = 1.0 / 1024.0;
            for (const part p : {part::front, part::back}) {
                int calls = 0;
                how.vertices<attribute::normal | attribute::position>(p, s, at, [&](const auto& v) noexcept {
                    ++calls;
                    const double rise =
                                     (how.raised(membrane(x + step)) - how.raised(membrane(x - step))) / (2.0 * step),
                                 length = std::sqrt(1.0 + rise * rise), facing = p == part::front ? 1.0 : -1.0;
                    CHECK(double{v.normal.x} == Catch::Approx(-rise / length).epsilon(1e-3));
                    CHECK(double{v.normal.z} == Catch::Approx(facing / length).epsilon(1e-3));
                    CHECK(double{v.position.z} == Catch::Approx(facing * how.raised(membrane(x))));
                });
                CHECK(calls == 1);
            }
        }
    }
}

TEST_CASE("a normal that would lie behind a triangle leans half as far as it may, and others are not changed",
          "[extrude]")
{
    // A point at the height 0.05, whose slope points along x, and a triangle that falls there by 0.2, 2 or 4.
    for (const float fall : {0.2f, 2.0f, 4.0f}) {
        for (const float limit : {0.0f, 0.05f}) {
            CAPTURE(fall, limit);
            const inflated_surface how{.height = 1.0f, .limit = limit, .depth = 0.1f};
            inflated_surface::plan_data data;
            const grid_point place{0, 0};
            REQUIRE(data.of<membrane_point>().push_back({0.05f, {0.05f, 0.0f}}));
            REQUIRE(data.of<membrane_lean>().push_back({-0.05f * fall}));
            solid_with<inflated_surface::plan_data> s{{{&place, 1}, {}, {}}, data.read()};
            placement at;
            at.unit_per_cell = at.em_per_cell = 1.0 / 1024.0;
            for (const part p : {part::front, part::back}) {
                how.vertices<attribute::normal>(p, s, at, [&](const auto& v) noexcept {
                    const double facing = p == part::front ? 1.0 : -1.0, shown = as_double(v.normal.z) * facing,
                                 steepness = limit > 0.0f ? std::sqrt(0.125) : 1.0,
                                 front = as_double(v.normal.x) * as_double(fall) + shown;
                    if (steepness * as_double(fall) < 1.0)
                        CHECK(as_double(v.normal.x) / shown == Catch::Approx(-steepness));
                    else
                        CHECK(front == Catch::Approx(0.5 * shown));
                    CHECK(front > 0.0);
                });
            }
        }
    }
}
