// SPDX-License-Identifier: MIT

#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/plan_arrays.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

using namespace typemesh;

namespace {

using arrays = plan_arrays<grid_point, char, double, triangle>;

template <class T>
void fill(buffer<T>& b, int n, test::dice& d)
{
    for (; n > 0; --n) {
        T value{};
        if constexpr (std::is_same_v<T, grid_point>)
            value = {d.roll(99), d.roll(99)};
        else if constexpr (std::is_same_v<T, triangle>)
            value = {static_cast<std::uint32_t>(d.roll(99)), 1, 2};
        else
            value = static_cast<T>(d.roll(99));
        REQUIRE(b.push_back(value));
    }
}

bool alike(const arrays::view& a, const arrays::view& b)
{
    const auto same = [](const auto& x, const auto& y) { return std::equal(x.begin(), x.end(), y.begin(), y.end()); };
    return same(a.of<grid_point>(), b.of<grid_point>()) && same(a.of<char>(), b.of<char>()) &&
           same(a.of<double>(), b.of<double>()) && same(a.of<triangle>(), b.of<triangle>());
}

}  // namespace

TEST_CASE("plan arrays are read back unchanged from their bytes, for all lengths and alignments",
          "[extrude][plan_arrays]")
{
    test::dice d{6};
    arrays made;
    for (int round = 0; round < 500; ++round) {
        made.clear();
        CHECK(made.read().of<double>().empty());
        fill(made.of<grid_point>(), d.roll(9), d);
        fill(made.of<char>(), d.roll(20), d);
        fill(made.of<double>(), d.roll(9), d);
        fill(made.of<triangle>(), d.roll(9), d);
        REQUIRE(made.bytes() % 8 == 0);
        std::vector<double> block(made.bytes() / 8 + 1, -1.0);  // aligned to 8
        made.copy_to(reinterpret_cast<std::byte*>(block.data()));
        CHECK(block.back() == -1.0);
        CHECK(alike(arrays::read_from(reinterpret_cast<const std::byte*>(block.data())), made.read()));
    }
}

TEST_CASE("plan arrays take their memory from their memory source", "[extrude][plan_arrays]")
{
    test::counting_memory memory;
    {
        arrays made{memory.source()};
        REQUIRE(made.of<double>().push_back(1.0));
        REQUIRE(made.of<char>().push_back('c'));
        CHECK(memory.requests == 2);
        made.clear();
        REQUIRE(made.of<double>().push_back(2.0));
        CHECK(memory.requests == 2);  // its storage stays
    }
    CHECK(memory.bytes_held == 0);
}
