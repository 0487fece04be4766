// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/variation_axis.hpp>
#include <typemesh/morph/impl/morph_store.hpp>
#include <typemesh/morph/impl/morph_writer.hpp>
#include <typemesh/morph/morph_options.hpp>
#include <typemesh/vertex/mesh_range.hpp>
#include <typemesh/vertex/mesh_sink.hpp>
#include <typemesh/vertex/part.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// A text's morph along one axis, as one or more sections: stretches of the axis with the same triangles throughout.
/// Most texts have one section. A section has keys: its ends and the masters between them. Between two keys every
/// vertex moves evenly along a straight line.
///
///     section 0                          section 1
///     key 0          key 1      key 2    key 0          key 1
///     |--------------|----------|        |--------------|
///     first                  last        first       last           coordinates of the axis
///
///     write_base(0, sink)         the mesh at key 0, a morph's base
///     write_target(0, 1, sink)    the way of each vertex from there to key 1: position and normal are differences
///     weights(c, shares)          the section at a coordinate, and the weight of each of its targets there
///     write_at(c, sink)           the mesh at any coordinate, computed here: the base plus the weighted targets
///
/// Vertices are sorted by part (front, back, side), and so are triangles. A sink may want position, normal, glyph,
/// cluster and part. Used by one thread at a time. axis_morph makes it.
class morph_plan {
public:
    explicit morph_plan(memory source = heap()) noexcept
        : glyphs_{source}, sections_{source}, keys_{source}, letters_{source}, origins_{source}, feet_{source}
    {
    }

    /// The number of sections. Each has a mesh of its own, which holds between two coordinates.
    [[nodiscard]] std::size_t section_count() const noexcept { return sections_.size(); }

    /// The coordinates of the keys of a section, ascending. They are the section's first coordinate, its last one, and
    /// masters between them.
    [[nodiscard]] array_view<const axis_coordinate> keys(std::size_t section) const noexcept
    {
        const morph_section& s = sections_[section];
        return keys_.view().subspan(s.first_key, s.keys);
    }

    /// The exact size of a section's mesh.
    [[nodiscard]] mesh_size size(std::size_t section) const noexcept { return sections_[section].size; }

    /// The vertices and indices of a part: front, back or side.
    [[nodiscard]] mesh_range range(std::size_t section, part p) const noexcept
    {
        const auto k = static_cast<std::size_t>(p);
        return k < 3 ? sections_[section].ranges[k] : mesh_range{};
    }

    /// What has become of the letters.
    [[nodiscard]] const morph_report& report() const noexcept { return report_; }

    /// The section at a coordinate, which may lie between two integers; beyond the ends, the first or the last one.
    /// There must be a section.
    [[nodiscard]] std::size_t section_at(double coordinate) const noexcept
    {
        std::size_t s = 0;
        while (s + 1 < sections_.size() && coordinate >= static_cast<double>(sections_[s + 1].first)) ++s;
        return s;
    }

    /// Writes the weights of the targets of the section at a coordinate to `out`, one for each key but the first.
    /// Returns the section. At most two weights are not 0. O(targets), no allocation.
    ///
    /// Fails  error::buffer_too_small: `out` is shorter than the number of targets
    ///        error::bad_option: the coordinate is not finite, or there is no section
    result<std::size_t> weights(double coordinate, std::span<float> out) const noexcept
    {
        if (!is_finite(coordinate) || sections_.empty()) return error::bad("coordinate");
        const std::size_t s = section_at(coordinate);
        const auto at = keys(s);
        if (out.size() + 1 < at.size()) return error::short_of("weights", at.size() - 1);
        const morph_step step = step_in(at, coordinate);
        for (std::size_t k = 1; k < at.size(); ++k)
            out[k - 1] = static_cast<float>(k == step.key ? 1.0 - step.share : k == step.key + 1 ? step.share : 0.0);
        return s;
    }

    /// Writes the mesh at the first key of a section.
    ///
    /// Fails  with the errors of the sink
    template <mesh_sink Sink>
    result<void> write_base(std::size_t section, Sink&& sink) noexcept
    {
        return write<morph_output::mesh>(section, static_cast<double>(keys(section)[0]), sink);
    }

    /// Writes the differences between a key (1 or higher) and the first: vertices with `position` and `normal`, and no
    /// triangles. A normal is the difference of two unit vectors.
    ///
    /// Fails  with the errors of the sink
    template <mesh_sink Sink>
    result<void> write_target(std::size_t section, std::size_t key, Sink&& sink) noexcept
    {
        TYPEMESH_ASSERT(key > 0 && key < keys(section).size(), "a target is a key of the section, but not its first");
        return write<morph_output::differences>(section, static_cast<double>(keys(section)[key]), sink);
    }

    /// Writes the mesh at a coordinate, with normals of unit length. It allocates nothing.
    ///
    /// Fails  error::bad_option: the coordinate is not finite, or there is no section; the errors of the sink
    template <mesh_sink Sink>
    result<void> write_at(double coordinate, Sink&& sink) noexcept
    {
        if (!is_finite(coordinate) || sections_.empty()) return error::bad("coordinate");
        const std::size_t s = section_at(coordinate);
        const double low = static_cast<double>(sections_[s].first), high = static_cast<double>(sections_[s].last);
        return write<morph_output::mesh>(s, coordinate < low ? low : coordinate > high ? high : coordinate, sink);
    }

private:
    template <variation_axis Axis>
    friend class axis_morph;

    template <morph_output Output, class Sink>
    result<void> write(std::size_t section, double coordinate, Sink& sink) noexcept
    {
        static_assert((Sink::wants | writable) == writable,
                      "typemesh: morphs have position, normal, glyph, cluster and part; not texture coordinates");
        const morph_section& s = sections_[section];
        const mesh_size size = Output == morph_output::mesh ? s.size : mesh_size{s.size.vertices, 0};
        if (error e = sink.begin(size)) return e;
        detail::morph_writer writer{glyphs_,
                                    s,
                                    keys(section),
                                    letters_.view().subspan(s.first_letter, s.letters),
                                    origins_.view().subspan(s.first_origin, s.letters * s.keys),
                                    feet_.view(),
                                    form_};
        writer.template vertices<Output>(coordinate, sink);
        if constexpr (Output == morph_output::mesh) writer.triangles(sink);
        if (error e = end_of(sink)) return e;
        return {};
    }

    static constexpr attribute writable =
        attribute::position | attribute::normal | attribute::glyph | attribute::cluster | attribute::part;

    morph_store glyphs_;
    buffer<morph_section> sections_;
    buffer<axis_coordinate> keys_;
    buffer<morph_letter> letters_;
    buffer<point> origins_;  // of each section: of all letters at its first key, at its second key, ...
    buffer<placement::footprint> feet_;
    morph_form form_;
    morph_report report_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
