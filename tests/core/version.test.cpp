// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/point.hpp>
#include <typemesh/core/version.hpp>

#include <string>
#include <type_traits>

#define NAME_OF(macro) NAME_OF_EXPANDED(macro)
#define NAME_OF_EXPANDED(name) #name

TEST_CASE("the namespace names the version and how the unit is compiled", "[version]")
{
    std::string name = "v";
    name += NAME_OF(TYPEMESH_VERSION_MAJOR) "_" NAME_OF(TYPEMESH_VERSION_MINOR) "_" NAME_OF(TYPEMESH_VERSION_PATCH);
#ifndef NDEBUG
    name += "_checked";
#endif
#ifdef TYPEMESH_COMPILED
    name += "_compiled";
#endif
    CHECK(name == NAME_OF(TYPEMESH_ABI));
    STATIC_REQUIRE(std::is_same_v<typemesh::point, typemesh::TYPEMESH_ABI::point>);
}
