// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/touching.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/corner_parting.hpp>
#include <typemesh/plate/cell_set.hpp>
#include <typemesh/plate/layer_arrangement.hpp>
#include <typemesh/plate/layered_solid.hpp>
#include <typemesh/plate/plate_options.hpp>
#include <typemesh/plate/plate_plane.hpp>
#include <typemesh/plate/silhouette.hpp>
#include <typemesh/plate/stencil_bridges.hpp>
#include <typemesh/triangulate/impl/triangulator_ref.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// The bevels and the fillet of a plate that was planned, in em.
struct plate_rims {
    float bevel = 0.0f;        ///< the narrowest bevel
    float fillet = 0.0f;       ///< the radius of the fillet
    std::uint32_t bevels = 0;  ///< the number of rims that were to be bevelled
};

/// A plate with a text: letters that stand on it, are engraved into it, are cut through it, or fill its pockets.
///
///     auto text = mesher.plan("Anna", {});                       // any text_plan
///     name_plate plate;
///     plate.plan(*text, {.style = plate_style::inlay, .margin = 0.2f, .radius = 0.1f}, constrained_delaunay{});
///     for (std::size_t k = 0; k < plate.solid_count(); ++k)      // two solids for an inlay, otherwise one
///         plate.write(k, into(vertices[k], indices[k]));
///
/// The plate's mesh stands where the text's own mesh would stand, in the text's unit and frame. The back of the plate
/// lies at height 0. Plate, letters and holes form one exact arrangement (layer_arrangement). So each solid is closed,
/// the two solids of an inlay have exactly the same points where they meet, and their areas add up to the plate's in
/// integers.
///
/// Memory is kept for the next plate. The text_plan is not needed any more after plan().
class name_plate {
public:
    // The layers of cells().
    static constexpr cell_set letters = cells_of_layer(0);  ///< the text
    static constexpr cell_set plate = cells_of_layer(1);    ///< the plate
    static constexpr cell_set holes = cells_of_layer(2);    ///< the holes in it
    static constexpr cell_set gaps = cells_of_layer(3);     ///< squares that separate touching corners
    static constexpr cell_set bridges = cells_of_layer(4);  ///< the bridges of a stencil

    name_plate(name_plate&&) = delete;  // its solids refer to its cells
    name_plate& operator=(name_plate&&) = delete;
    explicit name_plate(memory source = heap()) noexcept
        : space_{source},
          letters_{source},
          plate_{source},
          holes_{source},
          gaps_{source},
          bridges_{source},
          cells_{source},
          corners_{source},
          stencil_{source},
          solids_{layered_solid{source}, layered_solid{source}}
    {
    }

    /// Plans a plate for a text, with the shape that the options choose.
    ///
    /// Fails  error::bad_option: an option is outside its range, or the text has no glyphs ("text")
    ///        as resolve(), the triangulator and layered_solid::plan() do. There are then no solids
    /// Cost   a few resolve() of the whole text, and one triangulation for each level of each solid
    template <class Plan>
    [[nodiscard]] result<void> plan(const Plan& text, const plate_options& how, triangulator_ref cut) noexcept
    {
        return plan(text, text, how, cut, false);
    }

    /// Plans a plate that follows an outline: the union of another plan's letters, usually the same text bolder.
    ///
    ///     auto outline = bolder.plan("Anna", {.merge = true});   // its mesher has the step embolden{.by = 0.1f}
    ///     plate.plan(*text, *outline, {.fill_counters = true}, constrained_delaunay{});
    ///
    /// Both plans must have the same unit and the same text options. plate_options::margin and radius are not used.
    /// Two plans of one mesher are never valid together, so `outline` comes from a second mesher.
    template <class Plan, class Outline>
    [[nodiscard]] result<void> plan(const Plan& text, const Outline& outline, const plate_options& how,
                                    triangulator_ref cut) noexcept
    {
        return plan(text, outline, how, cut, true);
    }

    /// The number of solids: two for an inlay, otherwise one; none after an error. Solid 0 is the plate, solid 1 fills
    /// its pockets.
    [[nodiscard]] std::size_t solid_count() const noexcept { return count_; }
    /// A solid. k < solid_count().
    [[nodiscard]] const layered_solid& solid(std::size_t k) const noexcept
    {
        TYPEMESH_ASSERT(k < count_, "the plate has no solid of this number");
        return solids_[k];
    }

    /// Writes a solid. k < solid_count(). Fails as the sink does.
    template <class Sink>
        requires mesh_sink<std::remove_reference_t<Sink>>
    result<void> write(std::size_t k, Sink&& sink) const noexcept
    {
        return solid(k).write(sink, placement());
    }

