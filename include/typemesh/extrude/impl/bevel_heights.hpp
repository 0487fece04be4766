// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The edges that are bevelled.
enum class bevel_sides : std::uint8_t { both, front, back };

/// The upright faces of a solid: see bendable_caps in bendable.hpp.
struct upright_faces {
    double walls = 0.0;   ///< the height of the walls, in the unit of depths
    double risers = 0.0;  ///< the height of other upright faces on the region's own edges, likewise
    bool apart = false;   ///< whether the walls stand elsewhere
};

/// The heights of a bevelled solid, in the unit of its depth. `in_front` selects one of its two sides.
///
///     high     front ____                  share 1 of the bevel's depth
///                  /      \                share 0
///                 |        |
///     low      back ______
struct bevel_heights {
    float depth = 0.0f;        ///< of the whole
    float bevel_depth = 0.0f;  ///< of one bevel
    bevel_sides sides = bevel_sides::both;
    bool centred = false;
    bool standing = false;  ///< whether the back is at 0

    [[nodiscard]] double high() const noexcept
    {
        return standing ? as_double(depth) : centred ? 0.5 * as_double(depth) : 0.0;
    }
    [[nodiscard]] double low() const noexcept { return high() - as_double(depth); }
    [[nodiscard]] bool is_bevelled(bool in_front) const noexcept
    {
        return sides != (in_front ? bevel_sides::back : bevel_sides::front);
    }

    /// The height of a share of a bevel's depth. The subtrahend is first rounded to a float, so that no compiler can
    /// fuse the two operations.
    [[nodiscard]] double at_share(bool in_front, float share) const noexcept
    {
        const auto down = static_cast<float>(as_double(bevel_depth) * (1.0 - as_double(share)));
        return in_front ? high() - as_double(down) : low() + as_double(down);
    }

    /// The height at which walls end that reach up to a share of the bevels' depth.
    [[nodiscard]] double rim(bool in_front, float wall) const noexcept
    {
        return is_bevelled(in_front) ? at_share(in_front, wall) : in_front ? high() : low();
    }
    [[nodiscard]] bool has_walls(float wall) const noexcept { return rim(true, wall) > rim(false, wall); }

    /// The height of walls from share 0, at most a bevel's depth. With `corners`, walls lower than the bevel may be
    /// raised, so plans depend on their height.
    [[nodiscard]] double thin_walls() const noexcept
    {
        const double walls = rim(true, 0.0f) - rim(false, 0.0f), thick = as_double(bevel_depth);
        return walls < thick ? walls : thick;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
