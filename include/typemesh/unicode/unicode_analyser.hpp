// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/impl/basic_analyser.hpp>
#include <typemesh/unicode/impl/line_opportunities.hpp>
#include <typemesh/unicode/text_analyser.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The algorithms of Unicode 17.0, without a library and without dictionaries: UAX #9, #14, #24 and #29. The results
/// are the same on all systems; `language` is not used. The memory is kept for the next text.
///
/// Cost   O(n) time; 15 bytes for each character of the longest paragraph, 42 more if some are read to the left
class unicode_analyser : public basic_analyser<line_opportunities> {
public:
    using basic_analyser::basic_analyser;
};
static_assert(text_analyser<unicode_analyser>);

}  // namespace typemesh::inline TYPEMESH_ABI
