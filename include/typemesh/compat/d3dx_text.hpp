// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/compat/d3dx_deviation.hpp>
#include <typemesh/compat/d3dx_text_plan.hpp>
#include <typemesh/compat/d3dx_vertex.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/glyph/glyph_cache.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/text/text_mesher.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// The length that is 1 in the output.
enum class d3dx_size : std::uint8_t {
    cell_height,  ///< the font's ascender minus its descender, as in D3DXCreateText: about 1.1 to 1.2 em
    em,           ///< the em, as everywhere else in this library
};

/// The arguments of D3DXCreateText, and additional options.
struct d3dx_text_options {
    double deviation = 0.01;  ///< Direct3D's deviation (d3dx_deviation.hpp), in output units; 0: one font unit
    double extrusion = 0.4;   ///< positive, in output units: the text lies between z = 0 and z = -extrusion
    d3dx_size size = d3dx_size::cell_height;

    bool kerning = false;        ///< whether pairs of letters are kerned as the font specifies; Direct3D never kerns
    bool ligatures = false;      ///< whether letters are joined (fi) if the font does so by default; Direct3D never
                                 ///< joins letters
    shape_options shape = {};    ///< direction, language, script, further features
    layout_options layout = {};  ///< alignment, spacing of lines

    texture_box texture_over = texture_box::text;  ///< the area that texture coordinates cover, if the vertex has them
    bool draw_missing = true;                      ///< whether the font's box is drawn for missing characters, as GDI
                                                   ///< does
};

/// An extruder whose depth can be set: extruded, bevelled.
template <class E>
concept d3dx_extruder = extruder<E> && requires(E& e) {
    { e.depth } -> std::same_as<float&>;
};

/// Text as D3DXCreateText makes it, without Direct3D, GDI or windows.h: a replacement with the same meaning that fills
/// the caller's arrays.
///
///     d3dx_text maker{font};                                   // HarfBuzz, FreeType, DirectWrite, or your own
///     auto plan = maker.plan(u"Hello world!", {.deviation = 0.01, .extrusion = 0.3});
///     if (!plan) return plan.error();
///     vertices.resize(plan->size().vertices);                  // d3dx_vertex, or any vertex with vertex_traits
///     indices.resize(plan->size().indices());                  // std::uint16_t as in Direct3D, or std::uint32_t
///     auto written = plan->write(std::span{vertices}, std::span{indices});
///
/// The space is Direct3D's:
///
///      y                   left-handed: x to the right, y up, z away from the viewer, who looks along +z
///      |   z               z = -extrusion: the cap that the viewer sees, normal (0, 0, -1), where x runs to the right
///      |  /                z = 0:          the cap behind it, normal (0, 0, 1)
///      | /                 front faces look clockwise (D3DCULL_CCW draws them), which in these coordinates is
///      +------- x          dot(cross(b - a, c - a), normal) > 0
///
/// The first baseline is y = 0, the first pen position is x = 0. A line break begins a line (Direct3D draws a box or
/// nothing). An empty or blank text gives an empty mesh, not an error.
///
/// `font` is both shaper and outline source, and must outlive this object. A d3dx_text serves one thread at a time;
/// after warm-up it allocates nothing. With a glyph_cache, a letter is meshed once for all texts with equal deviation:
///
///     glyph_cache cache;
///     d3dx_text maker{font, cached_in{cache, 1}};
///
/// Caps are triangulated by monotone, or by another triangulator. The default solid is extruded. Another extruder needs
/// a member `depth`, which is set to the extrusion; if it has a member `texture`, that is set to
/// texture_mapping::box:
///
///     auto fair = d3dx_text{font}.with(constrained_delaunay{});
///     auto moulded = d3dx_text{font}.with(bevelled{.width = 0.02f, .bevel_depth = 0.03f});
///
/// The width of a bevel is in em. Its depth is in output units, like the extrusion.
template <d3dx_extruder Solid = extruded<>>
class d3dx_text {
public:
    using plan_type = d3dx_text_plan<Solid>;

    /// Options follow the font: a triangulator, an extruder that has a depth, cached_in, and the memory source.
    template <class Font, class... Option, detail::takes<Solid, Option...> = 0>
        requires shaper<Font> && outline_source<Font>
    explicit d3dx_text(Font& font, Option... options) noexcept
        : font_{font},
          mesher_{font, in_a_box(Solid{}), taken(std::move(options))...},
          features_{detail::memory_among(options...)}
    {
    }

    /// Returns this object with another triangulator, or with another extruder.
    template <class Policy>
    [[nodiscard]] auto with(Policy policy) && noexcept
    {
        if constexpr (d3dx_extruder<Policy> && !std::same_as<Policy, Solid>) {
            return d3dx_text<Policy>{font_, std::move(mesher_).with(taken(std::move(policy))), std::move(features_)};
        } else {
            mesher_.use(taken(std::move(policy)));
            return std::move(*this);
        }
    }
    template <class Policy>
    d3dx_text&& with(Policy) & noexcept
    {
        static_assert(sizeof(Policy) == 0,
                      "typemesh: with() makes another d3dx_text and empties this one: write "
                      "`d3dx_text{font}.with(...)`, or `std::move(maker).with(...)`.");
        return std::move(*this);
    }

