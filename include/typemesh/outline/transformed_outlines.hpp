// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/outline/outline_source.hpp>
#include <typemesh/outline/variation_key.hpp>

#include <cstring>

namespace typemesh::inline TYPEMESH_ABI {

/// x' = xx x + xy y + dx,  y' = yx x + yy y + dy, in font units.
struct affine {
    double xx = 1.0, xy = 0.0, dx = 0.0;
    double yx = 0.0, yy = 1.0, dy = 0.0;

    [[nodiscard]] constexpr point operator()(point p) const noexcept
    {
        return {xx * p.x + xy * p.y + dx, yx * p.x + yy * p.y + dy};
    }
};

/// A source whose outlines are another's, transformed: slanted (`{.xy = 0.2}`), condensed, mirrored. Advances stay the
/// same. The other source must outlive it.
template <outline_source Source>
class transformed_outlines {
public:
    transformed_outlines(Source& source, const affine& map) noexcept : source_{&source}, map_{map} {}

    [[nodiscard]] double units_per_em() const noexcept { return source_->units_per_em(); }
    [[nodiscard]] fill_rule fill() const noexcept { return source_->fill(); }

    /// See variation_key.hpp.
    [[nodiscard]] std::uint64_t variation_key() const noexcept
    {
        std::uint64_t key = variation_of(*source_);
        for (const double number : {map_.xx, map_.xy, map_.dx, map_.yx, map_.yy, map_.dy}) {
            std::uint64_t bits = 0;
            std::memcpy(&bits, &number, sizeof bits);
            key = mixed_key(key, bits);
        }
        return key;
    }

    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        transformed_sink<Sink> through{sink, map_};
        return source_->outline(id, through);
    }

private:
    template <outline_sink Sink>
    struct transformed_sink {
        Sink& to;
        const affine& map;

        void move(point p) noexcept { to.move(map(p)); }
        void line(point p) noexcept { to.line(map(p)); }
        void quadratic(point c, point p) noexcept { to.quadratic(map(c), map(p)); }
        void cubic(point c1, point c2, point p) noexcept { to.cubic(map(c1), map(c2), map(p)); }
        void close() noexcept { to.close(); }
    };

    Source* source_;
    affine map_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
