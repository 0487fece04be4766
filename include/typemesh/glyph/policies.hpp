// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/glyph/cap_policies.hpp>
#include <typemesh/glyph/impl/outline_step_ref.hpp>
#include <typemesh/glyph/impl/region_step_ref.hpp>
#include <typemesh/glyph/impl/solid_ref.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The policies for building a glyph: one of each kind, the observer of stages, the step before the solid, and the
/// step after the font, if any. The structure refers to them; none is copied.
///
///     certified flatten;
///     monotone cut;
///     flat raise;
///     no_observer nobody;
///     const policies with{flatten, cut, raise, nobody};
struct policies {
    discretiser_ref flatten;
    triangulator_ref cut;
    solid_ref raise;
    observer_ref observe;
    region_step_ref step = {};
    outline_step_ref warp = {};  ///< the step after the font, if any

    /// The policies that caps need.
    operator cap_policies() const noexcept { return {flatten, cut, observe}; }
};

}  // namespace typemesh::inline TYPEMESH_ABI
