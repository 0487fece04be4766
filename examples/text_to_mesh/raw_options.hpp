// SPDX-License-Identifier: MIT
#pragma once

#include "chosen_plate.hpp"

#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace text_to_mesh {

/// What the command line gives before it is settled: words that become something else, and what was given at all.
struct raw_options {
    plate_words plate;
    std::vector<std::string> variations, features, show;
    std::string uv, fill, fit, lod, morph, tube, stroke, colour_layers, profile = "chamfer", refine, bend, path, family,
                                                                        format, anchor, origin;
    std::optional<typemesh::touching> corners;
    std::optional<double> size, bevel_depth, bevel_steps, letter_spacing;
    bool no_merge = false;
    std::vector<std::string> given;  ///< the options that are given: "--font"; also "TEXT"
};

[[nodiscard]] inline bool is_given(const raw_options& raw, std::string_view option)
{
    return std::find(raw.given.begin(), raw.given.end(), option) != raw.given.end();
}

/// The first of some options that is given, or an empty string.
[[nodiscard]] inline std::string first_given(const raw_options& raw, std::initializer_list<const char*> some)
{
    const auto found = std::find_if(some.begin(), some.end(), [&raw](const char* one) { return is_given(raw, one); });
    return found == some.end() ? std::string{} : *found;
}

struct options;

/// Takes steps until one gives a sentence of what is wrong; the others give an empty string.
template <class... Steps>
[[nodiscard]] std::string settle_all(options& out, const raw_options& raw, Steps... steps)
{
    std::string trouble;
    (void)((trouble = steps(out, raw)).empty() && ...);
    return trouble;
}

}  // namespace text_to_mesh
