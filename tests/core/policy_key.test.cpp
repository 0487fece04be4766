// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/policy_key.hpp>

using namespace typemesh;

namespace {

struct first_empty {};
struct second_empty {};
struct with_option {
    double amount = 1.0;
    [[nodiscard]] option_bits cache_key() const noexcept { return {amount}; }
};
struct with_the_same_option {
    double amount = 1.0;
    [[nodiscard]] option_bits cache_key() const noexcept { return {amount}; }
};
struct unkeyed {
    double amount = 1.0;
};

}  // namespace

static_assert(cacheable_policy<first_empty> && cacheable_policy<with_option> && !cacheable_policy<unkeyed>);
static_assert(has_cache_key<with_option> && !has_cache_key<first_empty>);

TEST_CASE("policies of different types have different keys, whatever their options", "[policy_key]")
{
    CHECK(key_of(first_empty{}) == key_of(first_empty{}));
    CHECK_FALSE(key_of(first_empty{}) == key_of(second_empty{}));
    CHECK(key_of(with_option{3.0}) == key_of(with_option{3.0}));
    CHECK_FALSE(key_of(with_option{3.0}) == key_of(with_option{4.0}));
    CHECK_FALSE(key_of(with_option{3.0}) == key_of(with_the_same_option{3.0}));
}

TEST_CASE("a policy with members but no cache_key() has a key without a type", "[policy_key]")
{
    CHECK(key_of(unkeyed{}).type == nullptr);
    CHECK(key_of(with_option{}).type != nullptr);
}
