// SPDX-License-Identifier: MIT

#include <typemesh/extrude/extrude.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/flat.hpp>

#include "mesh.hpp"
#include "support/catch.hpp"

using namespace typemesh;

namespace {

/// All but plan().
struct rest {
    height_range heights() const noexcept { return {}; }
    template <attribute Wants, class Emit>
    void vertices(part, const solid&, const placement&, Emit&&) const noexcept
    {
    }
    template <class Emit>
    void triangles(part, const solid&, const first_vertices&, Emit&&) const noexcept
    {
    }
};

struct plain : rest {
    result<part_sizes> plan(const region&) const noexcept { return part_sizes{}; }
};
struct with_box : rest {
    result<solid_plan> plan(const region&) const noexcept { return solid_plan{{}, {{-1.0, -2.0}, {3.0, 4.0}}}; }
};
struct with_data : rest {
    using plan_data = plan_arrays<float>;
    result<part_sizes> plan(const region&, plan_data& data) const noexcept
    {
        if (!data.of<float>().push_back(1.5f)) return error::out_of_memory;
        return part_sizes{};
    }
};
struct with_caps : rest {
    using plan_data = plan_arrays<triangle>;
    static constexpr std::size_t part_count = 8;
    template <cap_maker Caps>
    result<part_sizes> plan(const region& r, plan_data& data, Caps& caps) const noexcept
    {
        if (error e = caps(r, data.of<triangle>())) return e;
        part_sizes sizes;
        sizes.triangles.of[7] = static_cast<std::uint32_t>(data.of<triangle>().size());
        return sizes;
    }
};
struct of_nine_parts : plain {
    static constexpr std::size_t part_count = 9;
};
struct of_no_parts : plain {
    static constexpr std::size_t part_count = 0;
};
struct asks_for_sides : rest {
    result<part_sizes> plan(const region&, buffer<side_point>&) const noexcept { return part_sizes{}; }
};
struct may_throw : rest {
    result<part_sizes> plan(const region&) const { return part_sizes{}; }
};

/// Gives each region one triangle.
struct one_triangle : no_caps {
    int asked = 0;
    error operator()(const region&, triangle_list& out) noexcept
    {
        ++asked;
        return out.push_back({0, 1, 2}) ? error{} : error{error::out_of_memory};
    }
};

}  // namespace

static_assert(extruder<plain> && extruder<with_box> && extruder<with_data> && extruder<with_caps>);
static_assert(!extruder<rest> && !extruder<of_nine_parts> && !extruder<of_no_parts>);
static_assert(!extruder<asks_for_sides> && !extruder<may_throw>);
static_assert(capping_extruder<with_caps> && !capping_extruder<with_data> && !capping_extruder<plain>);
static_assert(cap_maker<one_triangle> && !cap_maker<rest>);
static_assert(has_hard_edges<extruded<>> && !has_hard_edges<flat>);
static_assert(part_count_of<flat> == 3 && part_count_of<with_caps> == 8);

TEST_CASE("an extruder is planned by the parameters that its plan() takes", "[extrude]")
{
    one_triangle caps;
    const region empty;
    detail::no_plan_data none;
    CHECK(plan_solid(plain{}, empty, none, caps)->around.empty());
    CHECK(plan_solid(with_box{}, empty, none, caps)->around.high == point{3.0, 4.0});
    with_data::plan_data numbers;
    CHECK(plan_solid(with_data{}, empty, numbers, caps));
    CHECK(numbers.of<float>().size() == 1);
    CHECK(caps.asked == 0);
    with_caps::plan_data triangles;
    const auto capped = plan_solid(with_caps{}, empty, triangles, caps);
    REQUIRE(capped);
    CHECK(caps.asked == 1);
    CHECK(capped->sizes.triangles.of[7] == 1);
    CHECK(capped->sizes.total().triangles == 1);
    CHECK_FALSE(refused_options(with_caps{}));
    CHECK(refused_options(extruded<>{.depth = -1.0f}) == error::bad_option);
}

TEST_CASE("the parts of an extruder are the first ones", "[extrude]")
{
    CHECK(parts_of<flat>.size() == 3);
    CHECK(parts_of<flat>.back() == part::side);
    CHECK(parts_of<with_caps>.size() == max_parts);
    for (std::size_t p = 0; p < max_parts; ++p) CHECK(parts_of<with_caps>[p] == part{static_cast<std::uint8_t>(p)});
}

TEST_CASE("extrude() writes the same mesh without the caller's plan data", "[extrude]")
{
    const auto s = shapes::letter_d();
    meshes::mesh<> without_scratch, with_scratch;
    extruded<>::plan_data data;
    REQUIRE(extrude(s.made(), s.cap, extruded<>{}, meshes::in_em(), data, with_scratch));
    REQUIRE(extrude(s.made(), s.cap, extruded<>{}, meshes::in_em(), without_scratch));
    meshes::check_same(without_scratch, with_scratch);
}
