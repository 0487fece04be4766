// SPDX-License-Identifier: MIT

#include <typemesh/sweep/impl/sectors.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <set>

using namespace typemesh;

TEST_CASE("Spokes of different directions that take turns are sorted into sectors, others are refused",
          "[core][sectors]")
{
    test::dice d{511};
    int accepted = 0, refused = 0;
    for (int i = 0; i < 20'000; ++i) {
        const int count = 2 * (1 + d.roll(10)), width = 1 + d.roll(1 << d.roll(28));
        std::vector<outgoing_edge> outgoing_edges;
        std::set<double> angles;
        const auto angle = [](const outgoing_edge& s) { return std::atan2(double(s.y), double(s.x)); };
        while (outgoing_edges.size() < std::size_t(count)) {
            const outgoing_edge s{d.roll(2 * width + 1) - width, d.roll(2 * width + 1) - width, 0, false};
            if (s.x != 0 || s.y != 0) outgoing_edges.push_back(s);
        }
        std::sort(outgoing_edges.begin(), outgoing_edges.end(),
                  [&](const outgoing_edge& a, const outgoing_edge& b) { return angle(a) < angle(b); });
        for (int k = 0; k < count; ++k) outgoing_edges[std::size_t(k)].goes_out = (k + i) % 2 == 0;
        bool differ = true;  // exact, and not by angle
        for (int k = 0; k < count; ++k) {
            const outgoing_edge &a = outgoing_edges[std::size_t(k)], &b = outgoing_edges[std::size_t((k + 1) % count)];
            const std::int64_t inner = std::int64_t{a.x} * b.x + std::int64_t{a.y} * b.y;
            differ = differ && (a.cross(b) != 0 || inner < 0);
        }
        if (d.roll(8) == 0) {
            outgoing_edges[0].goes_out = !outgoing_edges[0].goes_out;
            differ = false;
        }
        for (int k = count; k-- > 1;)
            std::swap(outgoing_edges[std::size_t(k)], outgoing_edges[std::size_t(d.roll(k + 1))]);
        const bool sectors = sort_into_sectors(outgoing_edges.data(), outgoing_edges.size());
        CHECK(sectors == differ);
        (sectors ? accepted : refused) += 1;
        if (!sectors) continue;
        int turns_back = 0;
        for (int k = 0; k < count; ++k) {
            const outgoing_edge &a = outgoing_edges[std::size_t(k)], &b = outgoing_edges[std::size_t((k + 1) % count)];
            CHECK(a.goes_out == (k % 2 == 0));
            turns_back += angle(b) < angle(a);
        }
        CHECK(turns_back == 1);
    }
    CHECK(accepted > 1000);
    CHECK(refused > 1000);
}
