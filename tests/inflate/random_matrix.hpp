// SPDX-License-Identifier: MIT
#pragma once

// Systems of random networks, like those of membranes: some neighbours are held at 0.

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <typemesh/inflate/impl/envelope_factors.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace inflating {

using namespace typemesh;

/// A membrane_matrix with memory of its own, and a load.
struct random_matrix {
    std::vector<std::uint32_t> starts, columns;
    std::vector<double> shares, diagonal, load;

    /// Up to 90 unknowns, each with a few neighbours anywhere.
    explicit random_matrix(std::uint64_t seed)
    {
        test::dice d{seed};
        const auto n = static_cast<std::uint32_t>(2 + d.roll(88));
        std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
        for (std::uint32_t i = 1; i < n; ++i)
            for (int k = d.roll(4); k > 0; --k) edges.emplace_back(i, static_cast<std::uint32_t>(d.roll(int(i))));
        fill(n, edges, d);
    }

    /// A strip of triangles, its unknowns in random order.
    static random_matrix strip(std::size_t length, std::size_t width, std::uint64_t seed)
    {
        test::dice d{seed};
        const auto n = static_cast<std::uint32_t>(length * width);
        std::vector<std::uint32_t> number(n);
        std::iota(number.begin(), number.end(), 0u);
        for (std::uint32_t i = n - 1; i > 0; --i)
            std::swap(number[i], number[static_cast<std::size_t>(d.roll(int(i) + 1))]);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
        for (std::size_t x = 0; x < length; ++x)
            for (std::size_t y = 0; y < width; ++y) {
                const std::uint32_t here = number[x * width + y];
                if (y + 1 < width) edges.emplace_back(here, number[x * width + y + 1]);
                if (x + 1 < length) edges.emplace_back(here, number[(x + 1) * width + y]);
                if (x + 1 < length && y + 1 < width) edges.emplace_back(here, number[(x + 1) * width + y + 1]);
            }
        random_matrix made;
        made.fill(n, edges, d);
        return made;
    }

    [[nodiscard]] detail::membrane_matrix view() const { return {starts, columns, shares, diagonal}; }

    [[nodiscard]] double residual(const std::vector<double>& u) const
    {
        std::vector<double> rest = load;
        for (std::uint32_t i = 0; i < u.size(); ++i) {
            rest[i] -= diagonal[i] * u[i];
            for (std::uint32_t k = starts[i]; k < starts[i + 1]; ++k) {
                rest[i] += shares[k] * u[columns[k]];
                rest[columns[k]] += shares[k] * u[i];
            }
        }
        double square = 0.0, whole = 0.0;
        for (std::size_t i = 0; i < u.size(); ++i) square += rest[i] * rest[i], whole += load[i] * load[i];
        return std::sqrt(square / whole);
    }

private:
    random_matrix() = default;

    void fill(std::uint32_t n, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges, test::dice& d)
    {
        std::vector<std::vector<std::pair<std::uint32_t, double>>> rows(n);
        for (std::uint32_t i = 0; i < n; ++i) {
            diagonal.push_back(0.1 + d.fraction());  // what is held at 0
            load.push_back(0.1 + d.fraction());
        }
        for (const auto& [i, j] : edges) {
            bool is_new = true;
            for (const auto& [column, share] : rows[i]) is_new = is_new && column != j;
            for (const auto& [column, share] : rows[j]) is_new = is_new && column != i;
            if (!is_new || i == j) continue;
            const double one = d.fraction(), other = d.fraction();
            rows[i].emplace_back(j, one);
            rows[j].emplace_back(i, other);
            diagonal[i] += one + other;
            diagonal[j] += one + other;
        }
        starts.push_back(0);
        for (const auto& row : rows) {
            for (const auto& [column, share] : row) columns.push_back(column), shares.push_back(share);
            starts.push_back(static_cast<std::uint32_t>(columns.size()));
        }
    }
};

}  // namespace inflating
