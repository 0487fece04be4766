// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>

#include <array>
#include <span>
#include <type_traits>
#include <vector>

using namespace typemesh;

namespace {

int sum(array_view<const int> values)
{
    int all = 0;
    for (const int v : values) all += v;
    return all;
}

}  // namespace

TEST_CASE("a view shows the values of the array it was made from", "[core][array_view]")
{
    std::vector<int> vector{1, 2, 3, 4};
    int plain[] = {5, 6};
    const std::array<int, 3> fixed{7, 8, 9};
    buffer<int> own;
    REQUIRE(own.push_back(10));

    CHECK(sum(vector) == 10);
    CHECK(sum(plain) == 11);
    CHECK(sum(fixed) == 24);
    CHECK(sum(own) == 10);
    CHECK(sum(std::span<int>{vector}.subspan(1)) == 9);
    CHECK(sum({}) == 0);
    CHECK(sum({vector.data(), 2}) == 3);

    array_view<int> all = vector;
    all[0] = 100;
    CHECK(vector.front() == 100);
    CHECK(all.data() == vector.data());
    CHECK(&all.front() == &vector.front());
    CHECK(&all.back() == &vector.back());
    CHECK(all.end() - all.begin() == 4);
    CHECK(all.size_bytes() == 4 * sizeof(int));
    CHECK(array_view<int>{}.empty());
    CHECK_FALSE(all.empty());
}

TEST_CASE("first(), last() and subspan() show the right part of a view", "[core][array_view]")
{
    const int values[] = {0, 1, 2, 3, 4, 5};
    const array_view<const int> all = values;
    for (std::size_t at = 0; at <= all.size(); ++at) {
        CHECK(all.first(at).data() == values);
        CHECK(all.first(at).size() == at);
        CHECK(all.subspan(at).data() == values + at);
        CHECK(all.subspan(at).size() == all.size() - at);
        CHECK(all.last(at).data() == all.end() - at);
        for (std::size_t count = 0; at + count <= all.size(); ++count) {
            CHECK(all.subspan(at, count).data() == values + at);
            CHECK(all.subspan(at, count).size() == count);
        }
    }
}

TEST_CASE("a view converts to spans and to constant views, and to no other type", "[core][array_view]")
{
    int values[] = {1, 2, 3};
    const array_view<int> view = values;
    const std::span<int> span = view;
    const std::span<const int> constant = view;
    CHECK(span.data() == values);
    CHECK(span.size() == 3);
    CHECK(constant.data() == values);
    CHECK(array_view<const int>{view}.data() == values);

    STATIC_REQUIRE(std::is_convertible_v<array_view<int>, array_view<const int>>);
    STATIC_REQUIRE_FALSE(std::is_convertible_v<array_view<const int>, array_view<int>>);
    STATIC_REQUIRE_FALSE(std::is_convertible_v<array_view<const int>, std::span<int>>);
    STATIC_REQUIRE_FALSE(std::is_convertible_v<std::vector<long>&, array_view<int>>);
    STATIC_REQUIRE_FALSE(std::is_convertible_v<int, array_view<int>>);
}
