// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/policy_key.hpp>
#include <typemesh/discretise/discretise.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Refers to a discretiser of any type, which must outlive it. One indirect call flattens a whole outline: the loops
/// over its curves and points are compiled for the discretiser's own type.
class discretiser_ref {
public:
    /// There is one table for each type of discretiser.
    struct calls {
        error (*flatten)(const void* how, const outline& curves, double tolerance, contours& out,
                         array_view<const std::uint8_t> halvings) noexcept;
        policy_key (*key)(const void* how) noexcept;
        bool keeps_tolerance;
    };
    template <discretiser D>
    struct table {
        static const calls of;
    };

    template <discretiser D>
    discretiser_ref(const D& how) noexcept : discretiser_ref{&how, table<D>::of}
    {
    }
    discretiser_ref(const void* how, const calls& does) noexcept : how_{how}, does_{&does} {}

    /// Calls discretise().
    [[nodiscard]] error flatten(const outline& curves, double tolerance, const grid& cells, contours& out,
                                array_view<const std::uint8_t> halvings = {}) const noexcept
    {
        out.grid = cells;
        return does_->flatten(how_, curves, tolerance, out, halvings);
    }
    [[nodiscard]] bool keeps_tolerance() const noexcept { return does_->keeps_tolerance; }
    [[nodiscard]] policy_key key() const noexcept { return does_->key(how_); }

private:
    const void* how_;
    const calls* does_;
};

template <discretiser D>
constinit const discretiser_ref::calls discretiser_ref::table<D>::of = {
    [](const void* how, const outline& curves, double tolerance, contours& out,
       array_view<const std::uint8_t> halvings) noexcept {
        const grid cells = out.grid;
        return discretise(curves, *static_cast<const D*>(how), tolerance, cells, out, halvings).error();
    },
    [](const void* how) noexcept { return key_of(*static_cast<const D*>(how)); }, typemesh::keeps_tolerance<D>};

}  // namespace typemesh::inline TYPEMESH_ABI
