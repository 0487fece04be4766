// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/text/letter_motions.hpp>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

/// Letters that have no mesh: their numbers of graphemes, each at x = its first grapheme.
struct row_of_letters {
    explicit row_of_letters(const std::vector<std::uint32_t>& graphemes)
    {
        for (const std::uint32_t n : graphemes) {
            text_letter l;
            l.grapheme = all;
            l.graphemes = n;
            l.grapheme_end = l.grapheme + n;
            l.pivot = {static_cast<float>(all), 0.0f, 0.0f};
            letters.push_back(l);
            all += n;
        }
        whole.count = static_cast<std::uint32_t>(letters.size());
    }
    [[nodiscard]] letter_place place(std::uint32_t i, const typemesh::frame& f = {}) const
    {
        return {letters[i], whole, whole, whole, whole, i, 1, 1, 1, all, f};
    }
    /// The numbers of the graphemes that a motion shows.
    [[nodiscard]] std::set<std::uint32_t> shown(const reveal& how) const
    {
        std::set<std::uint32_t> seen;
        for (std::uint32_t i = 0; i < letters.size(); ++i) {
            const affine3 map = how(place(i));
            if (map == affine3{})
                for (std::uint32_t k = 0; k < letters[i].graphemes; ++k) seen.insert(letters[i].grapheme + k);
            else
                CHECK(map({7, 8, 9}) == letters[i].pivot);
        }
        return seen;
    }

    std::vector<text_letter> letters;
    letter_group whole;
    std::uint32_t all = 0;
};

using numbers = std::set<std::uint32_t>;

}  // namespace

TEST_CASE("each order gives every letter its turn, from 0 to 1", "[letters]")
{
    for (const std::uint32_t count : {2u, 3u, 4u, 7u, 10u}) {
        for (const letter_order order :
             {letter_order::forward, letter_order::reverse, letter_order::from_centre, letter_order::to_centre}) {
            if (count == 2 && order >= letter_order::from_centre) continue;  // both at once
            double low = 2.0, high = -1.0;
            for (std::uint32_t i = 0; i < count; ++i) {
                low = std::fmin(low, turn_of(order, i, count));
                high = std::fmax(high, turn_of(order, i, count));
            }
            CHECK(low == 0.0);
            CHECK(high == 1.0);
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            CHECK(turn_of(letter_order::forward, i, count) ==
                  Catch::Approx(1.0 - turn_of(letter_order::reverse, i, count)));
            CHECK(turn_of(letter_order::from_centre, i, count) ==
                  turn_of(letter_order::from_centre, count - 1 - i, count));
            if (i + 1 < count)
                CHECK(turn_of(letter_order::forward, i, count) < turn_of(letter_order::forward, i + 1, count));
        }
    }
    CHECK(turn_of(letter_order::from_centre, 2, 5) == 0.0);
    CHECK(turn_of(letter_order::to_centre, 2, 5) == 1.0);
    CHECK(turn_of(letter_order::reverse, 0, 1) == 0.0);
}

TEST_CASE("letters that start one after another have all arrived at the end", "[letters]")
{
    for (const double share : {0.1, 0.5, 1.0})
        for (const double turn : {0.0, 0.3, 1.0}) {
            CHECK(progress_of(turn, 0.0, share) == 0.0);
            CHECK(progress_of(turn, 1.0, share) == Catch::Approx(1.0));
            CHECK(progress_of(turn, turn * (1.0 - share) + 0.5 * share, share) == Catch::Approx(0.5));
        }
    CHECK(progress_of(0.0, -1.0) == 0.0);
    CHECK(progress_of(1.0, 9.0) == 1.0);
}

TEST_CASE("a reveal shows whole letters in its order and moves none of them", "[letters]")
{
    const row_of_letters row{{1, 1, 3, 1, 1}};  // a ligature in the middle
    CHECK(row.shown({.graphemes = 0}) == numbers{});
    CHECK(row.shown({.graphemes = 2}) == numbers{0, 1});
    CHECK(row.shown({.graphemes = 4}) == numbers{0, 1});
    CHECK(row.shown({.graphemes = 5}) == numbers{0, 1, 2, 3, 4});
    CHECK(row.shown({.graphemes = 100}).size() == 7);
    CHECK(row.shown({.share = 0.5}) == numbers{0, 1});
    CHECK(row.shown({.share = 1.0}).size() == 7);
    CHECK(row.shown({.share = -1.0}).empty());
    CHECK(row.shown({.graphemes = 3, .order = letter_order::reverse}) == numbers{5, 6});
    CHECK(row.shown({.graphemes = 3, .order = letter_order::from_centre}) == numbers{2, 3, 4});
    CHECK(row.shown({.graphemes = 4, .order = letter_order::to_centre}) == numbers{0, 1, 5, 6});
    CHECK(row.shown({.graphemes = 7, .order = letter_order::to_centre}).size() == 7);
}

TEST_CASE("a wave lifts letters along the frame's up and repeats itself", "[letters]")
{
    const row_of_letters row{{1, 1, 1, 1, 1, 1, 1, 1, 1}};
    const letter_wave wave{.height = 0.5f, .letters = 8.0};
    CHECK(wave(row.place(2))({0, 0, 0}).y == Catch::Approx(0.5));
    CHECK(wave(row.place(8))({1, 2, 3}).y == Catch::Approx(2.0).margin(1e-6));
    CHECK(wave(row.place(0))({1, 2, 3}) == vec3{1, 2, 3});
    const letter_wave later{.height = 0.5f, .letters = 8.0, .time = 0.25};
    CHECK(later(row.place(4))({0, 0, 0}).y == Catch::Approx(0.5));
    CHECK(wave(row.place(2, right_handed_z_up))({0, 0, 0}).z == Catch::Approx(0.5));
}

TEST_CASE("scattered letters differ, stay within the distance, and depend on the seed alone", "[letters]")
{
    const row_of_letters row{{1, 1, 1, 1, 1, 1}};
    const letter_scatter some{.seed = 5, .distance = 2.0f}, other{.seed = 6, .distance = 2.0f};
    std::set<float> places;
    for (std::uint32_t i = 0; i < 6; ++i) {
        const vec3 pivot = row.letters[i].pivot, to = some(row.place(i))(pivot);
        CHECK(std::sqrt((to.x - pivot.x) * (to.x - pivot.x) + to.y * to.y + to.z * to.z) <= 2.0f);
        CHECK(some(row.place(i)) == some(row.place(i)));
        CHECK_FALSE(some(row.place(i)) == other(row.place(i)));
        CHECK(letter_scatter{.seed = 5, .amount = 0.0}(row.place(i)) == affine3{});
        places.insert(to.y);
    }
    CHECK(places.size() == 6);
}
