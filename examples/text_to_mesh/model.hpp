// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace text_to_mesh {

/// One vertex as the file formats want it: 32 bytes, no padding.
struct model_vertex {
    float position[3];
    float normal[3];  ///< of unit length, away from the solid
    float uv[2];
};

/// A colour in sRGB.
struct rgb_colour {
    unsigned char rgb[3];
    unsigned char alpha = 255;

    friend bool operator==(const rgb_colour&, const rgb_colour&) noexcept = default;
};

/// A finished mesh. Three indices per triangle, counter-clockwise seen from outside; right-handed, y up.
struct model {
    /// A run of indices that share a material: "front", "back", "side", "front_bevel", "back_bevel"; of the letter within
    /// a ring, which is a solid of its own, "letter_front", "letter_back", "letter_side". With a colour of their own
    /// they have its name at the end: "front_red", "front_2060c0". Of a plate the letters are "front" and "side", the
    /// plate is "plate_front", "plate_back", "plate_side", "cut_side", what is engraved "pocket_front" and "pocket_side";
    /// of an inlay the two solids are "plate" and "inlay".
    struct part {
        std::string name;
        std::size_t first_index;
        std::size_t index_count;
        unsigned solid = 0;                     ///< 1: the letter within a ring, or an inlay
        std::optional<rgb_colour> colour = {};  ///< of its own; else the usual one
        bool is_named = false;  ///< the name ends in one of its own, "front_style7", also without a colour
        std::optional<std::size_t> ramp = {};  ///< the gradient that u runs along; `colour` is its mean

        /// The name without a colour's: "front".
        [[nodiscard]] std::string_view kind() const
        {
            return std::string_view{name}.substr(0, colour || is_named ? name.rfind('_') : name.size());
        }
    };

    /// The colours of a gradient, a texture of one row: u from 0 to 1.
    struct ramp {
        enum class wrap { clamp, repeat, mirror };
        std::vector<rgb_colour> texels;
        wrap beyond;
    };

    /// One of the different letters of an instanced model: consecutive vertices and consecutive parts.
    struct letter {
        std::string name;
        std::size_t first_vertex;
        std::size_t vertex_count;
        std::size_t first_part;
        std::size_t part_count;
        bool again = false;  ///< the vertices and indices of the letter before it, with parts of other colours
    };

    /// Where a letter stands, and what of the text it shows.
    struct place {
        std::size_t letter;
        float at[3];
        std::string text = {};
        float right[2] = {1.0f, 0.0f};  ///< where its x axis points; letters on a path are turned
        std::optional<std::array<std::uint32_t, 3>> numbers = {};  ///< of the letter, its word and its line
    };

    /// What a vertex knows of its letter. A bar's letter and word are -1.
    struct vertex_letter {
        float letter, word, line;
        float pivot[3];  ///< in the space of the vertices
    };

    std::vector<model_vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<part> parts;  ///< together all the indices; none at all stands for one nameless part
    std::vector<ramp> ramps;
    std::vector<letter> letters;  ///< none: the model is one mesh, and stands where its vertices say
    bool as_manifold = false;     ///< the file is to say how the mesh is a 2-manifold
    bool has_levels = false;  ///< the letters are levels of detail of one mesh, the finest first; there are no places
    std::vector<place> places;
    std::vector<vertex_letter> vertex_letters;  ///< one for each vertex, or none at all
    std::vector<std::string> letter_texts;      ///< what each letter of vertex_letters shows
    std::vector<std::string> solid_names;       ///< of solids that are objects of their own in a file, or none
    std::string name;                           ///< UTF-8, best effort: writers replace what their format cannot hold
};

/// Lines and dots drawn over a picture, in the model's own space; a solid in front of them hides them.
struct overlay {
    struct segment {
        float a[3];
        float b[3];
        unsigned char rgb[3];
    };
    struct dot {
        float p[3];
        unsigned char rgb[3];
        float radius_px;
    };

    std::vector<segment> segments;
    std::vector<dot> dots;
};

}  // namespace text_to_mesh
