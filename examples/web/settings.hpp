// SPDX-License-Identifier: MIT
#pragma once

#include "bends.hpp"
#include "text_to_mesh/options.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace typemesh_web {

/// What a mesher is to do: the options of text_to_mesh, and what stands for their defaults.
struct settings {
    text_to_mesh::options chosen;
    std::u16string ellipsis;
    std::vector<float> profile;  ///< of bevel.points, two a point
    std::optional<float> bevel_depth;
    std::optional<double> letter_spacing;
    std::optional<bool> merge;
    bends bend;
    bool letters = false;  ///< whether vertices know their letters
    bool cached = true;
    bool markup = false;  ///< whether tags in the text are read

    /// `chosen` with all that follows from the rest, as text_to_mesh has it: bevels are as deep as wide; letters with
    /// bevels, rings or moved edges are merged, and stand as much farther apart as they have become wider.
    [[nodiscard]] text_to_mesh::options settled() const;

    /// One sentence if the options cannot be had together, else null.
    [[nodiscard]] const char* refused() const noexcept;
};

enum class option_kind : std::uint8_t { number, boolean, choice, string, numbers, features };

/// One of the options: its name, and how it is set.
struct option {
    const char* name;
    option_kind kind;
    const char* choices = "";                  ///< with "|" between; the first is the default
    const char* usual = "";                    ///< the default of a number or a boolean; empty: it follows from others
    void (*set)(settings&, double) = nullptr;  ///< to a number, to 0 or 1, to the number of a choice, or add a number
    void (*set_text)(settings&, std::u16string_view) = nullptr;
};

/// All options. Their places in it are their numbers.
[[nodiscard]] std::span<const option> all_options();

/// Adds an OpenType feature of four letters.
void add_feature(settings& to, const char (&tag)[5], std::uint32_t value);

/// Sets "bevel.width=0.02", "bevel.profile=round", "features=smcp:1", as on a command line. Gives whether there is such
/// an option, and the value suits it.
[[nodiscard]] bool set_by_name(settings& to, std::string_view written);

}  // namespace typemesh_web
