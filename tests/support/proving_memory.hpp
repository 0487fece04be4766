// SPDX-License-Identifier: MIT
#pragma once

// What a triangulator's prove() does while each of its requests for memory fails, one after the other.

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

#include <typemesh/core/region.hpp>

namespace test {

/// A proof without memory reports it and leaves no triangle; a repeated proof asks for no memory.
template <class Triangulator>
void check_proving_memory(const Triangulator& how, const shape& s)
{
    const typemesh::contours loops = contours_of(s);
    bool was_asked = true;
    for (std::size_t nth = 1; was_asked; ++nth) {
        INFO("request " << nth);
        counting_memory memory{.fail_at = nth, .fail_once = true};
        typemesh::workspace space{memory.source()};
        typemesh::triangle_list out{memory.source()};
        const typemesh::result<typemesh::region> proven = how.prove(loops, space, out);
        was_asked = memory.requests >= nth;
        memory.fail_at = 0;
        if (!proven) {
            CHECK(proven.error() == typemesh::error::out_of_memory);
            CHECK(out.empty());
        }
        out.clear();
        const typemesh::result<typemesh::region> again = how.prove(loops, space, out);
        REQUIRE(again);
        CHECK(oracle::broken_law(*again, out.view()) == "");
        const std::size_t warm = memory.requests;
        out.clear();
        REQUIRE(how.prove(loops, space, out));
        CHECK(memory.requests == warm);
    }
}

/// A proof takes no more scratch memory than this.
template <class Triangulator>
void check_scratch_memory(const Triangulator& how, const typemesh::contours& loops, std::size_t bytes)
{
    counting_memory memory;
    typemesh::workspace measured{memory.source()};
    {
        typemesh::workspace::scope whole{measured};
        REQUIRE(whole.take<char>(bytes) != nullptr);
    }
    const std::size_t before = memory.requests;
    typemesh::triangle_list out;
    REQUIRE(how.prove(loops, measured, out));
    CHECK(memory.requests == before);
}

}  // namespace test