    /// The position of its solids.
    [[nodiscard]] layered_placement placement() const noexcept { return {plane_.at, mirrored_}; }
    /// Output units per em.
    [[nodiscard]] double unit_per_em() const noexcept { return plane_.unit_per_em; }

    /// The arrangement of its layers, for own solids: see layered_solid.
    [[nodiscard]] layer_arrangement& cells() noexcept { return cells_; }
    [[nodiscard]] const layer_arrangement& cells() const noexcept { return cells_; }
    /// The cells of the plate without its holes.
    [[nodiscard]] static constexpr cell_set body() noexcept { return plate & ~holes; }
    /// The cells of the letters that are made: without gaps between touching corners, bridges and holes.
    [[nodiscard]] static constexpr cell_set text() noexcept { return letters & ~gaps & ~bridges & ~holes; }

    /// The number of corners that touched and were separated.
    [[nodiscard]] std::uint32_t corners_parted() const noexcept { return parted_; }
    /// The number of corners that still touch, counted once for each slab: all of them with touching::keep, otherwise
    /// those that no diamond could separate.
    [[nodiscard]] std::uint32_t corners_touching() const noexcept
    {
        std::uint32_t all = 0;
        for (std::size_t k = 0; k < count_; ++k) all += solids_[k].touching();
        return all;
    }
    /// The bridges of a stencil, and what they tie.
    [[nodiscard]] const stencil_report& stencil() const noexcept { return stencil_.report(); }
    /// The bridges, one by one.
    [[nodiscard]] array_view<const stencil_bar> stencil_bars() const noexcept { return stencil_.bars(); }
    /// What became of the bevels and of the fillet: what did not fit is narrower, or was left out.
    [[nodiscard]] const plate_rims& rims() const noexcept { return rims_; }
    /// Whether each solid is strictly 2-manifold: no edge has more than two faces, and no point several fans.
    [[nodiscard]] bool is_manifold() const noexcept
    {
        bool all = true;
        for (std::size_t k = 0; k < count_; ++k) all = all && solids_[k].touching() == 0 && solids_[k].hanging() == 0;
        return all;
    }

private:
    static constexpr std::uint32_t letter_layer = 0, plate_layer = 1, hole_layer = 2, gap_layer = 3, bridge_layer = 4;

    template <class Plan, class Outline>
    [[nodiscard]] error plan(const Plan& text, const Outline& outline, const plate_options& how, triangulator_ref cut,
                             bool follows) noexcept
    {
        count_ = 0;
        parted_ = 0;
        rims_ = {};
        stencil_.clear();
        if (error e = how.refused()) return e;
        const auto plane = plate_plane::of(outline, how.room());
        if (!plane) return plane.error();
        plane_ = *plane;
        mirrored_ = how.mirrored;
        if (error e = draw(text, outline, how, follows)) return e;
        return build(how, cut);
    }

    /// Draws the layers.
    template <class Plan, class Outline>
    [[nodiscard]] error draw(const Plan& text, const Outline& outline, const plate_options& how, bool follows) noexcept
    {
        for (silhouette* s : {&letters_, &plate_, &holes_, &gaps_, &bridges_}) s->begin(plane_);
        if (const auto done = letters_.add(text, plane_); !done) return done.error();
        if (const auto done = letters_.fill(space_, how.corners, how.max_pieces); !done) return done.error();
        if (letters_.empty()) return error::bad("text");
        if (follows) {
            if (const auto done = plate_.add(outline, plane_); !done) return done.error();
            if (const auto done = plate_.fill(space_, how.corners, how.max_pieces); !done) return done.error();
            if (how.fill_counters)
                if (const auto done = plate_.fill_holes(space_, how.max_pieces); !done) return done.error();
            if (plate_.empty()) return error::bad("text");
        } else {
            const std::int32_t margin = in_cells(how.margin);
            const grid_point low = letters_.low(), high = letters_.high();
            if (const auto done =
                    plate_.add_rectangle({low.x - margin, low.y - margin}, {high.x + margin, high.y + margin},
                                         in_cells(how.radius), arc_tolerance());
                !done)
                return done.error();
            if (plate_.empty()) return error::bad("margin");
        }
        if (how.ring_hole > 0.0f)
            if (error e = draw_ring(how)) return e;
        return {};
    }

