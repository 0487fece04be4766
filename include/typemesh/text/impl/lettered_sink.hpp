// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/text/impl/text_glyphs.hpp>
#include <typemesh/vertex/ranged_sink.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// A sink that must know which glyph comes next.
template <class Sink>
concept follows_glyphs = requires(Sink& sink, std::size_t glyph) { sink.start_glyph(glyph); };

/// Announces a glyph to a sink that must know it.
template <class Sink>
void start_glyph(Sink& sink, std::size_t glyph) noexcept
{
    if constexpr (follows_glyphs<Sink>) sink.start_glyph(glyph);
}

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

/// Calls write(sink) with a sink that adds the letter data of a glyph, if the sink wants any.
template <class Sink, class Write>
void letter_written(const text_glyphs& all, std::size_t glyph, Sink& sink, const Write& write) noexcept
{
    start_glyph(sink, glyph);
    if constexpr (has(Sink::wants, letter_attributes)) {
        TYPEMESH_ASSERT(all.letters_are_found(),
                        "a vertex wants letter data: call find_letters(text) of the plan before it is written");
        static constexpr text_letter unknown{};
        if (!all.letters_are_found()) {
            write(letter_namer<Sink>{sink, unknown, no_letter});
            return;
        }
        const std::uint32_t row = all.letters.row_of[glyph];
        write(letter_namer<Sink>{sink, all.letters.rows[row], row < all.letters.letters ? row : no_letter});
    } else {
        write(sink);
    }
}

}  // namespace detail

/// A sink that moves each letter before it reaches another sink. `To` is a sink or a reference to one.
template <class To>
class moved_sink {
public:
    static constexpr attribute wants = std::remove_reference_t<To>::wants;

    moved_sink(To to, const text_letters& letters) noexcept : to_{static_cast<To>(to)}, letters_{&letters} {}

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

    /// The next vertices or triangles are those of this glyph.
    void start_glyph(std::size_t glyph) noexcept { move_ = letters_->moves[letters_->row_of[glyph]]; }

    void vertex(const surface_point<wants>& s) noexcept
    {
        if constexpr (has(wants, attribute::position | attribute::normal | attribute::tangent)) {
            if (!move_.is_identity()) {
                surface_point<wants> moved = s;
                move_(moved);
                to_.vertex(moved);
                return;
            }
        }
        to_.vertex(s);
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
    {
        if (move_.mirrors())
            to_.triangle(a, c, b);
        else
            to_.triangle(a, b, c);
    }
    auto end() noexcept { return to_.end(); }

private:
    To to_;
    const text_letters* letters_;
    letter_move move_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
