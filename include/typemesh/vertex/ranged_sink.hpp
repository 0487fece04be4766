// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/vertex/mesh_range.hpp>
#include <typemesh/vertex/mesh_sink.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A sink that can be written in subranges, in any order and by several threads at once. This is possible in memory,
/// but not where output must be sequential, as in a file.
///
///     s.begin(exact)       first, as for every mesh_sink, by one thread
///     s.subrange(range)    a sink for only this subrange, usable while s stays in place. Its vertex() is called
///                          range.vertex_count times and its triangle() range.index_count / 3 times, each ascending;
///                          its begin() and end() are never called. triangle() gets the numbers that s.triangle() would
///                          get, and writes the same indices: they number the vertices of the whole mesh, not of the
///                          subrange
///     s.end()              last, by one thread, when all subranges are written
///
/// The subranges of one mesh are disjoint and cover it. subrange() is const and may be called by several threads; the
/// sinks that it returns share no mutable state.
template <class S>
concept ranged_sink = mesh_sink<S> && requires(const S& s, mesh_range range) {
    { s.subrange(range) } noexcept -> mesh_sink;
    requires decltype(s.subrange(range))::wants == S::wants;
};

/// A ranged_sink for several consecutive meshes, each with indices from 0 (see text/text_chunks.hpp).
///
///     s.begin_chunks(exact, most)    instead of begin(): the total size of all meshes, and the number of vertices of
///                                    the largest one
///     s.subrange(range)              one mesh; triangle() gets this mesh's own numbers
template <class S>
concept chunked_sink = ranged_sink<S> && requires(S& s, mesh_size exact, std::uint32_t most) {
    { s.begin_chunks(exact, most) } noexcept -> std::same_as<error>;
};

}  // namespace typemesh::inline TYPEMESH_ABI
