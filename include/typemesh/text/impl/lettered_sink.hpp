// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/text/impl/text_glyphs.hpp>
#include <typemesh/vertex/ranged_sink.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// A sink that moves letters: a moved_sink.
template <class Sink>
concept moves_letters = requires(Sink& sink) { sink.inner(); };

/// Adds the letter data that a sink wants to the vertices of one glyph.
template <class Sink>
struct letter_namer {
    static constexpr attribute wants = Sink::wants;

    Sink& to;
    const text_letter& row;
    std::uint32_t letter;

    error begin(mesh_size exact) noexcept { return to.begin(exact); }
    void vertex(const surface_point<wants>& s) noexcept
    {
        surface_point<wants> named = s;
        if constexpr (has(wants, attribute::letter)) named.letter = letter;
        if constexpr (has(wants, attribute::word)) named.word = row.word;
        if constexpr (has(wants, attribute::line)) named.line = row.line;
        if constexpr (has(wants, attribute::pivot)) named.pivot = row.pivot;
        if constexpr (has(wants, attribute::extent)) named.extent = row.extent;
        to.vertex(named);
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept { to.triangle(a, b, c); }
    void end() noexcept {}
};

/// error::unknown_letters if a sink moves letters, or wants their data, and they have not been found.
template <class Sink>
[[nodiscard]] error refused_letters(const text_glyphs& all) noexcept
{
    if constexpr (moves_letters<Sink> || has(Sink::wants, letter_attributes))
        return all.letters_are_found() ? error{} : error{error::unknown_letters};
    else
        return {};
}

/// Calls write(sink, placement), with a sink that adds the letter data of a glyph if the sink wants any.
template <class Sink, class Write>
void write_named(const text_glyphs& all, std::size_t glyph, Sink& sink, const placement& at,
                 const Write& write) noexcept
{
    if constexpr (has(Sink::wants, letter_attributes)) {
        letter_namer<Sink> named{sink, all.letters.rows[all.letters.row_of[glyph]], all.letter_of(glyph)};
        write(named, at);
    } else {
        write(sink, at);
    }
}

/// Calls write(sink, placement) for a glyph: if the sink moves letters, with what is left of it for this letter.
template <class Sink, class Write>
void write_letter(const text_glyphs& all, std::size_t glyph, Sink& sink, const Write& write) noexcept
{
    placement at = all.place(all.records[glyph]);
    if constexpr (moves_letters<Sink>) {
        if (!sink.start_glyph(all, glyph, at)) {
            write_named(all, glyph, sink.inner(), at, write);
            return;
        }
    }
    write_named(all, glyph, sink, at, write);
    if constexpr (moves_letters<Sink>) sink.end_glyph();
}

/// Whether the triangles of a glyph are mirrored on their way into a sink.
template <class Sink>
[[nodiscard]] bool mirrors_letter(const text_glyphs& all, std::size_t glyph, const Sink&) noexcept
{
    if constexpr (moves_letters<Sink>) {
        const letter_move* found = all.letters.move_of(glyph);
        return found != nullptr && found->mirrors();
    } else {
        return false;
    }
}

/// The sink to which a sink that moves letters writes, or the sink itself.
template <class Sink>
[[nodiscard]] auto& unmoved(Sink& sink) noexcept
{
    if constexpr (moves_letters<Sink>)
        return sink.inner();
    else
        return sink;
}

}  // namespace detail

/// A sink that moves each letter before it reaches another sink. `To` is a sink or a reference to one.
template <class To>
class moved_sink {
public:
    static constexpr attribute wants = std::remove_reference_t<To>::wants;

    moved_sink(To to, const text_letters& letters) noexcept : to_{static_cast<To&&>(to)}, letters_{&letters} {}

    error begin(mesh_size exact) noexcept { return to_.begin(exact); }
    /// See chunked_sink.
    error begin_chunks(mesh_size exact, std::uint32_t most) noexcept
        requires requires(To t) { t.begin_chunks(exact, most); }
    {
        return to_.begin_chunks(exact, most);
    }
    /// See ranged_sink.
    [[nodiscard]] auto subrange(mesh_range range) const noexcept
        requires ranged_sink<std::remove_reference_t<To>>
    {
        auto part = std::as_const(to_).subrange(range);
        return moved_sink<decltype(part)>{std::move(part), *letters_};
    }

    [[nodiscard]] std::remove_reference_t<To>& inner() noexcept { return to_; }

    /// The next vertices and triangles belong to this glyph. Moves its placement. Returns false if nothing is left
    /// to do: its vertices then go to inner().
    [[nodiscard]] bool start_glyph(const text_glyphs& all, std::size_t glyph, placement& at) noexcept
    {
        const letter_move* found = letters_->move_of(glyph);
        mirrors_ = found != nullptr && found->mirrors();
        if (found == nullptr) return false;
        const letter_move& move = *found;
        if (move.is_identity() || (!all.in_place && move.move_placement(at))) return false;
        if (all.in_place) {
            points_.start(move, move.map());
        } else {
            at.pen = {};
            points_.start(move, move.map_from(all.translation_of(all.records[glyph])));
        }
        return true;
    }

    void vertex(const surface_point<wants>& s) noexcept
    {
        if (points_.take(s)) end_glyph();
    }
    /// Writes the vertices that are left.
    void end_glyph() noexcept
    {
        points_.give([this](const surface_point<wants>& s) noexcept { to_.vertex(s); });
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
    {
        end_glyph();  // a sink gets all vertices before the first triangle
        if (mirrors_)
            to_.triangle(a, c, b);
        else
            to_.triangle(a, b, c);
    }
    auto end() noexcept { return to_.end(); }

private:
    To to_;
    const text_letters* letters_;
    point_mover<wants> points_;
    bool mirrors_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI
