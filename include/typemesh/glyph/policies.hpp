// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/discretise/discretiser.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/glyph/stage.hpp>
#include <typemesh/triangulate/triangulator.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// What a glyph is built with: one policy of each kind, and the observer of stages. It refers to them; none is copied.
///
///     certified flatten;
///     monotone cut;
///     flat raise;
///     no_observer nobody;
///     const policies with{flatten, cut, raise, nobody};
template <discretiser Discretiser, triangulator Triangulator, extruder Extruder, stage_observer Observer>
struct policies {
    const Discretiser& flatten;
    const Triangulator& cut;
    const Extruder& raise;
    Observer& observe;
};

template <class Discretiser, class Triangulator, class Extruder, class Observer>
policies(const Discretiser&, const Triangulator&, const Extruder&, Observer&)
    -> policies<Discretiser, Triangulator, Extruder, Observer>;

}  // namespace typemesh::inline TYPEMESH_ABI
