// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// How a corner is filled if edges move away from it and it is sharper than the mitre limit. `round`: an arc within the
/// region's tolerance, of at most 32 steps (with an unknown tolerance, as `bevelled`). `bevelled`: as few edges as keep
/// the limit.
enum class bevel_joins : std::uint8_t { round, bevelled };

/// The treatment of corners that edges move away from. The limit is for the letter's own corners. A corner that arises
/// during the move, where corners have met, may move farther.
struct corner_rule {
    bevel_joins joins = bevel_joins::round;
    float mitre_limit = 4.0f;  ///< at least 1; 0: none, except for needles' tips

    [[nodiscard]] bool is_valid() const noexcept
    {
        return is_finite(as_double(mitre_limit)) && (mitre_limit >= 1.0f || is_zero(mitre_limit));
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
