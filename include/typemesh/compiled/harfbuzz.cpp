// SPDX-License-Identifier: MIT
#include <typemesh/compiled/harfbuzz.hpp>

namespace typemesh::inline TYPEMESH_ABI {

template result<harfbuzz_mesher::plan_type> harfbuzz_mesher::plan_text(text_view, const text_options&,
                                                                       harfbuzz_worker&) noexcept;
template result<harfbuzz_mesher::plan_type> harfbuzz_mesher::plan_run(const glyph_run&, const text_options&,
                                                                      harfbuzz_worker&) noexcept;

template error discretise(const outline&, const certified&, double, const grid&, contours&,
                          std::span<const std::uint8_t>) noexcept;
template result<region> cap_builder::prove(const monotone&) noexcept;
template result<region> resolve(contours&, fill_rule, workspace&, accept_all_intersections&,
                                const resolve_options&) noexcept;
template result<region> resolve(contours&, fill_rule, workspace&, crossing_refinement&,
                                const resolve_options&) noexcept;
template error cut_region(const region&, const monotone&, workspace&, triangle_list&) noexcept;

}  // namespace typemesh::inline TYPEMESH_ABI
