// SPDX-License-Identifier: MIT
#include <typemesh/compiled/harfbuzz.hpp>

namespace typemesh::inline TYPEMESH_ABI {

template result<harfbuzz_mesher::plan_type> harfbuzz_mesher::plan_text(text_view, const text_options&,
                                                                       harfbuzz_worker&) noexcept;
template result<harfbuzz_mesher::plan_type> harfbuzz_mesher::plan_run(const glyph_run&, const text_options&,
                                                                      harfbuzz_worker&) noexcept;

}  // namespace typemesh::inline TYPEMESH_ABI
