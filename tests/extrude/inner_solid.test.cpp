// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/inner_solid.hpp>

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/extrude/flat.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "capped.hpp"
#include "support/catch.hpp"

using namespace typemesh;

namespace {

/// The loops of a shape, as an extruder would have made them.
template <class E>
void take_loops(const shapes::shape& s, inner_solid<E>& to)
{
    to.loops.grid = s.loops.grid;
    to.loops.curves = s.curves;
    REQUIRE(to.loops.points.append(s.loops.points.view()));
    REQUIRE(to.loops.edges.append(s.loops.edges.view()));
    REQUIRE(to.loops.starts.append(s.loops.starts.view()));
}

template <class T>
bool same_values(array_view<const T> a, array_view<const T> b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

/// Plans a ring by `how`, and compares what is read from the solid itself and from a copy of its bytes.
template <class E>
void check_round_trip(const E& how)
{
    const auto other = shapes::rectangle(), ring = shapes::ring(8);
    meshes::caps_by<> caps{other.made()};
    auto maker = caps.maker();
    inner_solid<E> inner;
    take_loops(ring, inner);
    const auto filled = inner.fill(maker);
    REQUIRE(filled);
    const auto plan = inner.plan(how, *filled, maker);
    REQUIRE(plan);
    CHECK(plan->around.low == point{100.0 * 512.0, 0.0});
    CHECK(plan->around.high == point{700.0 * 512.0, 600.0 * 512.0});

    std::vector<std::uint64_t> block(inner.bytes() / 8 + 1, 0xABCD);
    REQUIRE(inner.bytes() % 8 == 0);
    inner.copy_to(reinterpret_cast<std::byte*>(block.data()));
    CHECK(block.back() == 0xABCD);
    const auto own = inner.read(), copied = inner_solid<E>::read_from(reinterpret_cast<const std::byte*>(block.data()));
    CHECK(same_values(own.points, copied.points));
    CHECK(same_values(own.starts, copied.starts));
    CHECK(same_values(own.triangles, copied.triangles));
    CHECK(own.triangles.size() == filled->triangle_count());

    meshes::mesh<> from_own, from_copy;
    REQUIRE(write_solid<E>({own, *plan}, how, meshes::in_em(), from_own));
    REQUIRE(write_solid<E>({copied, *plan}, how, meshes::in_em(), from_copy));
    meshes::check_same(from_own, from_copy);

    inner.clear();
    CHECK(inner.read().points.empty());
    const auto empty = inner.plan(how, region{}, maker);
    REQUIRE(empty);
    CHECK(empty->sizes.total() == mesh_size{});
}

}  // namespace

TEST_CASE("an inner solid is planned for its own region, and a copy of its bytes is the same solid", "[inner_solid]")
{
    SECTION("of flat, which has no plan data") { check_round_trip(flat{}); }
    SECTION("of extruded") { check_round_trip(extruded<>{}); }
    SECTION("of bevelled, which asks for caps") { check_round_trip(bevelled{}); }
}
