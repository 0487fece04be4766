// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/impl/basic_analyser.hpp>
#include <typemesh/unicode/text_analyser.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// For basic_analyser: finds no place where a line may end.
struct no_line_ends {
    static constexpr bool finds_any = false;  ///< whether it finds places at all

    no_line_ends(const character*, std::size_t) noexcept {}
};

/// Finds what unicode_analyser finds, except for line ends: text_mark::may_break, must_break and
/// text_analysis::unbroken. It is for text whose lines end only at line breaks. Text of printable ASCII needs no table
/// of Unicode.
///
/// Cost   O(n); for ASCII a few instructions for each character
class bidi_analyser : public basic_analyser<no_line_ends> {
public:
    using basic_analyser::basic_analyser;
};
static_assert(text_analyser<bidi_analyser>);

}  // namespace typemesh::inline TYPEMESH_ABI
