// SPDX-License-Identifier: MIT

#include <typemesh/core/wedges.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <set>

using namespace typemesh;

TEST_CASE("Spokes of different directions that take turns are sorted into wedges, others are refused", "[core][wedges]")
{
    test::dice d{511};
    int accepted = 0, refused = 0;
    for (int i = 0; i < 20'000; ++i) {
        const int count = 2 * (1 + d.roll(10)), width = 1 + d.roll(1 << d.roll(28));
        std::vector<spoke> spokes;
        std::set<double> angles;
        const auto angle = [](const spoke& s) { return std::atan2(double(s.y), double(s.x)); };
        while (spokes.size() < std::size_t(count)) {
            const spoke s{d.roll(2 * width + 1) - width, d.roll(2 * width + 1) - width, 0, false};
            if (s.x != 0 || s.y != 0) spokes.push_back(s);
        }
        std::sort(spokes.begin(), spokes.end(), [&](const spoke& a, const spoke& b) { return angle(a) < angle(b); });
        for (int k = 0; k < count; ++k) spokes[std::size_t(k)].goes_out = (k + i) % 2 == 0;
        bool differ = true;  // exact, and not by angle
        for (int k = 0; k < count; ++k) {
            const spoke &a = spokes[std::size_t(k)], &b = spokes[std::size_t((k + 1) % count)];
            const std::int64_t inner = std::int64_t{a.x} * b.x + std::int64_t{a.y} * b.y;
            differ = differ && (a.cross(b) != 0 || inner < 0);
        }
        if (d.roll(8) == 0) {
            spokes[0].goes_out = !spokes[0].goes_out;
            differ = false;
        }
        for (int k = count; k-- > 1;) std::swap(spokes[std::size_t(k)], spokes[std::size_t(d.roll(k + 1))]);
        const bool wedges = sort_into_wedges(spokes.data(), spokes.size());
        CHECK(wedges == differ);
        (wedges ? accepted : refused) += 1;
        if (!wedges) continue;
        int turns_back = 0;
        for (int k = 0; k < count; ++k) {
            const spoke &a = spokes[std::size_t(k)], &b = spokes[std::size_t((k + 1) % count)];
            CHECK(a.goes_out == (k % 2 == 0));
            turns_back += angle(b) < angle(a);
        }
        CHECK(turns_back == 1);
    }
    CHECK(accepted > 1000);
    CHECK(refused > 1000);
}
