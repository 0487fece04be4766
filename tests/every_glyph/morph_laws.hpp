// SPDX-License-Identifier: MIT
#pragma once

// Morphs of single glyphs along an axis, compared with the font opened at values of the axis.

#include "support/mesh_laws.hpp"

#include <typemesh/adapt/harfbuzz_axis.hpp>
#include <typemesh/morph/axis_morph.hpp>
#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/unicode/utf.hpp>
#include <typemesh/vertex/growing_sink.hpp>
#include <typemesh/vertex/vertex_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace test {

/// A position and a normal.
struct morph_vertex {
    typemesh::vec3 position, normal;
};

}  // namespace test

template <>
struct typemesh::vertex_traits<test::morph_vertex> {
    static constexpr auto wants = attribute::position | attribute::normal;
    test::morph_vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.normal}; }
};

namespace test {

/// An axis whose font sets each private character U+F0000 + g as glyph g, without an advance.
class glyph_axis {
public:
    class glyph_font {
    public:
        explicit glyph_font(typemesh::harfbuzz_font& font) : font_{&font} {}
        [[nodiscard]] double units_per_em() const noexcept { return font_->units_per_em(); }
        [[nodiscard]] typemesh::fill_rule fill() const noexcept { return font_->fill(); }
        template <typemesh::outline_sink Sink>
        typemesh::error outline(typemesh::glyph_id id, Sink& sink) noexcept
        {
            return font_->outline(id, sink);
        }
        [[nodiscard]] typemesh::line_metrics metrics(typemesh::direction) const noexcept { return {}; }
        typemesh::error shape(typemesh::text_view text, const typemesh::text_item& item, const typemesh::shape_options&,
                              typemesh::buffer<typemesh::shaped_glyph>& glyphs) noexcept
        {
            for (std::size_t i = item.first; i < item.last;) {
                const typemesh::code_point c = decode(text, i, item.last);
                if (!glyphs.push_back(
                        {static_cast<typemesh::glyph_id>(c.value - 0xF0000), static_cast<std::uint32_t>(i)}))
                    return typemesh::error::out_of_memory;
                i = c.next;
            }
            return {};
        }

    private:
        typemesh::harfbuzz_font* font_;
    };

    explicit glyph_axis(typemesh::harfbuzz_axis& axis) : axis_{&axis}, font_{axis.font()} {}
    [[nodiscard]] double low() const noexcept { return axis_->low(); }
    [[nodiscard]] double usual() const noexcept { return axis_->usual(); }
    [[nodiscard]] double high() const noexcept { return axis_->high(); }
    [[nodiscard]] typemesh::axis_coordinate coordinate(double value) noexcept { return axis_->coordinate(value); }
    typemesh::error append_masters(typemesh::buffer<typemesh::axis_coordinate>& out) const noexcept
    {
        return axis_->append_masters(out);
    }
    typemesh::error append_changes(typemesh::buffer<typemesh::axis_coordinate>&) const noexcept { return {}; }
    typemesh::error move_to(typemesh::axis_coordinate c) noexcept { return axis_->move_to(c); }
    [[nodiscard]] glyph_font& font() noexcept { return font_; }

private:
    typemesh::harfbuzz_axis* axis_;
    glyph_font font_;
};

/// What was found in a font.
struct morph_findings {
    std::size_t glyphs = 0, whole = 0, overlapping = 0, split = 0, partly_refused = 0, refused = 0, pinched = 0;
    std::size_t places = 0;             ///< meshes that were compared
    std::size_t turned = 0;             ///< triangles that do not face the reader, of the compared meshes
    double far = 0.0;                   ///< the greatest distance of a vertex from the font's outline, in cells
    double off = 0.0;                   ///< the greatest distance of the font's outline from the mesh, in tolerances
    double normal_error = 0.0;          ///< radians, as reported
    std::vector<double> normal_errors;  ///< one for each glyph
    std::string wrong;                  ///< the first broken law
};

/// Compares morphs of the glyphs of one font with instances that were opened at values of the axis.
class morph_laws {
public:
    /// `tag` names the axis. `instances` fonts are opened, evenly between the ends of the axis.
    morph_laws(const std::string& path, const char (&tag)[5], std::size_t instances)
        : font_{open(path, {})}, axis_{axis_of(font_, tag)}, glyphs_{axis_}, morph_{glyphs_}
    {
        for (std::size_t i = 0; i < instances; ++i) {
            const double value = axis_.low() + (axis_.high() - axis_.low()) * static_cast<double>(i) /
                                                   static_cast<double>(instances - 1);
            typemesh::variation at{"", static_cast<float>(value)};
            std::copy_n(tag, 5, at.tag);
            coordinates_.push_back(axis_.coordinate(static_cast<double>(at.value)));
            fonts_.push_back(open(path, std::span{&at, 1}));
        }
    }

    [[nodiscard]] const morph_findings& found() const { return found_; }
    [[nodiscard]] typemesh::harfbuzz_font& font() { return font_; }

