// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/offset/impl/moving_point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Remembers flips of kinetic triangles. If corners are collinear within their rounding, flips may go in a circle, and
/// two triangles may each request the flip that undoes the other's flip.
class flip_history {
public:
    explicit flip_history(memory source) noexcept : last_{source} {}

    /// Whether the diagonal between corners p and q that a flip will make has existed before at this time: flips go in
    /// a circle.
    /// From  R. P. Brent: An improved Monte Carlo factorization algorithm (1980), for remembering a single diagonal
    [[nodiscard]] bool comes_back(std::uint32_t p, std::uint32_t q, std::int64_t now) noexcept
    {
        if (known_.time != now) known_ = {now, 0, 1, none, none};
        if ((known_.p == p && known_.q == q) || (known_.p == q && known_.q == p)) return true;
        if (++known_.age == known_.span) known_ = {now, 0, 2 * known_.span, p, q};
        return false;
    }

    /// Notes that triangles t and r have been flipped. `calm` becomes the earliest time of their next flip. After they
    /// have undone their flip eight times, they wait a sixteenth of a cell, and then twice as long each time: the
    /// events around them meanwhile decide. False if out of memory.
    [[nodiscard]] bool note(std::uint32_t t, std::uint32_t r, std::int64_t now, std::int64_t& calm) noexcept
    {
        constexpr std::uint32_t patience = 8, most = patience + 30;
        while (last_.size() <= (t > r ? t : r))
            if (!last_.push_back({})) return false;
        flip &of = last_[t], &other = last_[r];
        const bool undoes = of.with == r && other.with == t && now <= of.calm;
        const std::uint32_t undone = !undoes ? 0 : of.undone < most ? of.undone + 1 : most;
        calm = now + (undone < patience ? 0 : (time_one / 16) << (undone - patience));
        of = {calm, r, undone};
        other = {calm, t, undone};
        return true;
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    /// The last flip of a triangle.
    struct flip {
        std::int64_t calm = 0;
        std::uint32_t with = none;  // its neighbour in that flip
        std::uint32_t undone = 0;   // how often these two have undone it
    };

    buffer<flip> last_;
    struct {
        std::int64_t time = -1;
        std::uint32_t age = 0, span = 1;  // flips since then, and flips until another diagonal is remembered
        std::uint32_t p = none, q = none;
    } known_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