    // A d3dx_text refers to the font: neither a temporary nor a result without its `*` is accepted.
    template <class Font, class... Option>
    explicit d3dx_text(const Font&&, Option..., detail::keep_the_font_in_a_variable = {}) = delete;
    template <class Made, class... Option>
    explicit d3dx_text(const result<Made>& font, Option...) noexcept
        : d3dx_text{refuse_result(const_cast<result<Made>&>(font))}
    {
    }

    /// Plans a text: everything except the writing. This invalidates the previous plan.
    ///
    /// Fails  error::bad_tolerance: the deviation is negative, NaN or infinite
    ///        error::bad_option: the extrusion is not a positive 32-bit number (for flat text see extrude/flat.hpp), or
    ///        the extruder refuses an option
    ///        any error of text_mesher::plan()
    [[nodiscard]] result<plan_type> plan(text_view text, const d3dx_text_options& options = {}) & noexcept
    {
        const double em_size = em_size_of(options);
        using single = std::numeric_limits<float>;
        const double least = as_double((single::min)()), most = as_double((single::max)());
        const bool is_float = is_finite(options.extrusion) && options.extrusion >= least && options.extrusion <= most;
        if (!is_float) return error::bad("extrusion");
        if (!is_finite(options.deviation) || options.deviation < 0.0) return error::bad_tolerance;
        mesher_.solid().depth = static_cast<float>(options.extrusion);

        features_.clear();
        bool room = options.kerning || features_.push_back({"kern", 0});
        room = room && (options.ligatures || features_.append(std::span<const feature>{no_ligatures}));
        if (!room || !features_.append(options.shape.features)) return error::out_of_memory;

        text_options how;
        how.shape = options.shape;
        how.shape.features = features_.view();
        how.layout = options.layout;
        how.tolerance = options.deviation > 0.0 ? d3dx_tolerance(options.deviation / em_size)
                                                : d3dx_tolerance(1.0 / font_.units_per_em());
        how.unit = output_unit::pixels;
        how.pixels_per_em = em_size;
        how.depth_in = depth_unit::output;
        how.texture_over = options.texture_over;
        how.draw_missing = options.draw_missing;
        auto made = mesher_.plan(text, how);
        if (!made) return made.error();
        return plan_type{std::move(*made), em_size / font_.units_per_em(), text.size(),
                         options.shape.direction == direction::top_to_bottom};
    }

    detail::keep_the_mesher_in_a_variable plan(text_view text, const d3dx_text_options& options = {}) && = delete;
    template <foreign_text Text>
    result<plan_type> plan(const Text&, const d3dx_text_options& = {}) & noexcept
    {
        return refuse_text<Text>();
    }

    /// The style of side normals, for changing its options between texts. The crease angle of curve_normals is 15
    /// degrees, Direct3D's is 45.
    [[nodiscard]] auto& normals_policy() noexcept
        requires requires(Solid& e) { e.normals; }
    {
        return mesher_.solid().normals;
    }

    /// The solid, for changing its options between texts; the next plan sets its depth to the extrusion.
    [[nodiscard]] Solid& solid() noexcept { return mesher_.solid(); }

    /// The size of an em in the output.
    [[nodiscard]] double em_size_of(const d3dx_text_options& options) noexcept
    {
        if (options.size == d3dx_size::em) return 1.0;
        const line_metrics m = font_.shaper().metrics(direction::left_to_right);
        const double cell = m.ascender - m.descender;
        return is_finite(cell) && cell > 0.0 ? font_.units_per_em() / cell : 1.0;
    }

private:
    template <d3dx_extruder>
    friend class d3dx_text;

    template <class E>
    static E in_a_box(E how) noexcept
    {
        if constexpr (requires { how.texture = texture_mapping::box; }) how.texture = texture_mapping::box;
        return how;
    }

    /// The option, with its texture mapping set to box if it has one.
    template <class Option>
    static Option taken(Option option) noexcept
    {
        static_assert(triangulator<Option> || d3dx_extruder<Option> || std::same_as<Option, cached_in> ||
                          std::same_as<Option, no_cache> || std::same_as<Option, memory>,
                      "typemesh: a d3dx_text takes a triangulator, an extruder that has a depth, a cache or a memory: "
                      "use a text_mesher for other policies.");
        return in_a_box(std::move(option));
    }

    d3dx_text(font_ref font, text_mesher<Solid>&& mesher, buffer<feature>&& features) noexcept
        : font_{font}, mesher_{std::move(mesher)}, features_{std::move(features)}
    {
    }

    font_ref font_;
    text_mesher<Solid> mesher_;
    buffer<feature> features_;
};

template <class Font, class... Option>
d3dx_text(Font&, Option...) -> d3dx_text<detail::solid_among<Option...>>;
template <class Font, class... Option>
d3dx_text(const Font&&, Option...) -> d3dx_text<detail::solid_among<Option...>>;  // chosen only to be refused

}  // namespace typemesh::inline TYPEMESH_ABI