    void examine(typemesh::glyph_id id)
    {
        const char32_t text[] = {static_cast<char32_t>(0xF0000 + id), 0};
        char utf8[5] = {static_cast<char>(0xF3), static_cast<char>(0x80 | ((text[0] >> 12) & 0x3F)),
                        static_cast<char>(0x80 | ((text[0] >> 6) & 0x3F)), static_cast<char>(0x80 | (text[0] & 0x3F)),
                        0};
        const double em = font_.units_per_em();
        typemesh::morph_options how;
        how.size = em;
        auto plan = morph_.plan(typemesh::text_view{utf8}, how);
        if (!plan) return wrong(id, 0, plan.error().message());
        const typemesh::morph_report& r = plan->report();
        if (r.letters == 0) return;
        ++found_.glyphs;
        found_.overlapping += r.overlapping;
        found_.pinched += r.pinched;
        found_.split += r.split;
        found_.whole += r.split + r.overlapping + r.refused == 0 ? 1u : 0u;
        found_.normal_error = (std::max)(found_.normal_error, r.normal_error);
        found_.normal_errors.push_back(r.normal_error);
        bool drawn = false;
        for (std::size_t s = 0; s < plan->section_count(); ++s) drawn = drawn || plan->size(s).triangles != 0;
        if (!drawn) return void(++found_.refused);
        found_.partly_refused += r.refused;
        for (std::size_t i = 0; i < fonts_.size(); ++i) compare(id, *plan, i, em * how.tolerance);
    }

private:
    static typemesh::harfbuzz_font open(const std::string& path, std::span<const typemesh::variation> at)
    {
        auto font = typemesh::harfbuzz_font::open(path, {.variations = at});
        if (!font) throw font.error().message();
        return std::move(*font);
    }
    static typemesh::harfbuzz_axis axis_of(const typemesh::harfbuzz_font& font, const char (&tag)[5])
    {
        auto axis = typemesh::harfbuzz_axis::open(font, tag);
        if (!axis) throw axis.error().message();
        return std::move(*axis);
    }

    void wrong(typemesh::glyph_id id, std::size_t instance, const std::string& what)
    {
        if (found_.wrong.empty())
            found_.wrong = "glyph " + std::to_string(id) + " at place " + std::to_string(instance) + ": " + what;
    }

    static double distance(typemesh::point p, typemesh::point a, typemesh::point b)
    {
        const typemesh::point ab = b - a;
        const double square = dot(ab, ab);
        const double t = square > 0.0 ? std::clamp(dot(p - a, ab) / square, 0.0, 1.0) : 0.0;
        return length(p - (a + t * ab));
    }

    /// The distance of a point from polylines, given as edges.
    static double distance(typemesh::point p, const std::vector<typemesh::point>& edges)
    {
        double least = 1e30;
        for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
            const auto [a, b] = std::pair{edges[i], edges[i + 1]};
            const double dx = (std::max)((std::min)(a.x, b.x) - p.x, p.x - (std::max)(a.x, b.x));
            const double dy = (std::max)((std::min)(a.y, b.y) - p.y, p.y - (std::max)(a.y, b.y));
            if (dx < least && dy < least) least = (std::min)(least, distance(p, a, b));
        }
        return least;
    }

