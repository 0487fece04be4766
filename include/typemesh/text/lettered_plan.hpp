// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/executor.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/inline_box_place.hpp>
#include <typemesh/text/box_on_stand.hpp>
#include <typemesh/text/impl/letter_finder.hpp>
#include <typemesh/text/impl/lettered_sink.hpp>
#include <typemesh/text/text_letter.hpp>
#include <typemesh/vertex/mesh_sink.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// The part of a text_plan that knows letters: it finds them, gives them to vertices, and moves them while they are
/// written. A program that does not use letters pays nothing.
///
///     auto plan = mesher.plan(text);
///     auto found = plan->find_letters(text);
///     plan->write(sink, [t](const letter_place& l) noexcept {                      // as often as you like, each frame
///         return turned({0, 0, 1}, t * l.index).about(l.letter.pivot);
///     });
///
/// letter_motions.hpp has ready motions. Finding letters and writing with a motion use the mesher's memory, so only one
/// thread at a time may do it. Writing allocates nothing.
template <class Plan>
class lettered_plan {
public:
    /// Finds the letters of the plan: the graphemes, words, lines and paragraphs of its glyphs. Call it once for each
    /// plan, before letters() and before vertices or motions need letters.
    ///
    ///     text    the text of the plan; for a run, the text to which its clusters refer. It is not kept. If glyphs
    ///             were removed from the run, their text counts for the letter before them
    ///
    /// Fails  error::bad_option "text": a cluster lies beyond the text; or "pivot"; error::too_large;
    ///        error::out_of_memory; the letters are then unknown
    /// Cost   O(n log n) for n units and glyphs
    result<void> find_letters(text_view text, const letter_options& options = {}) const noexcept
    {
        (void)self().fresh();
        const error e = letter_finder{*self().glyphs_, *self().run_, options}(text, solid_ref{self().extruder_});
        if (!e) return {};
        self().glyphs_->letters.forget();
        return e;
    }

    /// The letters, in reading order, and their words, lines and paragraphs. Needs find_letters().
    [[nodiscard]] letter_rows letters() const noexcept
    {
        const text_letters& found = known();
        const auto rows = found.rows.view();
        return {rows.first(found.letters), rows.subspan(found.letters), found.words.view(),
                found.lines.view(),        found.paragraphs.view(),     found.whole,
                found.grapheme_count};
    }

    /// The letter of a glyph of the plan: its number, or not_a_letter for a bar. Needs find_letters().
    [[nodiscard]] std::uint32_t letter_of(std::size_t glyph) const noexcept
    {
        (void)known();
        return self().fresh().letter_of(glyph);
    }

    /// The row of a glyph of the plan: one of letters().letters or of letters().bars. Needs find_letters().
    [[nodiscard]] const text_letter& row_of(std::size_t glyph) const noexcept
    {
        const text_letters& found = known();
        return found.rows[found.row_of[glyph]];
    }

    /// Writes the mesh with moved letters: positions by the motion's map, normals by its inverse transpose, and the
    /// corners of triangles in the order that keeps them outside. Texture coordinates and letter data stay. Sizes and
    /// ranges stay as the plan says. Letters with the identity are written bit for bit as without a motion. A map that
    /// flattens a letter flattens its triangles, too: this hides a letter. Without find_letters(): unknown_letters.
    template <class Sink, letter_motion Motion>
        requires mesh_sink<std::remove_reference_t<Sink>>
    result<void> write(Sink&& sink, Motion&& motion) const noexcept
    {
        return self().write(moved(sink, motion));
    }

    /// Writes it with several workers. One worker calls the motion, before the others begin.
    template <class Sink, letter_motion Motion, executor Executor>
        requires ranged_sink<std::remove_reference_t<Sink>>
    result<void> write(Sink&& sink, Motion&& motion, Executor& workers) const noexcept
    {
        return self().write(moved(sink, motion), workers);
    }

