// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/layout/face_metrics.hpp>
#include <typemesh/layout/ligature_carets.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/outline/face_source.hpp>

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// Assigns the glyphs to a face, whose unit is `unit` units of the first face.
inline void belong_to(array_view<shaped_glyph> glyphs, std::uint16_t face, double unit) noexcept
{
    for (shaped_glyph& g : glyphs) {
        g.face = face;
        g.advance *= unit;
        g.offset = {unit * g.offset.x, unit * g.offset.y};
    }
}

/// Several faces as one source, in units of the first face. `Store` keeps the faces:
///
///     face_count()                        the number of faces
///     first()                             the first face
///     call(face, what)                    calls what(face number `face`); does nothing if there is no such face
///     any(what)                           whether what(face) is true for any face
///     first_type                          the type of the first face
template <class Store>
class numbered_faces : public Store {
    using first_type = typename Store::first_type;
    using Store::any, Store::call, Store::first;

public:
    using Store::Store;

    [[nodiscard]] double units_per_em() const noexcept { return first().units_per_em(); }
    [[nodiscard]] double units_per_em(std::uint32_t face) const noexcept
    {
        double units = 0.0;
        call(face, [&units](auto& source) noexcept { units = source.units_per_em(); });
        return units;
    }
    [[nodiscard]] fill_rule fill() const noexcept { return first().fill(); }
    [[nodiscard]] fill_rule fill(std::uint32_t face) const noexcept
    {
        fill_rule rule = fill_rule::non_zero;
        call(face, [&rule](auto& source) noexcept { rule = source.fill(); });
        return rule;
    }

    /// See outline_source: the first face's key stands for all faces.
    [[nodiscard]] std::uint64_t variation_key() const noexcept { return variation_of(first()); }
    [[nodiscard]] std::uint64_t variation_key(std::uint32_t face) const noexcept
    {
        std::uint64_t key = 0;
        call(face, [&key](const auto& source) noexcept { key = variation_of(source); });
        return key;
    }

    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) const noexcept
    {
        return first().outline(id, sink);
    }
    template <outline_sink Sink>
    error outline(std::uint32_t face, glyph_id id, Sink& sink) const noexcept
    {
        error e = error{error::unknown_glyph}.at(id, no_cluster);
        call(face, [&](auto& source) noexcept { e = source.outline(id, sink); });
        return e;
    }

    [[nodiscard]] line_metrics metrics(direction d) const noexcept
        requires shaper<first_type>
    {
        return first().metrics(d);
    }
    /// See shaper. Lengths are in units of the first face. Fails also with error::no_such_face and, if the face only
    /// draws, error::not_a_shaper.
    error shape(text_view text, const text_item& item, const shape_options& options,
                buffer<shaped_glyph>& glyphs) const noexcept
        requires shaper<first_type>
    {
        const std::size_t before = glyphs.size();
        error e{error::no_such_face, Store::face_count()};
        call(item.face, [&]<class Source>(Source& source) noexcept {
            if constexpr (shaper<Source>)
                e = source.shape(text, item, options, glyphs);
            else
                e = error::not_a_shaper;
        });
        if (!e && item.face != 0)
            detail::belong_to(glyphs.view().subspan(before), item.face, units_per_em() / units_per_em(item.face));
        return e;
    }

    /// Metrics, bars and carets of one face, in units of the first face: see face_metrics.hpp, ligature_carets.hpp.
    [[nodiscard]] line_metrics metrics(direction d, std::uint32_t face) const noexcept
        requires shaper<first_type>
    {
        line_metrics own;
        call(face, [&]<class Source>(Source& source) noexcept {
            if constexpr (shaper<Source>) own = source.metrics(d);
        });
        return scaled(own, units_per_em() / units_per_em(face));
    }
    [[nodiscard]] face_metrics suggested_metrics(std::uint32_t face) const noexcept
        requires shaper<first_type>
    {
        face_metrics own;
        call(face, [&](auto& source) noexcept { own = face_metrics_of(source, 0); });
        return own;
    }
    error ligature_carets(std::uint32_t face, glyph_id id, bool down, buffer<double>& carets) const noexcept
        requires shaper<first_type>
    {
        error e;
        const std::size_t before = carets.size();
        call(face, [&]<class Source>(Source& source) noexcept {
            if constexpr (has_ligature_carets<Source>) e = source.ligature_carets(0, id, down, carets);
        });
        for (double& place : carets.view().subspan(before)) place *= units_per_em() / units_per_em(face);
        return e;
    }
    /// See shaper: whether any face has a vertical form. column_middle() is the first face's.
    [[nodiscard]] bool has_vertical_form(char32_t c) const noexcept
        requires shaper<first_type>
    {
        return any([c](auto& source) noexcept { return vertical_form_of(source, c); });
    }
    [[nodiscard]] double column_middle() const noexcept
        requires shaper<first_type>
    {
        return column_middle_of(first());
    }
};

/// Sources of distinct types; they must outlive the store.
template <class... Sources>
class faces_of_types {
public:
    explicit faces_of_types(Sources&... sources) noexcept : sources_{&sources...} {}

    [[nodiscard]] static constexpr std::uint32_t face_count() noexcept { return sizeof...(Sources); }

protected:
    using first_type = std::tuple_element_t<0, std::tuple<Sources...>>;

    [[nodiscard]] first_type& first() const noexcept { return *std::get<0>(sources_); }
    template <class What>
    void call(std::uint32_t face, const What& what) const noexcept
    {
        std::apply(
            [&](auto*... source) noexcept {
                std::uint32_t number = 0;
                ((number++ == face ? what(*source) : void()), ...);
            },
            sources_);
    }
    template <class What>
    [[nodiscard]] bool any(const What& what) const noexcept
    {
        return std::apply([&](auto*... source) noexcept { return (what(*source) || ...); }, sources_);
    }

private:
    std::tuple<Sources*...> sources_;
};

}  // namespace detail

/// Several fonts, or sets of drawings, as the faces of one source, in the given order:
///
///     font_faces faces{latin, arabic, icons};              // all must outlive it
///     text_mesher mesher{faces};
///     auto icon = run.number_of({.face = 2});              // for placed_glyph::glyph_style; a result
///
/// It is a shaper if the first face is. Text is shaped by the first face, and text with a style by the face that the
/// style names. For fonts that replace each other's missing glyphs, see font_cascade.hpp.
template <outline_source... Sources>
class font_faces : public detail::numbered_faces<detail::faces_of_types<Sources...>> {
    static_assert(sizeof...(Sources) != 0, "typemesh: font_faces needs a font");

public:
    explicit font_faces(Sources&... sources) noexcept
        : detail::numbered_faces<detail::faces_of_types<Sources...>>{sources...}
    {
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
