// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/extrude/part_sizes.hpp>
#include <typemesh/extrude/solid.hpp>

#include <cstddef>
#include <cstring>
#include <new>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// What building one glyph gave, while it still lies in the builder's scratch memory: see glyph_builder.
struct glyph_draft {
    solid form;           ///< all empty for a blank glyph and for one that is refused
    part_sizes sizes;     ///< what the extruder will write of it
    double cells = 512.0; ///< its grid's cells a font unit
    error refusal;        ///< why the glyph cannot be built; none when it can, or is blank
};

/// Everything of one glyph that does not depend on where it stands, in one block of memory, never changed once made.
///
///     block   [ built_glyph | points | starts | triangles | sides ]      form() refers to the rest of the block
///
/// A blank glyph has a shape without points, a refused one carries its error: asking again costs no more than for
/// others. Shapes may be read from any number of threads.
class built_glyph {
public:
    /// How long a block the parts need; alignof(built_glyph) is its alignment.
    [[nodiscard]] static std::size_t bytes_for(const glyph_draft& parts) noexcept
    {
        const solid& s = parts.form;
        return sizeof(built_glyph) + s.points.size_bytes() + s.starts.size_bytes() + s.triangles.size_bytes() +
               s.sides.size_bytes();
    }

    /// Copies the parts into a block of bytes_for(parts) bytes. Nothing needs to be destroyed later.
    [[nodiscard]] static built_glyph* make(void* block, const glyph_draft& parts) noexcept
    {
        return new (block) built_glyph{parts};
    }

    built_glyph(const built_glyph&) = delete;
    built_glyph& operator=(const built_glyph&) = delete;

    /// As its extruder gets it back.
    [[nodiscard]] const solid& form() const noexcept { return form_; }
    [[nodiscard]] const part_sizes& sizes() const noexcept { return sizes_; }
    [[nodiscard]] planned_solid planned() const noexcept { return {form_, sizes_}; }
    [[nodiscard]] double cells() const noexcept { return cells_; }
    [[nodiscard]] double font_units_per_cell() const noexcept { return font_units_per_cell_; }

    /// The box around its points, in cells and in font units. Nothing sensible without points.
    [[nodiscard]] grid_point low() const noexcept { return low_; }
    [[nodiscard]] grid_point high() const noexcept { return high_; }
    [[nodiscard]] const box& ink() const noexcept { return ink_; }

    /// Why it cannot be built, or none.
    [[nodiscard]] const error& refusal() const noexcept { return refusal_; }
    /// Without anything to draw, and not refused.
    [[nodiscard]] bool is_blank() const noexcept { return form_.points.empty() && !refusal_; }

private:
    explicit built_glyph(const glyph_draft& parts) noexcept
        : sizes_{parts.sizes}, cells_{parts.cells}, font_units_per_cell_{1.0 / parts.cells}, refusal_{parts.refusal}
    {
        std::byte* free = reinterpret_cast<std::byte*>(this + 1);
        form_.points = copied(parts.form.points, free);
        form_.starts = copied(parts.form.starts, free);
        form_.triangles = copied(parts.form.triangles, free);
        form_.sides = copied(parts.form.sides, free);
        if (form_.points.empty()) return;
        low_ = high_ = form_.points.front();
        for (const grid_point p : form_.points) {
            low_ = {p.x < low_.x ? p.x : low_.x, p.y < low_.y ? p.y : low_.y};
            high_ = {p.x > high_.x ? p.x : high_.x, p.y > high_.y ? p.y : high_.y};
        }
        const grid g{cells_};
        ink_ = {g.place(low_), g.place(high_)};
    }

    template <class T>
    static std::span<const T> copied(std::span<const T> from, std::byte*& free) noexcept
    {
        static_assert(alignof(T) <= 4 && sizeof(T) % 4 == 0, "the pieces of a block follow each other without gaps");
        if (from.empty()) return {};
        std::memcpy(free, from.data(), from.size_bytes());
        const T* first = reinterpret_cast<const T*>(free);
        free += from.size_bytes();
        return {first, from.size()};
    }

    solid form_;
    part_sizes sizes_;
    double cells_;
    double font_units_per_cell_;
    grid_point low_, high_;
    box ink_;
    error refusal_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
