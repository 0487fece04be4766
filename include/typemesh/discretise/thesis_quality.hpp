// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/option_bits.hpp>
#include <typemesh/discretise/adaptive_subdivision.hpp>
#include <typemesh/discretise/discretiser.hpp>
#include <typemesh/discretise/two_lines.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A discretiser with the four qualities of the thesis, exactly as published, for a font with `units_per_em` units per
/// em:
///
///     low      two_lines
///     normal   adaptive_subdivision, 5 levels, 0.5 of 64 units per em
///     high     15 levels, 0.1
///     best     15 levels, 0.005
///
///     auto mesher = text_mesher{font}.with(thesis_quality{thesis_quality::high, font.units_per_em()});
///
/// The tolerance argument is ignored, and no tolerance is kept (see adaptive_subdivision).
///
/// From "Study of mesh generation and optimization techniques applied to parametric forms", J. Vandenbergh, 2020,
/// 4.4.3.
class thesis_quality {
public:
    /// The four qualities of the thesis, coarse to fine.
    enum preset : std::uint8_t { low, normal, high, best };
    static constexpr bool keeps_no_tolerance = true;

    thesis_quality(preset quality, double units_per_em) noexcept
        : quality_{quality}, halving_{halving(quality, units_per_em)}
    {
    }

    /// See option_bits.
    [[nodiscard]] option_bits cache_key() const noexcept
    {
        option_bits bits = halving_.cache_key();
        bits.words[3] = quality_;
        return bits;
    }

    template <class Curve, class Put>
    void operator()(const Curve& c, double tolerance, Put&& put) const noexcept
    {
        if (quality_ == low)
            two_lines{}(c, tolerance, put);
        else
            halving_(c, tolerance, put);
    }

private:
    [[nodiscard]] static adaptive_subdivision halving(preset quality, double units_per_em) noexcept
    {
        if (quality == high) return adaptive_subdivision::high(units_per_em);
        if (quality == best) return adaptive_subdivision::best(units_per_em);
        return adaptive_subdivision::normal(units_per_em);
    }

    preset quality_;
    adaptive_subdivision halving_;
};
static_assert(discretiser<thesis_quality>);

}  // namespace typemesh::inline TYPEMESH_ABI
