// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/offset/impl/moving_point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Remembers flips of kinetic triangles. Where corners lie on a line to within their rounding, flips may go in a
/// circle, and two triangles may each call for the flip that undoes the other's.
class flip_history {
public:
    explicit flip_history(memory source) noexcept : last_{source} {}

    /// Whether a diagonal between corners p and q that a flip will bring has been there at this time: flips go in a
    /// circle.
    /// From  R. P. Brent: An improved Monte Carlo factorization algorithm (1980), for one diagonal that is remembered
    [[nodiscard]] bool comes_back(std::uint32_t p, std::uint32_t q, std::int64_t now) noexcept
    {
        if (known_.time != now) known_ = {now, 0, 1, none, none};
        if ((known_.p == p && known_.q == q) || (known_.p == q && known_.q == p)) return true;
        if (++known_.age == known_.span) known_ = {now, 0, 2 * known_.span, p, q};
        return false;
    }

    /// Notes that triangles t and r have been flipped. `calm` becomes the time from which on they may be flipped again:
    /// when they have undone their flip eight times, they wait a sixteenth of a cell, and then each time twice as long,
    /// as what happens around them meanwhile decides. False when memory runs out.
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

    /// The last one of a triangle.
    struct flip {
        std::int64_t calm = 0;
        std::uint32_t with = none;  // its neighbour then
        std::uint32_t undone = 0;   // how often they have undone it
    };

    buffer<flip> last_;
    struct {
        std::int64_t time = -1;
        std::uint32_t age = 0, span = 1;  // flips since, and until another one is remembered
        std::uint32_t p = none, q = none;
    } known_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
