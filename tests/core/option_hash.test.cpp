// SPDX-License-Identifier: MIT

#include <typemesh/core/impl/option_hash.hpp>

#include "support/catch.hpp"

#include <set>
#include <utility>

using namespace typemesh;

namespace {

struct without_options {};
struct with_options {
    double size;
    [[nodiscard]] option_bits cache_key() const noexcept { return {size}; }
};

std::pair<std::uint64_t, std::uint64_t> both(const option_hash& h) { return {h.first, h.second}; }

}  // namespace

TEST_CASE("hashes of options depend on their values, their order and their policy", "[option_hash]")
{
    std::set<std::pair<std::uint64_t, std::uint64_t>> all;
    all.insert(both(option_hash{}));
    for (const double a : {0.0, 1.0, 2.0, -1.0}) {
        option_hash one;
        one.add_key_of(with_options{a});
        all.insert(both(one));
        for (const double b : {0.0, 1.0, 2.0, -1.0}) {
            option_hash two = one;
            two.add_key_of(with_options{b});
            all.insert(both(two));
        }
    }
    CHECK(all.size() == 1 + 4 + 16);

    option_hash none;
    none.add_key_of(without_options{});
    CHECK(both(none) == both(option_hash{}));
    option_hash by_bits, by_words;
    by_bits.add(option_bits{3.0, 4.0});
    for (const std::uint64_t word : option_bits{3.0, 4.0}.words) by_words.add(word);
    CHECK(both(by_bits) == both(by_words));
}
