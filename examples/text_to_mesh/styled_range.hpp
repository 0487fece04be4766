// SPDX-License-Identifier: MIT
#pragma once

#include "model.hpp"

#include <typemesh/layout/style_spans.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace text_to_mesh {

/// What one --style requests.
struct styled_range {
    std::size_t first = 0, last = 0;  ///< characters of the text, from 0, the last one not included
    typemesh::text_style style;       ///< except for the three below
    std::vector<typemesh::feature> features;
    std::string language;
    std::optional<rgb_colour> colour;
};

/// "6..11:colour=#2060c0,underline". Gives an empty string, or what is wrong: "must ...".
[[nodiscard]] std::string read_styled_range(std::string_view written, styled_range& out);

/// Whether the ranges lie in the text and apart. Gives an empty string, or what is wrong.
[[nodiscard]] std::string refused_ranges(const std::vector<styled_range>& ranges, std::string_view text);

/// The style number of a range: none without a colour, else one more than the index of the first range of that colour.
[[nodiscard]] typemesh::style_id style_of(const std::vector<styled_range>& ranges, std::size_t range);

/// The ranges in bytes of the text, which must not be refused. They refer to the ranges.
[[nodiscard]] std::vector<typemesh::style_span> spans_of(const std::vector<styled_range>& ranges,
                                                         std::string_view text);

}  // namespace text_to_mesh
