// SPDX-License-Identifier: MIT
//
// Sizes and depths at the limits of what a 32-bit float holds.

#include "support/catch.hpp"
#include "support/mesh_laws.hpp"
#include "support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

constexpr float largest_float = (std::numeric_limits<float>::max)(),
                least_float = std::numeric_limits<float>::denorm_min();

/// A user's extruder: the front cap alone, at a height that its heights() tells.
struct lifted : flat {
    double at_height = 0.0;

    [[nodiscard]] height_range heights() const noexcept { return {0.0, at_height}; }

    template <attribute Wants, class Put>
    void vertices(part p, const solid& s, const placement& at, Put&& put) const noexcept
    {
        if (p != part::front) return;
        for (std::size_t i = 0; i < s.points.size(); ++i) {
            surface_point<Wants> v;
            const double height = i == 0 ? 0.0 : at_height;
            if constexpr (has(Wants, attribute::position)) v.position = at.position(s.points[i], at.height(height));
            put(v);
        }
    }
    [[nodiscard]] option_bits cache_key() const noexcept { return {at_height}; }
};
static_assert(extruder<lifted>);

/// Whether a mesh is whole: every number finite, letters as wide and as high as they are, front and back apart.
std::string mistake_in(const std::vector<test::full_vertex>& vertices, const frame& f, bool deep)
{
    struct extent {
        vec3 axis;
        double low = 1e300, high = -1e300;

        void add(vec3 p) noexcept
        {
            const double along = test::dot(axis, p);
            low = (std::min)(low, along), high = (std::max)(high, along);
        }
        [[nodiscard]] double size() const noexcept { return high - low; }
    } across{f.right}, up{f.up}, through{f.toward};
    for (const test::full_vertex& v : vertices) {
        for (const float number : {v.position.x, v.position.y, v.position.z})
            if (!is_finite(as_double(number))) return "a position is not finite";
        for (const float number : {v.normal.x, v.normal.y, v.normal.z, v.uv.x, v.uv.y})
            if (!is_finite(as_double(number))) return "a normal or a texture coordinate is not finite";
        for (extent* e : {&across, &up, &through}) e->add(v.position);
    }
    // The glyphs "oE" of the toy font: 1050 units wide, 700 high.
    if (!(std::abs(across.size() / up.size() - 1.5) < 1e-5)) return "letters have lost their shape";
    if (deep && !(through.size() > 0.0)) return "front and back lie in one plane";
    return "";
}

template <class Mesher>
void is_whole_or_refused(Mesher mesher, const text_options& options, bool deep, const std::string& depths_name)
{
    auto plan = mesher.plan("oE", options);
    if (!plan) {
        const error e = plan.error();
        REQUIRE(e == error::bad_option);
        const std::string named = e.option;
        CHECK((named == "size" || named == depths_name));
        char words[200];
        CHECK(std::string{describe(e, words)}.find(named) != std::string::npos);
        return;
    }
    std::vector<test::full_vertex> vertices;
    std::vector<std::uint32_t> indices;
    REQUIRE(plan->write(into(vertices, indices)));
    CHECK(mistake_in(vertices, options.frame, deep) == "");
    const bounds3 b = plan->bounds();
    for (const float f : {b.low.x, b.low.y, b.low.z, b.high.x, b.high.y, b.high.z}) CHECK(is_finite(as_double(f)));
    CHECK(is_finite(plan->position_step()));
    plan->write_instances([](const glyph_instance& i) noexcept { CHECK(is_finite(as_double(i.translation.x))); });
}

}  // namespace