    /// The distance of a point from the curves themselves: of the chords that are nearest, the curves are searched.
    [[nodiscard]] double distance_to_curves(typemesh::point p, double fine) const
    {
        const double near = distance(p, outline_) + 2.0 * fine;
        double least = 1e30;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (distance(p, outline_[2 * i], outline_[2 * i + 1]) > near) continue;
            const curve_piece& q = pieces_[i];
            double low = q.t, high = q.t + q.length;
            const auto at = [&](double t) { return length(p - q.of->at(t)); };
            for (int step = 0; step < 40; ++step) {
                const double third = (high - low) / 3.0;
                at(low + third) < at(high - third) ? high -= third : low += third;
            }
            least = (std::min)(least, at(0.5 * (low + high)));
        }
        return least;
    }

    static int winding(typemesh::point p, const std::vector<typemesh::point>& edges)
    {
        int sum = 0;
        for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
            const typemesh::point a = edges[i], b = edges[i + 1];
            if ((a.y <= p.y) == (b.y <= p.y)) continue;
            const double side = cross(b - a, p - a);
            if (a.y <= p.y && side > 0.0) ++sum;
            if (a.y > p.y && side < 0.0) --sum;
        }
        return sum;
    }

    void compare(typemesh::glyph_id id, typemesh::morph_plan& plan, std::size_t instance, double tolerance)
    {
        using namespace typemesh;
        const double c = coordinates_[instance];
        const std::size_t section = plan.section_at(c);
        if (plan.size(section).triangles == 0) return;
        ++found_.places;
        if (!plan.write_at(c, into(vertices_, indices_))) return wrong(id, instance, "it is not written");
        if (check_closedness(
                inspect::mesh_view{std::span<const morph_vertex>{vertices_}, std::span<const std::uint32_t>{indices_}})
                .unmatched_edges != 0)
            return wrong(id, instance, "it is not closed");

        typemesh::outline drawn;
        if (!record(fonts_[instance], id, drawn)) return wrong(id, instance, "the font does not draw it");
        outline_.clear();
        pieces_.clear();
        for (const curve& q : drawn.curves) {
            const int pieces = q.degree == 1 ? 1 : 64;
            for (int k = 0; k < pieces; ++k) {
                outline_.push_back(q.at(static_cast<double>(k) / pieces));
                outline_.push_back(q.at(static_cast<double>(k + 1) / pieces));
                pieces_.push_back({&q, static_cast<double>(k) / pieces, 1.0 / pieces});
            }
        }
        const mesh_range front = plan.range(section, part::front);
        edges_.clear();
        std::vector<std::uint64_t> all;
        for (std::size_t t = 0; t < front.index_count; t += 3) {
            point p[3];
            for (std::size_t k = 0; k < 3; ++k) {
                p[k] = place(indices_[t + k]);
                all.push_back(std::uint64_t{indices_[t + k]} << 32 | indices_[t + (k + 1) % 3]);
            }
            const double area = cross(p[1] - p[0], p[2] - p[0]);
            const double size = (std::max)({length(p[0]), length(p[1]), length(p[2])});
            if (area < -size * size * 0x1p-22) ++found_.turned;
        }
        std::sort(all.begin(), all.end());
        for (const std::uint64_t e : all)
            if (!std::binary_search(all.begin(), all.end(), e << 32 | e >> 32)) {
                edges_.push_back(place(static_cast<std::uint32_t>(e >> 32)));
                edges_.push_back(place(static_cast<std::uint32_t>(e)));
            }

        const double cell = 1.0 / 512, rounding = 1e-3;  // of the 64 chords, and of floats; in font units
        for (std::size_t i = 0; i < front.vertex_count; ++i) {
            const double d = distance_to_curves(place(static_cast<std::uint32_t>(i)), fineness(drawn)) / cell;
            found_.far = (std::max)(found_.far, d);
            if (d > 1.0) return wrong(id, instance, "a vertex is far from the outline");
        }
        for (std::size_t i = 0; i < outline_.size(); i += 2) {
            const double d = distance(outline_[i], edges_);
            found_.off = (std::max)(found_.off, d / tolerance);
            if (d > tolerance + cell + rounding) return wrong(id, instance, "the outline is far from the mesh");
        }
        fill(id, instance, drawn.bounds, tolerance + cell + rounding);
    }

    /// How far 64 chords of the longest curve may be from it, in font units.
    static double fineness(const typemesh::outline& drawn)
    {
        double most = 1e-3;
        for (const typemesh::curve& q : drawn.curves)
            for (std::uint32_t k = 0; k + 2 <= q.degree; ++k)
                most = (std::max)(most, 0.75 * length(q.p[k] - 2.0 * q.p[k + 1] + q.p[k + 2]) / (64.0 * 64.0));
        return most;
    }

    /// Points away from the outline are filled by the font exactly if triangles cover them.
    void fill(typemesh::glyph_id id, std::size_t instance, const typemesh::box& around, double margin)
    {
        constexpr int steps = 6;
        for (int x = 0; x < steps; ++x)
            for (int y = 0; y < steps; ++y) {
                const typemesh::point p{around.low.x + around.width() * (x + 0.53) / steps,
                                        around.low.y + around.height() * (y + 0.47) / steps};
                if (distance(p, outline_) <= margin) continue;
                if ((winding(p, outline_) != 0) != (winding(p, edges_) != 0))
                    return wrong(id, instance, "it is not filled as the font fills it");
            }
    }

    [[nodiscard]] typemesh::point place(std::uint32_t vertex) const
    {
        return {double{vertices_[vertex].position.x}, double{vertices_[vertex].position.y}};
    }

    struct curve_piece {
        const typemesh::curve* of;
        double t, length;
    };

    typemesh::harfbuzz_font font_;
    typemesh::harfbuzz_axis axis_;
    glyph_axis glyphs_;
    typemesh::axis_morph<glyph_axis> morph_;
    std::vector<typemesh::harfbuzz_font> fonts_;
    std::vector<typemesh::axis_coordinate> coordinates_;
    morph_findings found_;
    std::vector<morph_vertex> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<typemesh::point> outline_, edges_;  // pairs of points
    std::vector<curve_piece> pieces_;               // one for each pair of outline_
};

/// All glyphs that characters of a font have, ascending.
inline std::vector<typemesh::glyph_id> mapped_glyphs(const typemesh::harfbuzz_font& font)
{
    hb_set_t* const characters = hb_set_create();
    hb_face_collect_unicodes(hb_font_get_face(font.handle()), characters);
    std::vector<typemesh::glyph_id> all;
    hb_codepoint_t glyph = 0;
    for (hb_codepoint_t c = HB_SET_VALUE_INVALID; hb_set_next(characters, &c);)
        if (hb_font_get_nominal_glyph(font.handle(), c, &glyph)) all.push_back(glyph);
    hb_set_destroy(characters);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace test
