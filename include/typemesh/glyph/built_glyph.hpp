// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/plan_scratch.hpp>
#include <typemesh/extrude/solid.hpp>

#include <cstddef>
#include <cstring>
#include <new>

namespace typemesh::inline TYPEMESH_ABI {

/// The result of building one glyph, while it is still in the builder's scratch memory: see glyph_builder.
struct glyph_draft {
    solid form;                          ///< the solid; all its arrays are empty for a blank glyph and for a refused
                                         ///< glyph
    solid_outline drawn;                 ///< the glyph as drawn, if a step has changed it; otherwise empty
    bool merged_as_drawn = false;        ///< whether `drawn` decides which glyphs are merged with it: see
                                         ///< stepped_region
    solid_plan plan;                     ///< the extruder's plan for writing it
    double cells = 512.0;                ///< its grid's cells per font unit
    error refusal;                       ///< the reason why the glyph cannot be built; error::none if it can be built,
                                         ///< or is blank
    const plan_scratch* data = nullptr;  ///< the extruder's plan data; null if it has none
};

/// All data of one glyph that do not depend on its place, in one block of memory that never changes once made.
///
///     block   [ built_glyph | plan data | points | starts | triangles | drawn points | drawn starts ]
///             [ built_glyph | error ]                 form() and merged_as_drawn() refer to the rest of it
///
/// A blank glyph has no points; a refused glyph carries its error, so requesting it again costs no more than any other
/// glyph. Any number of threads may read built glyphs.
class built_glyph {
public:
    /// The size of the block that a draft needs; its alignment is alignof(built_glyph).
    [[nodiscard]] static std::size_t bytes_for(const glyph_draft& draft) noexcept
    {
        if (draft.refusal) return sizeof(built_glyph) + sizeof(error);
        const solid& s = draft.form;
        const solid_outline drawn = draft.merged_as_drawn ? draft.drawn : solid_outline{};
        const std::size_t data = draft.data == nullptr ? 0 : draft.data->bytes();
        return sizeof(built_glyph) + data + s.points.size_bytes() + s.starts.size_bytes() + s.triangles.size_bytes() +
               drawn.points.size_bytes() + drawn.starts.size_bytes();
    }

    /// Copies a draft into a block of bytes_for(draft) bytes. Nothing needs to be destroyed later.
    [[nodiscard]] static built_glyph* make(void* block, const glyph_draft& draft) noexcept
    {
        return new (block) built_glyph{draft};
    }

    built_glyph(const built_glyph&) = delete;
    built_glyph& operator=(const built_glyph&) = delete;

    [[nodiscard]] const solid& form() const noexcept { return form_; }
    /// The loops of the glyph as drawn, if these decide which glyphs are merged with it; otherwise empty.
    [[nodiscard]] solid_outline merged_as_drawn() const noexcept
    {
        if (drawn_points_ == 0) return {};
        const auto* points = reinterpret_cast<const grid_point*>(drawn_);
        const auto* starts = reinterpret_cast<const std::uint32_t*>(points + drawn_points_);
        return {{points, drawn_points_}, {starts, drawn_starts_}};
    }
    [[nodiscard]] const part_sizes& sizes() const noexcept { return plan_.sizes; }

    /// The solid as it is passed back to the extruder that planned it.
    template <extruder Extruder>
    [[nodiscard]] planned_solid_of<Extruder> planned() const noexcept
    {
        return {{form_, plan_data_of<Extruder>::read_from(data())}, plan_};
    }
    /// Whether its bevel is narrower than requested: see solid_plan.
    [[nodiscard]] bool is_narrowed() const noexcept { return plan_.narrowed; }
    /// The number of its corners that were separated or joined: see contours::corners.
    [[nodiscard]] std::uint32_t corners_moved() const noexcept { return plan_.corners_moved; }
    /// Whether corners touch that should have been separated or joined.
    [[nodiscard]] bool is_touching() const noexcept { return plan_.touching; }
    /// The number of its components that have lost their caps: see solid_plan.
    [[nodiscard]] std::uint32_t lost_caps() const noexcept { return plan_.lost_caps; }
    /// The number of triangles of its caps that miss a refiner's aim: see solid_plan.
    [[nodiscard]] std::uint32_t kept_triangles() const noexcept { return plan_.kept_triangles; }
    [[nodiscard]] double cells() const noexcept { return cells_; }
    /// The size of the grid's cells, in font units.
    [[nodiscard]] double font_units_per_cell() const noexcept { return font_units_per_cell_; }

