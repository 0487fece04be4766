// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The stages of a text, in order. `idle` comes when a call of the mesher ends.
enum class stage : std::uint8_t { shape, outline, discretise, fill, triangulate, extrude, idle };

/// Called at every change of stage, for profilers and statistics: observe(stage) noexcept. It should be cheap, as there
/// are about six calls per glyph.
///
/// A triangulator that proves (see triangulate/triangulator.hpp) does fill's work on most glyphs: that counts as
/// triangulate.
template <class O>
concept stage_observer = requires(O& observe, stage now) {
    { observe(now) } noexcept;
};

/// The null observer.
struct no_observer {
    constexpr void operator()(stage) const noexcept {}
};

}  // namespace typemesh::inline TYPEMESH_ABI
