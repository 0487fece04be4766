// SPDX-License-Identifier: MIT

#include <typemesh/sweep/impl/sectors.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <algorithm>

using namespace typemesh;

TEST_CASE("Alternating spokes of different directions are sorted into sectors, and others refused", "[core][sectors]")
{
    test::dice d{511};
    int accepted = 0, refused = 0;
    for (int i = 0; i < 20'000; ++i) {
        const int count = 2 * (1 + d.roll(10)), width = 1 + d.roll(1 << d.roll(28));
        std::vector<outgoing_edge> edges;
        const auto angle = [](const outgoing_edge& s) { return std::atan2(double(s.y), double(s.x)); };
        while (edges.size() < std::size_t(count)) {
            const outgoing_edge s{d.roll(2 * width + 1) - width, d.roll(2 * width + 1) - width, 0, false};
            if (s.x != 0 || s.y != 0) edges.push_back(s);
        }
        std::ranges::sort(edges, {}, angle);
        for (int k = 0; k < count; ++k) edges[std::size_t(k)].goes_out = (k + i) % 2 == 0;
        bool differ = true;  // exact, and not by angle
        for (int k = 0; k < count; ++k) {
            const outgoing_edge &a = edges[std::size_t(k)], &b = edges[std::size_t((k + 1) % count)];
            const std::int64_t inner = std::int64_t{a.x} * b.x + std::int64_t{a.y} * b.y;
            differ = differ && (a.cross(b) != 0 || inner < 0);
        }
        if (d.roll(8) == 0) {
            edges[0].goes_out = !edges[0].goes_out;
            differ = false;
        }
        for (int k = count; k-- > 1;) std::swap(edges[std::size_t(k)], edges[std::size_t(d.roll(k + 1))]);
        const bool sectors = sort_into_sectors(edges.data(), edges.size());
        CHECK(sectors == differ);
        (sectors ? accepted : refused) += 1;
        if (!sectors) continue;
        int turns_back = 0;
        for (int k = 0; k < count; ++k) {
            const outgoing_edge &a = edges[std::size_t(k)], &b = edges[std::size_t((k + 1) % count)];
            CHECK(a.goes_out == (k % 2 == 0));
            turns_back += angle(b) < angle(a);
        }
        CHECK(turns_back == 1);
    }
    CHECK(accepted > 1000);
    CHECK(refused > 1000);
}
