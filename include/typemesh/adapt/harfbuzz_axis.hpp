// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/adapt/impl/harfbuzz_axis_regions.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/variation_axis.hpp>

#include <hb-ot.h>
#include <hb.h>

#include <cstdint>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// One axis of a variable font through HarfBuzz, for axis_morph. See variation_axis.
///
///     auto font = harfbuzz_font::open("Inter.var.ttf");
///     auto weight = harfbuzz_axis::open(*font, "wght");      // 100 to 900
///
/// It has a font of its own, with the other axes where the given font has them. Positions of masters come from the
/// font's tables. It shares the face, so it may outlive the given font. Move-only; used by one thread at a time.
///
/// HarfBuzz 6.0 rounds advances to whole font units. Pens between two masters then differ from its pens by up to half a
/// unit per glyph.
class harfbuzz_axis {
public:
    /// `source` gives the memory of the axis; HarfBuzz has its own.
    ///
    /// Fails  error::unknown_variation: the font has no such axis
    ///        error::out_of_memory, and the errors of harfbuzz_font::wrap()
    static result<harfbuzz_axis> open(const harfbuzz_font& font, const char (&tag)[5], memory source = heap()) noexcept
    {
        hb_face_t* face = hb_font_get_face(font.handle());
        hb_ot_var_axis_info_t info;
        if (!hb_ot_var_find_axis_info(face, hb_tag_from_string(tag, 4), &info)) return error::no_axis(tag);

        hb_font_t* own = hb_font_create(face);
        int x = 0, y = 0;
        hb_font_get_scale(font.handle(), &x, &y);
        hb_font_set_scale(own, x, y);
        auto wrapped = harfbuzz_font::wrap(own);
        hb_font_destroy(own);  // the wrapper has its own reference
        if (!wrapped) return wrapped.error();

        harfbuzz_axis made{std::move(*wrapped), info, source};
        int* coordinates = made.coordinates_.append(hb_ot_var_get_axis_count(face));
        if (coordinates == nullptr || made.normalised_.append(made.coordinates_.size()) == nullptr)
            return error::out_of_memory;
        unsigned given = 0;
        const int* from = hb_font_get_var_coords_normalized(font.handle(), &given);
        for (unsigned i = 0; i < made.coordinates_.size(); ++i) coordinates[i] = i < given ? from[i] : 0;
        if (error e = made.move_to(coordinates[info.axis_index])) return e;
        return result<harfbuzz_axis>{std::move(made)};
    }

    [[nodiscard]] double low() const noexcept { return as_double(info_.min_value); }
    /// The value where the axis changes nothing.
    [[nodiscard]] double usual() const noexcept { return as_double(info_.default_value); }
    [[nodiscard]] double high() const noexcept { return as_double(info_.max_value); }

    /// The coordinate of a value, by HarfBuzz; 'avar' is applied. Allocates nothing.
    [[nodiscard]] axis_coordinate coordinate(double value) noexcept
    {
        const hb_variation_t wanted{info_.tag, static_cast<float>(value)};
        int* const all = normalised_.data();
        hb_ot_var_normalize_variations(hb_font_get_face(font_.handle()), &wanted, 1, all,
                                       static_cast<unsigned>(normalised_.size()));
        return all[info_.axis_index];
    }

    /// See variation_axis.
    ///
    /// Fails  error::not_a_font: more than 1024 coordinates, or a damaged table; error::out_of_memory
    /// Cost   proportional to the sizes of the variation tables
    error append_masters(buffer<axis_coordinate>& out) const noexcept
    {
        return detail::harfbuzz_axis_regions{hb_font_get_face(font_.handle()), info_.axis_index, out}.read_masters();
    }
    /// See variation_axis. Fails and costs likewise.
    error append_changes(buffer<axis_coordinate>& out) const noexcept
    {
        return detail::harfbuzz_axis_regions{hb_font_get_face(font_.handle()), info_.axis_index, out}.read_changes();
    }

    /// Moves the font to a coordinate of the axis. It never fails.
    error move_to(axis_coordinate c) noexcept
    {
        coordinates_[info_.axis_index] = c;
        hb_font_set_var_coords_normalized(font_.handle(), coordinates_.data(),
                                          static_cast<unsigned>(coordinates_.size()));
        return {};
    }

    /// The font at the coordinate of the last move_to().
    [[nodiscard]] harfbuzz_font& font() noexcept { return font_; }

private:
    harfbuzz_axis(harfbuzz_font font, const hb_ot_var_axis_info_t& info, memory source) noexcept
        : font_{std::move(font)}, info_{info}, coordinates_{source}, normalised_{source}
    {
    }

    harfbuzz_font font_;
    hb_ot_var_axis_info_t info_;
    buffer<int> coordinates_;
    buffer<int> normalised_;  // for coordinate()
};

static_assert(variation_axis<harfbuzz_axis>);

}  // namespace typemesh::inline TYPEMESH_ABI