    /// Adds a ring with a hole at the leftmost place of the plate; for a rectangle, in the middle of its side.
    [[nodiscard]] error draw_ring(const plate_options& how) noexcept
    {
        const std::int32_t hole = in_cells(how.ring_hole), width = in_cells(how.ring_width);
        std::int64_t sum = 0, count = 0;
        const std::int32_t left = plate_.low().x;
        for (const grid_point p : plate_.points()) {
            sum += p.x == left ? p.y : 0;
            count += p.x == left;
        }
        const grid_point centre{left - hole, static_cast<std::int32_t>(sum / count)};
        if (const auto done = plate_.add_disc(centre, hole + width, arc_tolerance()); !done) return done.error();
        if (const auto done = plate_.fill(space_, how.corners, how.max_pieces); !done) return done.error();
        return holes_.add_disc(centre, hole, arc_tolerance()).error();
    }

    [[nodiscard]] error build(const plate_options& how, triangulator_ref cut) noexcept
    {
        if (error e = arrange(how)) return e;
        if (how.bridge_width > 0.0f && how.style == plate_style::cut)
            if (error e = tie_islands(how)) return e;
        if (error e = slabs_of(how)) return e;
        if (how.corners != touching::keep)
            if (error e = part_corners(how)) return e;
        return plan_solids(cut);
    }

    /// Adds bridges until no island is loose, or no more can be added.
    [[nodiscard]] error tie_islands(const plate_options& how) noexcept
    {
        const grid_point low = plate_.low(), high = plate_.high();
        const std::int32_t longest = high.x - low.x > high.y - low.y ? high.x - low.x : high.y - low.y;
        const std::int32_t wanted = in_cells(how.bridge_width), narrow = wanted < longest ? wanted : longest,
                           width = narrow > 1 ? narrow : 1;
        bool more = true;
        for (int round = 0; more && round < stencil_bridges::max_rounds; ++round) {
            const auto added =
                stencil_.tie(cells_, body() & ~text(), outer_rim_, {width, how.bridges}, bridges_, space_);
            if (!added) return added.error();
            more = *added;
            if (!more) break;
            if (const auto filled = bridges_.fill(space_, touching::keep, how.max_pieces); !filled)
                return filled.error();
            if (error e = arrange(how)) return e;
        }
        return more ? stencil_.count(cells_, body() & ~text(), outer_rim_, space_).error() : error{};
    }

    /// Makes the arrangement of all layers as they are now.
    [[nodiscard]] error arrange(const plate_options& how) noexcept
    {
        cells_.begin(plane_.cells);
        const auto add = [this](const silhouette& s, std::uint32_t layer) noexcept {
            return cells_.add(s.points(), s.starts(), layer).error();
        };
        if (error e = add_plate(true)) return e;
        outer_rim_ = cells_.source_count();
        if (error e = add_plate(false)) return e;
        if (error e = add(holes_, hole_layer)) return e;
        rim_ = cells_.source_count();
        if (error e = add(letters_, letter_layer)) return e;
        if (error e = add(gaps_, gap_layer)) return e;
        if (error e = add(bridges_, bridge_layer)) return e;
        return cells_.cut(space_, how.max_pieces).error();
    }
    /// Adds the outer loops of the plate, or its holes.
    [[nodiscard]] error add_plate(bool outer) noexcept
    {
        const auto starts = plate_.starts();
        for (std::uint32_t k = 0; k + 1 < starts.size(); ++k) {
            if (plate_.is_outer(k) != outer) continue;
            const std::uint32_t own[2] = {0, starts[k + 1] - starts[k]};
            if (const auto done = cells_.add(plate_.points().subspan(starts[k], own[1]), own, plate_layer); !done)
                return done.error();
        }
        return {};
    }

    /// The slabs of its solids. Fails with error::bad_option ("depth") if floats do not tell their heights apart.
    [[nodiscard]] error slabs_of(const plate_options& how) noexcept
    {
        const auto height = [this](float em) noexcept {
            return static_cast<float>(as_double(em) * plane_.unit_per_em);
        };
        const float face = height(how.thickness), floor = height(how.thickness - how.depth),
                    upper = height(how.thickness + how.depth);
        const bool through = !(floor > 0.0f), stands = how.style == plate_style::standing;
        if (how.style != plate_style::cut && !(stands ? upper > face : floor < face)) return error::bad("depth");
        used_[0] = used_[1] = 0;
        for (layered_base& b : base_) b = {0.0f, how.bevel, how.round_bevels, plane_.unit_per_em, arc_tolerance()};
        const auto add = [this](std::size_t k, const layered_solid::slab& s) noexcept { slabs_[k][used_[k]++] = s; };
        switch (how.style) {
        case plate_style::standing:
            add(0, {body() | text(), face, how.bevel});
            add(0, {text(), upper, how.bevel, how.fillet});
            break;
        case plate_style::engraved:
        case plate_style::inlay:
            if (!through) add(0, {body(), floor});
            if (how.style == plate_style::engraved) {
                add(0, {body() & ~text(), face, how.bevel});
                break;
            }
            if (through) base_[0].bevel = 0.0f;  // the solids tile only without
            add(0, {body() & ~text(), face, how.bevel, 0.0f, body()});
            base_[1].height = through ? 0.0f : floor;
            base_[1].bevel = 0.0f;
            add(1, {body() & text(), face});
            break;
        case plate_style::cut: add(0, {body() & ~text(), face, how.bevel}); break;
        }
        return {};
    }