    /// The bounding box in the plane of everything that is written, in cells. Meaningless without points.
    [[nodiscard]] const box& around() const noexcept { return plan_.around; }
    /// This box in font units.
    [[nodiscard]] box ink() const noexcept
    {
        return {font_units_per_cell_ * plan_.around.low, font_units_per_cell_ * plan_.around.high};
    }
    /// The box that textures span, in font units.
    [[nodiscard]] box textured() const noexcept
    {
        const box& own = plan_.textured.empty() ? plan_.around : plan_.textured;
        return {font_units_per_cell_ * own.low, font_units_per_cell_ * own.high};
    }
    /// The bounding box of its points as drawn, in cells.
    [[nodiscard]] grid_point low() const noexcept { return low_; }
    [[nodiscard]] grid_point high() const noexcept { return high_; }

    /// The reason why it cannot be built, or none.
    [[nodiscard]] error refusal() const noexcept
    {
        return refused_ ? *reinterpret_cast<const error*>(this + 1) : error{};
    }
    /// Whether there is nothing to draw although the glyph was not refused.
    [[nodiscard]] bool is_blank() const noexcept { return form_.points.empty() && !refused_; }

private:
    explicit built_glyph(const glyph_draft& draft) noexcept
        : plan_{draft.plan}, cells_{draft.cells}, font_units_per_cell_{1.0 / draft.cells}, refused_{draft.refusal}
    {
        std::byte* free = reinterpret_cast<std::byte*>(this + 1);
        if (refused_) {
            static_assert(alignof(error) <= alignof(built_glyph), "an error lies right after its glyph");
            new (free) error{draft.refusal};
            return;
        }
        if (draft.data != nullptr) {
            draft.data->copy_to(free);
            free += draft.data->bytes();
        }
        form_.points = copied(draft.form.points, free);
        form_.starts = copied(draft.form.starts, free);
        form_.triangles = copied(draft.form.triangles, free);
        if (draft.merged_as_drawn) {
            drawn_ = free;
            drawn_points_ = static_cast<std::uint32_t>(copied(draft.drawn.points, free).size());
            drawn_starts_ = static_cast<std::uint32_t>(copied(draft.drawn.starts, free).size());
        }
        if (form_.points.empty()) return;
        set_box_of(form_.points);
        if (plan_.around.empty()) plan_.around = {placement::exact(low_), placement::exact(high_)};
        if (!draft.drawn.points.empty()) set_box_of(draft.drawn.points);
    }

    void set_box_of(array_view<const grid_point> points) noexcept
    {
        grid_point low = points.front(), high = low;
        for (const grid_point& p : points) {
            low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y};
            high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y};
        }
        low_ = low;
        high_ = high;
    }

    [[nodiscard]] const std::byte* data() const noexcept { return reinterpret_cast<const std::byte*>(this + 1); }

    template <class T>
    static array_view<const T> copied(array_view<const T> from, std::byte*& free) noexcept
    {
        static_assert(alignof(T) <= 4 && sizeof(T) % 4 == 0, "the arrays of a block follow each other without gaps");
        if (from.empty()) return {};
        std::memcpy(free, from.data(), from.size_bytes());
        const T* first = reinterpret_cast<const T*>(free);
        free += from.size_bytes();
        return {first, from.size()};
    }

    solid form_;
    const std::byte* drawn_ = nullptr;
    std::uint32_t drawn_points_ = 0, drawn_starts_ = 0;
    solid_plan plan_;
    double cells_;
    double font_units_per_cell_;
    grid_point low_, high_;
    bool refused_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
