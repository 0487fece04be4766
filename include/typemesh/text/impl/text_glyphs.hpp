// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/extrude/cap_maker.hpp>
#include <typemesh/extrude/placement.hpp>
#include <typemesh/glyph/built_glyph.hpp>
#include <typemesh/glyph/impl/glyph_store.hpp>
#include <typemesh/glyph/impl/pinned_glyphs.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/text/drawn_glyph.hpp>
#include <typemesh/text/impl/glyph_set.hpp>
#include <typemesh/text/impl/merged_glyphs.hpp>
#include <typemesh/text/impl/run_glyph_styles.hpp>
#include <typemesh/text/impl/text_letters.hpp>
#include <typemesh/text/impl/turned.hpp>
#include <typemesh/text/instances.hpp>
#include <typemesh/text/text_options.hpp>
#include <typemesh/text/text_report.hpp>
#include <typemesh/vertex/affine3.hpp>
#include <typemesh/vertex/bounds3.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The common data of the placements of all glyphs of a text.
struct text_placement {
    double units_per_em = 1000.0;
    double em_per_font_unit = 1e-3;
    double unit_per_font_unit = 1.0;  ///< output units per font unit
    double unit_per_em = 1000.0;
    double unit_per_depth = 1000.0;  ///< output units per unit of an extruder's depths
    double em_per_depth = 1.0;
    point centre;                 ///< the output's origin, in font units
    point texture_per_font_unit;  ///< growth of u and v over the whole text's box, with texture_box::text
    texture_box texture_over = texture_box::text;
    typemesh::frame frame;

    /// The map of the unit square to a box that is given in em of a run; see lettered_plan::each_moved_box().
    [[nodiscard]] affine3 map_of(const affine& box, double run_units_per_em) const noexcept
    {
        const double em = run_units_per_em > 0.0 ? run_units_per_em : 1.0;
        const auto direction = [&](point p) noexcept {
            const point v = em * unit_per_font_unit * p;
            return frame(static_cast<float>(v.x), static_cast<float>(v.y), 0.0f);
        };
        const point from = unit_per_font_unit * (em * point{box.dx, box.dy} - centre);
        return {direction({box.xx, box.yx}), direction({box.xy, box.yy}), frame.toward,
                frame(static_cast<float>(from.x), static_cast<float>(from.y), 0.0f)};
    }
};

/// Detects whether the text_glyphs of a plan still hold the same content: every clear() and every move, out of them or
/// into them, changes the number.
struct plan_generation {
    std::uint64_t number = 0;

    plan_generation() noexcept = default;
    plan_generation(plan_generation&& other) noexcept : number{other.number++} {}
    plan_generation& operator=(plan_generation&& other) noexcept
    {
        number += ++other.number;
        return *this;
    }
};

/// Detects whether glyphs stored elsewhere still exist: another plan changes the number.
struct lent_glyphs {
    const std::uint64_t* now = nullptr;  ///< null: nothing is stored elsewhere
    std::uint64_t then = 0;

    [[nodiscard]] bool are_there() const noexcept { return now == nullptr || *now == then; }
};

/// All data of one text: its different glyphs, each built once, and its drawn glyphs, each at its position. A plan
/// measures them and write() reads them.
struct text_glyphs {
    glyph_set different;            ///< the glyphs that the text needs
    pinned_glyphs pinned;           ///< the built glyphs, blank and refused ones included
    buffer<std::uint32_t> numbers;  ///< for each glyph of the run, its number among the different glyphs
    /// Where a glyph stands in the text.
    struct glyph_place {
        solid_place place;
        cluster_id cluster;
        std::uint32_t glyph;  ///< its index in the run
    };

    buffer<glyph_place> places;  ///< of the different glyphs that differ from place to place: the last ones
    double em_per_depth = 1.0;   ///< of all glyphs' places
    double em_per_font_unit = 0.0;
    bool in_place = false;            ///< whether all do; then no glyph is drawn twice
    buffer<glyph_stand> stands;       ///< of the run's glyphs, if an outline step places them
    bool turned = false;              ///< whether it moves and turns those that it does not warp
    glyph_store store;                ///< holds the glyphs that neither a cache nor a glyph_workers keeps
    lent_glyphs lent;                 ///< the glyphs that a glyph_workers keeps
    merged_glyphs merged;             ///< glyphs that are drawn together
    buffer<std::uint32_t> mesh_of;    ///< for each of the different glyphs, its mesh, or drawn_glyph::none
    buffer<glyph_mesh> meshes;        ///< the meshes of the drawn glyphs
    run_glyph_styles glyph_styles;    ///< how they are drawn
    buffer<drawn_glyph> records;      ///< the drawn glyphs, style by style
    buffer<style_id> several_styles;  ///< the styles of the records, ascending; empty if there is at most one
    buffer<box> line_boxes;           ///< in font units; only for texture_box::line
    box ink;                          ///< of all records, in font units
    box textured;                     ///< the box that textures span, in font units; differs from ink for bent letters
    part_sizes totals;
    text_placement placed;
    text_report report;
    bounds3 bounds;
    plan_generation generation;
    text_letters letters;  ///< found on request; see letters_are_found()

