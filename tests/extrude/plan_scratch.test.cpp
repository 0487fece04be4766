// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/plan_scratch.hpp>
#include <typemesh/extrude/plan_arrays.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <utility>
#include <vector>

using namespace typemesh;

TEST_CASE("scratch of one type is used again, and scratch of another type replaces it", "[extrude][plan_scratch]")
{
    using numbers = plan_arrays<double>;
    using letters = plan_arrays<char>;
    test::counting_memory memory;
    {
        plan_scratch scratch{memory.source()};
        CHECK(scratch.bytes() == 0);
        auto* const first = scratch.fresh<numbers>();
        REQUIRE(first != nullptr);
        REQUIRE(first->of<double>().push_back(2.5));
        CHECK(scratch.bytes() == first->bytes());
        std::vector<double> block(scratch.bytes() / 8);
        scratch.copy_to(reinterpret_cast<std::byte*>(block.data()));
        CHECK(numbers::read_from(reinterpret_cast<const std::byte*>(block.data())).of<double>()[0] == 2.5);

        const std::size_t before = memory.requests;
        auto* const again = scratch.fresh<numbers>();
        CHECK(again == first);
        CHECK(again->of<double>().empty());
        CHECK(memory.requests == before);

        plan_scratch moved{std::move(scratch)};
        CHECK(scratch.bytes() == 0);
        auto* const other = moved.fresh<letters>();
        REQUIRE(other != nullptr);
        REQUIRE(other->of<char>().push_back('x'));
        CHECK(moved.bytes() == other->bytes());
        scratch = std::move(moved);
        CHECK(scratch.bytes() == other->bytes());
        scratch.release();
        CHECK(memory.bytes_held == 0);
        REQUIRE(scratch.fresh<numbers>() != nullptr);
    }
    CHECK(memory.bytes_held == 0);
}

TEST_CASE("scratch that gets no memory is null and empty", "[extrude][plan_scratch]")
{
    test::counting_memory failing{.fail_at = 1};
    plan_scratch scratch{failing.source()};
    CHECK(scratch.fresh<plan_arrays<double>>() == nullptr);
    CHECK(scratch.bytes() == 0);
}
