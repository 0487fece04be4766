// SPDX-License-Identifier: MIT
#include "refusals.hpp"
#include "support/catch.hpp"

#include <typemesh/vertex/impl/index_writer.hpp>

#include <cstdint>
#include <vector>

using namespace typemesh;

TEST_CASE("the greatest index value is not used", "[vertex]")
{
    CHECK(index_can_number<std::uint32_t>(0xFFFF'FFFFu));
    CHECK_FALSE(index_can_number<std::uint32_t>(0x1'0000'0000u));
    CHECK(index_can_number<std::uint16_t>(0xFFFF));
    CHECK_FALSE(index_can_number<std::uint16_t>(0x1'0000));
    CHECK(index_can_number<std::uint8_t>(255));
    CHECK_FALSE(index_can_number<std::uint8_t>(256));
    CHECK(index_can_number<int>(0x7FFF'FFFFu));
    CHECK_FALSE(index_can_number<int>(0x8000'0000u));
    CHECK(index_can_number<std::int16_t>(0x7FFF));
    CHECK_FALSE(index_can_number<std::int16_t>(0x8000));
    CHECK(index_can_number<std::int64_t>(0xFFFF'FFFFu));
}

TEMPLATE_TEST_CASE("triangles are written one after another into indices of every width, each with the base added",
                   "[vertex]", std::uint8_t, std::uint16_t, std::uint32_t, std::uint64_t, std::int16_t, std::int32_t,
                   std::int64_t)
{
    std::vector<TestType> indices(9, TestType{77});
    index_writer<TestType> writer{100};
    writer.start(indices.data());
    writer.triangle(0, 1, 2);
    writer.skip(3);
    writer.triangle(2, 1, 100);
    CHECK(indices == std::vector<TestType>{100, 101, 102, 77, 77, 77, 102, 101, 200});
}

TEST_CASE("more vertices than the index type can number are refused, including the base", "[vertex]")
{
    CHECK_FALSE(index_writer<std::uint16_t>{5}.numbers(0xFFFF - 5));
    test::check_refused(index_writer<std::uint16_t>{5}.numbers(0xFFFF - 4), error::index_overflow, 0x1'0000u);
    CHECK(index_writer<std::uint32_t>{0xFFFF'FFFFu}.numbers(1).code == error::index_overflow);
    CHECK_FALSE(index_writer<std::uint64_t>{0xFFFF'FFFFu}.numbers(0xFFFF'FFFFu));
}
