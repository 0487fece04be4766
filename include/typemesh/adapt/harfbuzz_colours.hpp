// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/colour/colour_tables.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/result.hpp>

#include <hb.h>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// Holds the colour tables of a font of HarfBuzz, for colour_outlines::use(). It reads the bytes only: HarfBuzz need
/// not know colour fonts (4.0 and later will do). It must outlive what uses tables().
class harfbuzz_colours {
public:
    /// The tables of a font, with the place on its axes as it is now. Fonts without colours give empty tables.
    ///
    /// Fails  error::out_of_memory
    [[nodiscard]] static result<harfbuzz_colours> of(const harfbuzz_font& font, memory source = heap()) noexcept
    {
        harfbuzz_colours made{source};
        hb_face_t* const face = hb_font_get_face(font.handle());
        made.colr_ = hb_face_reference_table(face, HB_TAG('C', 'O', 'L', 'R'));
        made.cpal_ = hb_face_reference_table(face, HB_TAG('C', 'P', 'A', 'L'));
        unsigned count = 0;
        const int* const axes = hb_font_get_var_coords_normalized(font.handle(), &count);
        for (unsigned i = 0; i < count; ++i)
            if (!made.axes_.push_back(axes[i])) return error::out_of_memory;
        for (const hb_tag_t tag : {HB_TAG('C', 'B', 'D', 'T'), HB_TAG('s', 'b', 'i', 'x'), HB_TAG('E', 'B', 'D', 'T')})
            made.has_bitmaps_ = made.has_bitmaps_ || has(face, tag);
        made.has_drawings_ = has(face, HB_TAG('S', 'V', 'G', ' '));
        return result<harfbuzz_colours>{std::move(made)};
    }

    harfbuzz_colours(harfbuzz_colours&& other) noexcept : axes_{other.axes_.source()} { swap(other); }
    harfbuzz_colours& operator=(harfbuzz_colours&& other) noexcept
    {
        swap(other);
        return *this;
    }
    ~harfbuzz_colours()
    {
        hb_blob_destroy(colr_);
        hb_blob_destroy(cpal_);
    }

    /// The tables, which refer to this object.
    [[nodiscard]] colour_tables tables() const noexcept
    {
        return {bytes_of(colr_), bytes_of(cpal_), axes_.view(), has_bitmaps_, has_drawings_};
    }

private:
    explicit harfbuzz_colours(memory source) noexcept : axes_{source} {}

    void swap(harfbuzz_colours& other) noexcept
    {
        std::swap(colr_, other.colr_);
        std::swap(cpal_, other.cpal_);
        axes_.swap(other.axes_);
        std::swap(has_bitmaps_, other.has_bitmaps_);
        std::swap(has_drawings_, other.has_drawings_);
    }

    [[nodiscard]] static array_view<const std::byte> bytes_of(hb_blob_t* blob) noexcept
    {
        unsigned size = 0;
        const char* const data = hb_blob_get_data(blob, &size);
        return {static_cast<const std::byte*>(static_cast<const void*>(data)), size};
    }
    [[nodiscard]] static bool has(hb_face_t* face, hb_tag_t tag) noexcept
    {
        hb_blob_t* const blob = hb_face_reference_table(face, tag);
        const bool found = hb_blob_get_length(blob) != 0;
        hb_blob_destroy(blob);
        return found;
    }

    hb_blob_t* colr_ = nullptr;
    hb_blob_t* cpal_ = nullptr;
    buffer<std::int32_t> axes_;
    bool has_bitmaps_ = false, has_drawings_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI
