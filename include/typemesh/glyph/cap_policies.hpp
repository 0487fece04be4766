// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/discretise/impl/discretiser_ref.hpp>
#include <typemesh/glyph/stage.hpp>
#include <typemesh/triangulate/impl/triangulator_ref.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The policies for building caps: one policy of each kind, and the observer of stages. The structure refers to them;
/// none is copied.
///
///     certified flatten;
///     monotone cut;
///     no_observer nobody;
///     const cap_policies with{flatten, cut, nobody};
struct cap_policies {
    discretiser_ref flatten;
    triangulator_ref cut;
    observer_ref observe;
};

}  // namespace typemesh::inline TYPEMESH_ABI
