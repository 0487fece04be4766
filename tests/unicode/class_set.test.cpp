// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/unicode/impl/bidi_class.hpp>

using namespace typemesh;

TEST_CASE("a set of bidi classes contains what was added and nothing else", "[bidi]")
{
    for (int a = 0; a <= static_cast<int>(bidi_class::pdi); ++a)
        for (int b = 0; b <= static_cast<int>(bidi_class::pdi); ++b) {
            const auto one = static_cast<bidi_class>(a), other = static_cast<bidi_class>(b);
            bidi_classes set{one};
            CHECK(set.holds(other) == (a == b));
            CHECK(set.meets(other) == (a == b));
            set.add(other);
            CHECK(set.holds(one));
            CHECK(set.holds(other));
            CHECK_FALSE(bidi_classes{}.meets(set));
            CHECK((bidi_classes{one} | bidi_classes{other}).holds(other));
        }
}