    /// Finds the points where the cells of a slab touch, once for each slab.
    [[nodiscard]] error find_corners() noexcept
    {
        corners_.clear();
        bool ok = true;
        for (std::size_t k = 0; k < 2; ++k)
            for (std::uint32_t i = 0; i < used_[k]; ++i)
                cells_.each_touching(slabs_[k][i].filled,
                                     [&](grid_point p) noexcept { ok = ok && corners_.push_back(p); });
        return ok ? error{} : error{error::out_of_memory};
    }

    /// Removes a small diamond from the letters around each point where the cells of a slab touch, until none is left.
    /// What still touches after the last round is known from corners_touching().
    [[nodiscard]] error part_corners(const plate_options& how) noexcept
    {
        constexpr int rounds = 8;
        auto size = static_cast<std::int32_t>(corner_parting::reach(plane_.cells));
        std::uint32_t found = 0;
        for (int round = 0; round <= rounds; ++round, size *= 2) {
            if (error e = find_corners()) return e;
            const auto left = static_cast<std::uint32_t>(corners_.size());
            if (round == 0) found = left;
            parted_ = found > left ? found - left : 0;
            if (left == 0 || round == rounds) return {};
            for (const grid_point p : corners_)
                if (const auto done = gaps_.add_diamond(p, size); !done) return done.error();
            if (const auto done = gaps_.fill(space_, touching::keep, how.max_pieces); !done) return done.error();
            if (error e = arrange(how)) return e;
        }
        return {};
    }

    [[nodiscard]] error plan_solids(triangulator_ref cut) noexcept
    {
        const std::size_t count = used_[1] != 0 ? 2 : 1;
        for (std::size_t k = 0; k < count; ++k)
            if (const auto done = solids_[k].plan(cells_, base_[k], {slabs_[k], used_[k]}, rim_, cut, space_); !done)
                return done.error();
        count_ = count;
        report_rims();
        return {};
    }

    /// Finds the narrowest bevel, and the fillet.
    void report_rims() noexcept
    {
        rims_ = {};
        const layered_solid& made = solids_[0];
        const auto note = [this](float wanted, float reached) noexcept {
            if (!(wanted > 0.0f)) return;
            rims_.bevel = rims_.bevels++ != 0 && rims_.bevel < reached ? rims_.bevel : reached;
        };
        note(base_[0].bevel, made.lower_bevel());
        for (std::uint32_t k = 0; k < used_[0]; ++k) {
            note(slabs_[0][k].bevel, made.bevel(k));
            if (slabs_[0][k].fillet > 0.0f) rims_.fillet = made.fillet(k);
        }
    }

    /// A length in cells, at most the grid's reach: a plate is never larger.
    [[nodiscard]] std::int32_t in_cells(float em) const noexcept
    {
        const double cells = std::nearbyint(as_double(em) * plane_.cells.cells);
        return static_cast<std::int32_t>(cells < -grid::reach  ? -grid::reach
                                         : cells > grid::reach ? grid::reach
                                                               : cells);
    }
    /// The deviation of arcs, in cells: 1/800 em.
    [[nodiscard]] double arc_tolerance() const noexcept { return plane_.cells.cells / 800.0; }

    workspace space_;
    plate_plane plane_;
    silhouette letters_, plate_, holes_, gaps_, bridges_;
    layer_arrangement cells_;
    buffer<grid_point> corners_;
    stencil_bridges stencil_;
    layered_solid solids_[2];
    layered_solid::slab slabs_[2][2];
    layered_base base_[2];
    plate_rims rims_;
    std::uint32_t used_[2] = {};
    std::uint32_t outer_rim_ = 0, rim_ = 0, parted_ = 0;  // sources below outer_rim_ are the plate's outer loops,
                                                          // those below rim_ are all its loops
    std::size_t count_ = 0;
    bool mirrored_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI
