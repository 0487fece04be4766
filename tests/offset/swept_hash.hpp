// SPDX-License-Identifier: MIT
#pragma once

// For units that see different declarations of typemesh: they share nothing in this header.

#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/fill.hpp>
#include <typemesh/offset/sweep_inwards.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace {

struct swept_hash {
    std::uint64_t value = 0xCBF2'9CE4'8422'2325u;  // FNV-1a
    std::size_t triangles = 0, joins = 0, failures = 0;

    template <class T>
    void add(const typemesh::buffer<T>& all)
    {
        for (const T& one : all) {
            unsigned char bytes[sizeof(T)];
            std::memcpy(bytes, &one, sizeof(T));
            for (const unsigned char b : bytes) value = (value ^ b) * 0x100'0000'01B3u;
        }
    }
};

/// Random stars, each inside another, swept by a quarter of the smallest distance.
swept_hash hash_of_stars()
{
    using namespace typemesh;
    swept_hash hash;
    workspace space;
    std::uint64_t seed = 1;
    for (int round = 0; round < 200; ++round) {
        contours loops;
        bool fits = loops.starts.push_back(0);
        const int n = 5 + round % 40;
        const double radius = round % 3 == 0 ? 1000.0 : round % 3 == 1 ? 1'000'000.0 : 200'000'000.0;
        for (const int turn : {1, -1}) {
            for (int i = 0; i < n; ++i) {
                seed = seed * 6364136223846793005u + 1442695040888963407u;
                const double size = radius * (turn > 0 ? 1.0 : 0.4) * (0.5 + static_cast<double>(seed >> 33) * 0x1p-32);
                const double angle = 6.283185307179586 * turn * i / n;
                fits = fits && loops.edges.push_back({}) &&
                       loops.points.push_back({static_cast<std::int32_t>(std::lround(size * std::cos(angle))),
                                               static_cast<std::int32_t>(std::lround(size * std::sin(angle)))});
            }
            fits = fits && loops.starts.push_back(static_cast<std::uint32_t>(loops.points.size()));
        }
        const auto filled = fill(loops, fill_rule::non_zero, space);
        triangle_list triangles;
        workspace::scope scratch{space};
        swept_region out;
        const double levels[] = {0.0, radius / 16, radius / 8};
        if (!fits || !filled || monotone{}(*filled, space, triangles) ||
            sweep_inwards(*filled, triangles.view(), {levels, round % 2 == 0 ? 1.5 : 0.0, 1.0}, scratch, out)) {
            ++hash.failures;
            continue;
        }
        hash.add(out.nodes);
        hash.add(out.cells);
        hash.add(out.triangles);
        hash.add(out.edges_at);
        hash.add(out.joins);
        hash.add(out.cap.points);
        hash.triangles += out.triangles.size();
        hash.joins += out.joins.size();
    }
    return hash;
}

}  // namespace

namespace test {

/// hash_of_stars() of a unit whose compiler lacks 128-bit integers.
std::uint64_t hash_without_int128();

}  // namespace test
