// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// How a corner is filled that edges move away from and that is sharper than the mitre limit: by an arc within the
/// region's tolerance, but of 32 steps at most (where the tolerance is unknown as by `bevelled`), or by as few edges as
/// keep the limit.
enum class bevel_joins : std::uint8_t { round, bevelled };

/// What becomes of the corners that edges move away from. The limit is that of the corners of the letter; one that
/// arises on the way, where corners have met, may move farther.
struct corner_rule {
    bevel_joins joins = bevel_joins::round;
    float mitre_limit = 4.0f;  ///< at least 1; 0: none, but for needles' tips

    [[nodiscard]] bool is_valid() const noexcept
    {
        return is_finite(as_double(mitre_limit)) && (mitre_limit >= 1.0f || is_zero(mitre_limit));
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