    explicit text_glyphs(memory source) noexcept
        : different{source},
          pinned{source},
          numbers{source},
          places{source},
          stands{source},
          store{source},
          merged{source},
          mesh_of{source},
          meshes{source},
          glyph_styles{source},
          records{source},
          several_styles{source},
          line_boxes{source},
          letters{source}
    {
    }

    /// Whether an outline step warps a glyph of the run, which then stands where it was laid out.
    [[nodiscard]] bool is_warped(std::size_t glyph) const noexcept { return !stands.empty() && stands[glyph].warped; }

    /// The place of one of the different glyphs, if it has one.
    [[nodiscard]] const glyph_place* place_of(std::size_t number) const noexcept
    {
        const std::size_t first = different.keys().size() - places.size();
        return number < first ? nullptr : &places[number - first];
    }

    /// Whether `letters` belongs to these glyphs.
    [[nodiscard]] bool letters_are_found() const noexcept { return letters.found_for == generation.number; }

    /// The letter of a record; not_a_letter for bars, and if letters were not found.
    [[nodiscard]] std::uint32_t letter_of(std::size_t record) const noexcept
    {
        if (!letters_are_found()) return not_a_letter;
        const std::uint32_t row = letters.row_of[record];
        return row < letters.letters ? row : not_a_letter;
    }

    void clear() noexcept
    {
        different.clear();
        pinned.clear();
        numbers.clear();
        places.clear();
        in_place = false;
        stands.clear();
        turned = false;
        em_per_depth = 1.0;
        em_per_font_unit = 0.0;
        store.clear();
        lent = {};
        merged.clear();
        mesh_of.clear();
        meshes.clear();
        glyph_styles.clear();
        records.clear();
        several_styles.clear();
        line_boxes.clear();
        ink = {};
        textured = {};
        totals = {};
        report = {};
        bounds = {};
        ++generation.number;
    }

    /// Reserves space for that many glyphs of the run. False if out of memory.
    [[nodiscard]] bool reserve_records(std::size_t count) noexcept
    {
        const std::size_t kinds = different.keys().size();
        if (!records.reserve(count) || !meshes.reserve(kinds + merged.groups.size()) || !mesh_of.reserve(kinds))
            return false;
        for (std::size_t i = 0; i < kinds; ++i) mesh_of.push_back_unchecked(drawn_glyph::none);
        return true;
    }

    /// Places a glyph that is neither blank nor refused, after reserve_records(). `number` is its number among the
    /// different glyphs; merged glyphs make their own mesh. Sets the members that depend on other records (mesh,
    /// next_alike, before). Records are placed style by style, ascending.
    ///
    /// Fails with error::too_large if 32 bits do not suffice, or with error::out_of_memory
    error place_glyph(drawn_glyph& s, std::uint32_t number) noexcept
    {
        const part_sizes& sizes = s.built->sizes();
        if (!(totals.total() + sizes.total()).fits_32_bits()) return error::too_large;
        if (!records.empty() && records.back().style != s.style) {
            if (several_styles.empty() && !several_styles.push_back(records.back().style)) return error::out_of_memory;
            if (!several_styles.push_back(s.style)) return error::out_of_memory;
        }
        s.before = totals;
        const auto self = static_cast<std::uint32_t>(records.size());
        const bool merges = s.merged != drawn_glyph::none;
        s.mesh = merges ? drawn_glyph::none : mesh_of[number];
        if (s.mesh == drawn_glyph::none) {
            s.mesh = static_cast<std::uint32_t>(meshes.size());
            const glyph_id id = merges ? no_glyph : s.id;
            meshes.push_back_unchecked({.built = s.built, .id = id, .first_glyph = self, .last_glyph = self});
            if (!merges) mesh_of[number] = s.mesh;
        }
        glyph_mesh& mesh = meshes[s.mesh];
        if (mesh.glyph_count++ != 0) records[mesh.last_glyph].next_alike = self;
        mesh.last_glyph = self;
        records.push_back_unchecked(s);
        totals = totals + sizes;
        return {};
    }

    /// After all are placed: finds the start of each mesh and of its instances.
    void number_meshes() noexcept
    {
        std::uint32_t vertex = 0, index = 0, instance = 0;  // no larger than the text's own
        for (glyph_mesh& m : meshes) {
            m.first_vertex = vertex;
            m.first_index = index;
            m.first_instance = instance;
            const mesh_size own = m.built->sizes().total();
            vertex += static_cast<std::uint32_t>(own.vertices);
            index += static_cast<std::uint32_t>(own.indices());
            instance += m.glyph_count;
        }
    }

    /// The styles of the drawn glyphs, ascending.
    [[nodiscard]] array_view<const style_id> styles() const noexcept
    {
        if (!several_styles.empty() || records.empty()) return several_styles.view();
        return {&records[0].style, 1};
    }

    /// The first record of a style or of a later one.
    [[nodiscard]] std::size_t first_of(style_id style) const noexcept
    {
        return first_where(0, records.size(), [&](std::size_t i) noexcept { return records[i].style >= style; });
    }
    /// The first record of a later style.
    [[nodiscard]] std::size_t last_of(style_id style) const noexcept
    {
        return first_where(0, records.size(), [&](std::size_t i) noexcept { return records[i].style > style; });
    }

    /// A glyph's own box, in font units, relative to the text's origin.
    [[nodiscard]] static box ink_of(const drawn_glyph& s) noexcept
    {
        const box own = turned_box(s.built->ink(), s.right);
        return {s.origin + own.low, s.origin + own.high};
    }
    /// Whether a path turns a glyph. One comparison suffices for most texts.
    [[nodiscard]] bool turns(const drawn_glyph& s) const noexcept { return turned && is_turned(s.right); }

    /// A glyph's own box that textures span, likewise; in the flat text, if a path turns the glyph.
    [[nodiscard]] static box textured_of(const drawn_glyph& s) noexcept
    {
        const box own = s.built->textured();
        return {s.flat + own.low, s.flat + own.high};
    }

    /// The box that textures span, in em.
    [[nodiscard]] box textured_in_em() const noexcept
    {
        return {placed.em_per_font_unit * textured.low, placed.em_per_font_unit * textured.high};
    }

    /// The place for a solid with this origin, in font units.
    [[nodiscard]] solid_place place_at(point origin) const noexcept
    {
        return {em_per_font_unit * origin, em_per_depth};
    }

    [[nodiscard]] placement place(const drawn_glyph& s) const noexcept
    {
        point low = textured.low, per_font_unit = placed.texture_per_font_unit;
        if (placed.texture_over != texture_box::text) {
            const box over = placed.texture_over == texture_box::line ? line_boxes[s.line] : textured_of(s);
            low = over.low;
            per_font_unit = texture_over(over);
        }
        placement at = place(*s.built, s.origin, placed.centre, low, per_font_unit);
        if (turned) {
            at.em_pen = s.built->cells() * s.flat;
            at.texture_pen = s.built->cells() * (s.flat - low);
            turn(at, s.right);
        }
        at.glyph = s.merged == drawn_glyph::none ? s.id : no_glyph;
        at.cluster = s.cluster;
        at.style = s.style;
        return at;
    }

    /// A mesh by itself, at the output's origin: textures span its own box. Solids that were planned in place stay
    /// there.
    [[nodiscard]] placement place(const glyph_mesh& m) const noexcept
    {
        if (in_place) return place(records[m.first_glyph]);
        const box own = m.built->ink();
        placement at = place(*m.built, {}, {}, own.low, texture_over(own));
        at.glyph = m.id;
        return at;
    }

    /// The shape of a mesh of these glyphs, which come from this run.
    [[nodiscard]] glyph_shape shape_of(std::size_t mesh, const glyph_run& run) const noexcept
    {
        const drawn_glyph& s = records[meshes[mesh].first_glyph];
        if (s.merged != drawn_glyph::none || place_of(numbers[s.glyph]) != nullptr) return {};
        if (run.glyph_styles.empty()) return {.id = s.id};
        const glyph_style& drawn = run.glyph_styles[run.glyphs[s.glyph].glyph_style];
        return {s.id, drawn.face, drawn.map};
    }

    /// The growth of u and v per font unit if they span a box; 0 where it has no extent.
    [[nodiscard]] static point texture_over(const box& b) noexcept
    {
        return {b.width() > 0.0 ? 1.0 / b.width() : 0.0, b.height() > 0.0 ? 1.0 / b.height() : 0.0};
    }

    /// The translation of a record's glyph from the place of its separate mesh.
    [[nodiscard]] vec3 translation_of(const drawn_glyph& s) const noexcept
    {
        if (in_place) return {};
        placement at;
        at.unit_per_cell = placed.unit_per_font_unit;
        at.pen = s.origin - placed.centre;
        at.frame = placed.frame;
        return at.position(grid_point{}, 0.0f);
    }

private:
    /// No division here, because this runs for each part of each glyph. Cells are a power of two, so multiplying by
    /// them or by their inverse is exact.
    [[nodiscard]] placement place(const built_glyph& built, point origin, point centre, point texture_low,
                                  point texture_per_font_unit) const noexcept
    {
        const double cells = built.cells(), per_cell = built.font_units_per_cell();
        placement at;
        at.pen = cells * (origin - centre);
        at.unit_per_cell = placed.unit_per_font_unit * per_cell;
        at.unit_per_depth = placed.unit_per_depth;
        at.em_per_depth = placed.em_per_depth;
        at.em_per_cell = placed.em_per_font_unit * per_cell;
        at.em_pen = cells * origin;
        at.texture_pen = cells * (origin - texture_low);
        at.texture_per_cell = per_cell * texture_per_font_unit;
        at.frame = placed.frame;
        return at;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