    // Refuses a motion that may throw.
    template <class Sink, class Motion>
        requires(mesh_sink<std::remove_reference_t<Sink>> && !letter_motion<Motion> &&
                 std::is_invocable_v<Motion&, const letter_place&>)
    result<void> write(Sink&&, Motion&&) const noexcept
    {
        static_assert(std::is_nothrow_invocable_v<Motion&, const letter_place&>,
                      "typemesh: the function that moves letters must be noexcept: "
                      "`[](const letter_place& l) noexcept { return affine3{...}; }`.");
        static_assert(letter_motion<Motion>, "typemesh: the function that moves letters returns an affine3.");
        return error::bad_option;
    }

    /// Gives put(const glyph_instance&, const affine3&) what write_instances(put) gives, and the map of the instance's
    /// mesh to its place: the translation, then the motion of its letter. Instances that are mirrored need triangles
    /// whose corners are swapped.
    template <letter_motion Motion, class Put>
    void write_instances(Motion&& motion, Put&& put) const noexcept
    {
        (void)known();
        const text_letters& found = move_all(motion);
        self().write_instances([&](const glyph_instance& drawn) noexcept {
            const letter_move* move = found.move_of(drawn.glyph);
            const affine3 placed{drawn.x, drawn.y, drawn.z, drawn.translation};
            put(drawn, move == nullptr || move->is_identity() ? placed : move->map() * placed);
        });
    }

    /// Gives put(const inline_box_place&, const affine3&) each inline box of the text, and the map of a mesh of the
    /// caller's to its moved place, in the output's unit: the square from (0, 0, 0) to (1, 1, 0) to the box, and
    /// (0, 0, 1) to one unit toward the viewer. A box is a letter of its own for the motion. Boxes stand where a path
    /// puts them; other warps and bends leave them where they are in the flat text. Needs find_letters().
    template <letter_motion Motion, class Put>
    void each_moved_box(Motion&& motion, Put&& put) const noexcept
    {
        (void)known();
        const text_letters& found = move_all(motion);
        if (found.moves.empty()) return;
        each_box_on_stand(*self().run_, self().glyphs_->stands.view(), [&](const inline_box_place& box) noexcept {
            const letter_move& move = found.moves[found.row_at(box.unit)];
            const affine3 placed = self().glyphs_->placed.map_of(box.map, self().run_->units_per_em);
            put(box, move.is_identity() ? placed : move.map() * placed);
        });
    }

    /// The box of all moved vertices. Zero for an empty mesh. It may be larger than the vertices need: it holds the
    /// moved box of each letter.
    template <letter_motion Motion>
    [[nodiscard]] bounds3 moved_bounds(Motion&& motion) const noexcept
    {
        (void)known();
        const text_letters& found = move_all(motion);
        bounds3 all;
        bool is_first = true;
        for (std::size_t i = 0; i < found.moves.size(); ++i) {
            if (found.rows[i].bonds == letter_bond::inline_box) continue;
            const bounds3 own = found.moves[i](found.rows[i].bounds);
            if (is_first) all = own;
            is_first = false;
            all.add(own.low);
            all.add(own.high);
        }
        return all;
    }

    /// The sink behind a motion: for what else takes a sink. It is valid until the letters are moved again.
    template <class Sink, letter_motion Motion>
    [[nodiscard]] moved_sink<Sink&> moved(Sink& sink, Motion& motion) const noexcept
    {
        return {sink, move_all(motion)};
    }

private:
    [[nodiscard]] const Plan& self() const noexcept { return static_cast<const Plan&>(*this); }

    [[nodiscard]] const text_letters& known() const noexcept
    {
        TYPEMESH_ASSERT(self().fresh().letters_are_found(),
                        "letters were requested before find_letters(text) of this plan has found them");
        return self().fresh().letters;
    }

    /// Asks the motion once for each letter, if they have been found.
    template <class Motion>
    const text_letters& move_all(Motion& motion) const noexcept
    {
        text_letters& found = self().glyphs_->letters;
        found.moves.clear();
        if (!self().fresh().letters_are_found()) return found;
        for (std::size_t i = 0; i < found.rows.size(); ++i)
            found.moves.push_back_unchecked(letter_move{motion(found.place(i, self().glyphs_->placed.frame))});
        return found;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
