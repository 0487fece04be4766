// SPDX-License-Identifier: MIT

// The room as it is without 128-bit integers of the compiler, in a namespace of its own.

#include <typemesh/core/version.hpp>

#undef TYPEMESH_ABI
#define TYPEMESH_ABI without_int128
#undef __SIZEOF_INT128__

#include "offset/swept_hash.hpp"

#include <type_traits>

static_assert(std::is_same_v<typemesh::detail::int128, typemesh::detail::two_word_integer>);

std::uint64_t test::hash_without_int128() { return hash_of_stars().value; }
