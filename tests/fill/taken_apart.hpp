// SPDX-License-Identifier: MIT
#pragma once

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <typemesh/fill/impl/arrangement.hpp>

/// Contours taken apart, with room for so many segments.
struct taken_apart {
    typemesh::contours loops;
    typemesh::workspace space;
    typemesh::workspace::scope scratch{space};
    typemesh::detail::arrangement a;

    taken_apart(const std::vector<test::polyline>& given, std::uint32_t room) : loops{test::contours_of(given)}
    {
        REQUIRE(a.reserve(scratch, room));
        REQUIRE(sort_points(loops, space));
        REQUIRE(a.from_contours(loops, space));
    }
};
