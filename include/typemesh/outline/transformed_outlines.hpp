// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/outline/impl/variation_key.hpp>
#include <typemesh/outline/outline_source.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// Maps each point and passes it on to a sink.
template <outline_sink Sink>
struct mapping_sink {
    Sink& to;
    const affine& map;

    void move(point p) noexcept { to.move(map(p)); }
    void line(point p) noexcept { to.line(map(p)); }
    void quadratic(point c, point p) noexcept { to.quadratic(map(c), map(p)); }
    void cubic(point c1, point c2, point p) noexcept { to.cubic(map(c1), map(c2), map(p)); }
    void close() noexcept { to.close(); }
};

}  // namespace detail

/// A source that transforms the outlines of another source: slanted (`{.xy = 0.2}`), condensed, mirrored. Advances do
/// not change. The other source must outlive it.
template <outline_source Source>
class transformed_outlines {
public:
    transformed_outlines(Source& source, const affine& map) noexcept : source_{&source}, map_{map} {}

    [[nodiscard]] double units_per_em() const noexcept { return source_->units_per_em(); }
    [[nodiscard]] fill_rule fill() const noexcept { return source_->fill(); }

    /// See outline_source. Covers the source and the map.
    [[nodiscard]] std::uint64_t variation_key() const noexcept { return mixed_key(variation_of(*source_), map_); }

    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        detail::mapping_sink<Sink> through{sink, map_};
        return source_->outline(id, through);
    }

private:
    Source* source_;
    affine map_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
