// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/impl/attempt.hpp>

#include <stdexcept>

TEST_CASE("an attempt reports whether its function threw, and lets nothing escape", "[core]")
{
    int calls = 0;
    CHECK(typemesh::detail::attempt([&] { ++calls; }));
    CHECK_FALSE(typemesh::detail::attempt([&] {
        ++calls;
        throw std::runtime_error{"no"};
    }));
    CHECK_FALSE(typemesh::detail::attempt([&] {
        ++calls;
        throw 1;
    }));
    CHECK(calls == 3);
}
