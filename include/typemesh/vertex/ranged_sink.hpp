// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/vertex/mesh_range.hpp>
#include <typemesh/vertex/mesh_sink.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A sink that can be written in subranges, in any order and by several threads at a time: what lies in memory can,
/// what must come in order (a file) cannot.
///
///     s.begin(exact)       first, as for every mesh_sink, by one thread
///     s.subrange(range)     a sink for that subrange alone, usable while s stays where it is. Its vertex() is called
///                          range.vertex_count times and its triangle() range.index_count / 3 times, each ascending;
///                          its begin() and end() never. The numbers that triangle() gets are written as they would be
///                          by s itself: those of the whole mesh, not of the subrange
///     s.end()              last, by one thread, when all subranges are written
///
/// Subranges of one mesh are disjoint and cover it. subrange() is const and may be called by several threads; sinks that
/// it gave share nothing that they change.
template <class S>
concept ranged_sink = mesh_sink<S> && requires(const S& s, mesh_range range) {
    { s.subrange(range) } noexcept -> mesh_sink;
    requires decltype(s.subrange(range))::wants == S::wants;
};

/// A ranged_sink for several meshes behind one another, each with indices from 0 on (see text/text_chunks.hpp).
///
///     s.begin_chunks(exact, most)    instead of begin(): the sizes of all meshes together, and how many vertices the
///                                    largest of them has
///     s.subrange(range)               one mesh; the numbers that triangle() gets are its own
template <class S>
concept chunked_sink = ranged_sink<S> && requires(S& s, mesh_size exact, std::uint32_t most) {
    { s.begin_chunks(exact, most) } noexcept -> std::same_as<error>;
};

}  // namespace typemesh::inline TYPEMESH_ABI