TEST_CASE("whatever size and depth, a mesh is finite and whole, or the option is named that prevents it", "[text]")
{
    test::toy_font font;
    const double s = 0.70710678118654752;
    const frame leaning{.right = {float(s), float(s), 0.0f}, .up = {float(-s), float(s), 0.0f}};
    for (const output_unit unit :
         {output_unit::em, output_unit::font_units, output_unit::pixels, output_unit::unit_box})
        for (const double size : {5e-324, 1e-300, 1e-45, 1e-38, 1e-31, 1e-20, 1.0, 1e9, 0x1p30})
            for (const frame& f : {right_handed_y_up, left_handed_z_up, leaning}) {
                const text_options options{.unit = unit, .size = size, .pixels_per_em = 1.0, .frame = f};
                INFO("unit " << int(unit) << ", size " << size);
                is_whole_or_refused(text_mesher{font}.with(flat{}), options, false, "");
                for (const float depth : {least_float, 1e-38f, 1e-20f, 1.0f, 1e20f, 1e30f, 3e38f, largest_float})
                    for (const bool centred : {false, true}) {
                        INFO("depth " << depth);
                        const extruded<> raised{.depth = depth, .centred = centred};
                        is_whole_or_refused(text_mesher{font}.with(raised), options, true, "depth");
                    }
                for (const double height : {1e-320, 1e-38, 1.0, 1e38, 1e39, 1e300, -1e300}) {
                    INFO("height " << height);
                    is_whole_or_refused(text_mesher{font}.with(lifted{{}, height}), options, true, "heights");
                }
            }
}

TEST_CASE("sizes and depths within reason are never refused", "[text]")
{
    test::toy_font font;
    for (const output_unit unit :
         {output_unit::em, output_unit::font_units, output_unit::pixels, output_unit::unit_box})
        for (const double size : {1e-20, 1e-6, 1.0, 1e6})
            for (const float depth : {1e-6f, 0.2f, 1e6f}) {
                text_mesher mesher = text_mesher{font}.with(extruded<>{.depth = depth});
                CHECK(mesher.plan("oE", {.unit = unit, .size = size}));
            }
}

TEST_CASE("depths in output units are written as they are, whatever the unit and the size", "[text]")
{
    test::toy_font font;
    for (const output_unit unit :
         {output_unit::em, output_unit::font_units, output_unit::pixels, output_unit::unit_box})
        for (const double size : {0.37, 1.0, 7.0})
            for (const float depth : {0.1f, 1.0f, 3.5f}) {
                text_mesher mesher = text_mesher{font}.with(extruded<>{.depth = depth, .texture = texture_mapping::em});
                const auto plan = mesher.plan("oE", {.unit = unit, .size = size, .depth_in = depth_unit::output});
                REQUIRE(plan);
                CHECK(plan->bounds().low.z == -depth);
                CHECK(plan->bounds().high.z == 0.0f);
                std::vector<test::full_vertex> vertices;
                std::vector<std::uint32_t> indices;
                REQUIRE(plan->write(into(vertices, indices)));
                CHECK(vertices[plan->range(part::back).first_vertex].position.z == -depth);
                // Textures are measured in em on all sides: u grows along a wall as fast as v along the depth.
                const mesh_range walls = plan->range(part::side);
                const auto* first = &vertices[walls.first_vertex + 2];  // its seam's second pair, then the next point's
                const test::full_vertex &a = first[0], &b = first[1], &c = first[2];
                const double along = std::sqrt(
                    test::dot(test::subtract(c.position, a.position), test::subtract(c.position, a.position)));
                const double of_u = std::abs(as_double(c.uv.x) - as_double(a.uv.x)) / along,
                             of_v = std::abs(as_double(b.uv.y) - as_double(a.uv.y)) / as_double(depth);
                CHECK(of_u == Catch::Approx(of_v).epsilon(1e-3).margin(1e-6));
            }
}

TEST_CASE("a depth whose halves fit into floats and whose whole does not is refused for its texture coordinates",
          "[text]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(extruded<>{.depth = 3e38f, .centred = true});
    const auto made = mesher.plan("ooooooo", {.unit = output_unit::unit_box, .depth_in = depth_unit::output});
    REQUIRE_FALSE(made);
    CHECK(made.error().code == error::bad_option);
    CHECK(std::string{made.error().option} == "depth");
}

TEST_CASE("heights that are no numbers are refused", "[text]")
{
    test::toy_font font;
    for (const double height : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        text_mesher mesher = text_mesher{font}.with(lifted{{}, height});
        CHECK(mesher.plan("oE").error() == error::bad_option);
    }
}
