// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/vertex/mesh_range.hpp>
#include <typemesh/vertex/mesh_sink.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A sink that can be written in subranges, in any order and by several threads at once: possible in memory, not where
/// output must come in order (a file).
///
///     s.begin(exact)       first, as for every mesh_sink, by one thread
///     s.subrange(range)    a sink for that subrange alone, usable while s stays where it is. Its vertex() is called
///                          range.vertex_count times and its triangle() range.index_count / 3 times, each ascending;
///                          its begin() and end() never. triangle() gets the same numbers, and writes the same indices,
///                          as that of s would: those of the whole mesh, not of the subrange
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
///     s.begin_chunks(exact, most)    instead of begin(): the sizes of all meshes together, and how many vertices the
///                                    largest of them has
///     s.subrange(range)              one mesh; the numbers that triangle() gets are its own
template <class S>
concept chunked_sink = ranged_sink<S> && requires(S& s, mesh_size exact, std::uint32_t most) {
    { s.begin_chunks(exact, most) } noexcept -> std::same_as<error>;
};

}  // namespace typemesh::inline TYPEMESH_ABI
