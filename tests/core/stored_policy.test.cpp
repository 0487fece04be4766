// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/impl/stored_policy.hpp>

#include <utility>

using namespace typemesh;

namespace {

/// Calls a policy for a number.
class number_ref {
public:
    struct calls {
        int (*number)(void* policy) noexcept;
    };
    template <class Policy>
    struct table {
        static constexpr calls of = {[](void* policy) noexcept { return static_cast<Policy*>(policy)->number(); }};
    };
    number_ref(void* policy, const calls& does) noexcept : policy_{policy}, does_{&does} {}
    [[nodiscard]] int operator()() const noexcept { return does_->number(policy_); }

private:
    void* policy_;
    const calls* does_;
};

struct plain {
    int value;
    int number() noexcept { return value++; }
};

/// Counts how many of it exist; cannot be copied.
struct counted {
    static inline int living = 0;

    int value = 7;
    explicit counted(int v) noexcept : value{v} { ++living; }
    counted(counted&& other) noexcept : value{std::exchange(other.value, -1)} { ++living; }
    ~counted() { --living; }
    [[nodiscard]] int number() const noexcept { return value; }
};

struct largest {
    char bytes[stored_policy<number_ref>::room] = {};
    [[nodiscard]] int number() const noexcept { return bytes[63]; }
};

}  // namespace

TEST_CASE("a stored policy is found by its type and can be replaced by another type", "[stored_policy]")
{
    stored_policy<number_ref> kept{plain{3}};
    CHECK(kept.ref()() == 3);
    CHECK(kept.ref()() == 4);  // the policy itself, not a copy
    REQUIRE(kept.get<plain>() != nullptr);
    CHECK(kept.get<plain>()->value == 5);
    CHECK(kept.get<counted>() == nullptr);
    largest big;
    big.bytes[63] = 9;
    kept = big;
    CHECK(kept.ref()() == 9);
    CHECK(kept.get<plain>() == nullptr);
}

TEST_CASE("each policy is destroyed once, wherever it was moved", "[stored_policy]")
{
    {
        stored_policy<number_ref> one{counted{1}}, two{counted{2}}, three{plain{3}};
        CHECK(counted::living == 2);
        std::swap(one, two);
        CHECK(one.ref()() == 2);
        CHECK(two.ref()() == 1);
        three = std::move(one);
        CHECK(three.ref()() == 2);
        one = plain{5};
        CHECK(one.ref()() == 5);
        CHECK(counted::living == 2);
        auto& self = two;
        two = std::move(self);
        CHECK(two.ref()() == 1);
    }
    CHECK(counted::living == 0);
}
