// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/mixed_key.hpp>
#include <typemesh/extrude/bevel_profile.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A profile of your own points, which it holds.
///
///     bevelled<polyline_profile>{.profile = {{{0, 0}, {0.2f, 0.8f}, {1, 1}}}}
///     polyline_profile{profile_points{my_span}}
///
/// Two of them have one key with odds of about 2^-128, so that no cache mistakes one for another.
struct polyline_profile {
    profile_points points;

    [[nodiscard]] option_bits cache_key() const noexcept
    {
        option_bits bits;
        bits.words[0] = points.view().size();
        bits.words[2] = 0x6A09'E667'F3BC'C908u;  // two hashes that start apart
        bits.words[3] = 0xBB67'AE85'84CA'A73Bu;
        for (const profile_point p : points.view()) {
            for (const float number : {p.t, p.h}) {
                const std::uint64_t value = option_bits{number}.words[0];
                bits.words[2] = mixed_key(bits.words[2], value);
                bits.words[3] = mixed_key(bits.words[3], ~value);
            }
        }
        return bits;
    }
    void operator()(const profile_scale&, profile_points& out) const noexcept { out = points; }
};
static_assert(bevel_profile<polyline_profile>);

}  // namespace typemesh::inline TYPEMESH_ABI
