// SPDX-License-Identifier: MIT
//
// No option is forgotten in a key: each member of an extruder is either planned, and then another value of it is another
// key, or only written, and then the key is the same and the mesh is not. A member that stands in no list fails to compile.
#include "support/catch.hpp"
#include "support/lit_mesh.hpp"
#include "support/toy_font.hpp"

#include <typemesh/extrude/averaged_normals.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/cap_normals.hpp>
#include <typemesh/extrude/creased_normals.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/extrude/shared_normals.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <vector>

using namespace typemesh;

namespace {

/// Converts to a value of any type, where only the type matters.
struct any_value {
    template <class T>
    operator T() const noexcept;  // NOLINT: implicit, never defined
};

/// The number of members of an aggregate: the largest number of initial values.
template <class T, class... Values>
constexpr std::size_t member_count(Values... values)
{
    if constexpr (requires { T{values..., any_value{}}; })
        return member_count<T>(values..., any_value{});
    else
        return sizeof...(values);
}

enum class seen_by { plan, writing };

/// Another value of one member.
template <class Solid>
struct option_change {
    const char* member;
    seen_by who;
    void (*make)(Solid&);
};

template <class Solid>
test::lit_mesh mesh_with(const Solid& how)
{
    test::toy_font font;
    text_mesher mesher{font, how};
    const auto plan = mesher.plan("oE");
    REQUIRE(plan);
    return test::written(*plan);
}

template <class Solid, std::size_t N>
void check_keys(const option_change<Solid> (&all)[N])
{
    static_assert(N == member_count<Solid>(), "each member stands in the list once");
    const Solid plain;
    const test::lit_mesh mesh = mesh_with(plain);
    std::vector<option_bits> keys{plain.cache_key()};
    for (const auto& [member, who, make] : all) {
        INFO(member);
        Solid changed;
        make(changed);
        if (who == seen_by::writing) {
            CHECK(changed.cache_key() == plain.cache_key());
            CHECK_FALSE(mesh_with(changed) == mesh);
            continue;
        }
        for (const option_bits& other : keys) CHECK_FALSE(changed.cache_key() == other);
        keys.push_back(changed.cache_key());
    }
}

/// Those of all extruded solids; `normals` changes the member of this name.
template <class Normals>
void check_extruded(void (*normals)(extruded<Normals>&))
{
    using solid = extruded<Normals>;
    check_keys<solid>({{"depth", seen_by::writing, [](solid& s) { s.depth = 0.3f; }},
                       {"centred", seen_by::writing, [](solid& s) { s.centred = true; }},
                       {"front", seen_by::plan, [](solid& s) { s.front = false; }},
                       {"back", seen_by::plan, [](solid& s) { s.back = false; }},
                       {"side", seen_by::plan, [](solid& s) { s.side = false; }},
                       {"texture", seen_by::plan, [](solid& s) { s.texture = texture_mapping::box; }},
                       {"normals", seen_by::plan, normals},
                       {"segments", seen_by::plan, [](solid& s) { s.segments = 2; }}});
}

}  // namespace

static_assert(member_count<flat>() == 1 && member_count<shared_normals>() == 0);
static_assert(member_count<averaged_normals>() == 0 && member_count<cap_normals>() == 0);
static_assert(member_count<curve_normals>() == 1 && member_count<creased_normals>() == 1);

TEST_CASE("every option of flat and extruded is in the key, or changes the mesh with the same key", "[option_keys]")
{
    check_keys<flat>({{"texture", seen_by::writing, [](flat& s) { s.texture = texture_mapping::box; }}});
    check_extruded<curve_normals>([](extruded<>& s) { s.normals.crease_degrees = 20.0f; });
    check_extruded<creased_normals>([](extruded<creased_normals>& s) { s.normals.crease_degrees = 20.0f; });
}

TEST_CASE("every option of bevelled is in the key, or changes the mesh with the same key", "[option_keys]")
{
    check_keys<bevelled>(
        {{"depth", seen_by::writing, [](bevelled& s) { s.depth = 0.3f; }},
         {"width", seen_by::plan, [](bevelled& s) { s.width = 0.03f; }},
         {"bevel_depth", seen_by::plan, [](bevelled& s) { s.bevel_depth = 0.03f; }},
         {"sides", seen_by::plan, [](bevelled& s) { s.sides = bevel_sides::back; }},
         {"mode", seen_by::plan, [](bevelled& s) { s.mode = bevel_mode::fit; }},
         {"outward", seen_by::plan, [](bevelled& s) { s.outward = true; }},
         {"joins", seen_by::plan, [](bevelled& s) { s.joins = bevel_joins::bevelled; }},
         {"shading", seen_by::plan, [](bevelled& s) { s.shading = bevel_shading::rounded; }},
         {"mitre_limit", seen_by::plan, [](bevelled& s) { s.mitre_limit = 3.0f; }},
         {"crease_degrees", seen_by::plan, [](bevelled& s) { s.crease_degrees = 20.0f; }},
         {"profile_crease_degrees", seen_by::plan, [](bevelled& s) { s.profile_crease_degrees = 20.0f; }},
         {"centred", seen_by::writing, [](bevelled& s) { s.centred = true; }},
         {"standing", seen_by::writing, [](bevelled& s) { s.standing = true; }},
         {"front", seen_by::plan, [](bevelled& s) { s.front = false; }},
         {"back", seen_by::plan, [](bevelled& s) { s.back = false; }},
         {"side", seen_by::plan, [](bevelled& s) { s.side = false; }},
         {"texture", seen_by::plan, [](bevelled& s) { s.texture = texture_mapping::box; }},
         {"profile", seen_by::plan, [](bevelled& s) { s.profile = round_profile(); }},
         {"segments", seen_by::plan, [](bevelled& s) { s.segments = 2; }},
         {"wanted", seen_by::plan, [](bevelled& s) { s.wanted = 1.0f; }}});
}

TEST_CASE("every option of embolden and outlined is in the key", "[option_keys]")
{
    check_keys<embolden>({{"by", seen_by::plan, [](embolden& s) { s.by = 0.03f; }},
                          {"joins", seen_by::plan, [](embolden& s) { s.joins = bevel_joins::bevelled; }},
                          {"mitre_limit", seen_by::plan, [](embolden& s) { s.mitre_limit = 3.0f; }}});
    using framed = outlined<extruded<>, extruded<>>;
    check_keys<framed>({{"width", seen_by::plan, [](framed& s) { s.width = 0.03f; }},
                        {"place", seen_by::plan, [](framed& s) { s.place = outline_place::outer; }},
                        {"joins", seen_by::plan, [](framed& s) { s.joins = bevel_joins::bevelled; }},
                        {"mitre_limit", seen_by::plan, [](framed& s) { s.mitre_limit = 3.0f; }},
                        {"ring", seen_by::plan, [](framed& s) { s.ring.front = false; }},
                        {"letter", seen_by::plan, [](framed& s) { s.letter.front = false; }}});
}
