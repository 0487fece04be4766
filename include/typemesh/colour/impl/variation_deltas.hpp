// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/colour/impl/table_bytes.hpp>
#include <typemesh/core/array_view.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The changes of numbers in a variable font: an item variation store, with the map of indices before it.
///
/// The places of axes are 2.14 numbers. A delta is the sum over the regions of its subtable, each delta times the
/// product of the axes' scalars. Indices without an entry give 0.
///
/// From  OpenType specification 1.9.1, "OpenType font variations common table formats"
class variation_deltas {
public:
    /// `store` and `map` are the places of both in the table; 0: there is none.
    void open(const table_bytes& table, std::size_t store, std::size_t map,
              array_view<const std::int32_t> axes) noexcept
    {
        table_ = &table;
        store_ = store;
        map_ = map;
        axes_ = axes;
    }

    /// Whether the deltas of a glyph took more steps than a sound table needs. They are then 0.
    [[nodiscard]] bool is_exhausted() const noexcept { return steps_left_ == 0; }

    /// The change of number `index`, in the unit of the number as it is stored.
    [[nodiscard]] double operator()(std::uint32_t index) const noexcept
    {
        if (store_ == 0 || axes_.empty() || index == none) return 0.0;
        std::uint32_t outer = index >> 16, inner = index & 0xFFFF;
        if (map_ != 0 && !map_index(index, outer, inner)) return 0.0;
        return delta(outer, inner);
    }

private:
    static constexpr std::uint32_t none = 0xFFFF'FFFFu;

    [[nodiscard]] bool map_index(std::uint32_t index, std::uint32_t& outer, std::uint32_t& inner) const noexcept
    {
        const table_bytes& t = *table_;
        const std::uint32_t format = t.u8(map_), how = t.u8(map_ + 1);
        if (format > 1) return false;
        const std::uint32_t count = format == 0 ? t.u16(map_ + 2) : t.u32(map_ + 2);
        if (count == 0) return true;
        const std::size_t size = (how >> 4 & 3) + 1, entries = map_ + (format == 0 ? 4 : 6);
        const std::uint32_t bits = (how & 15) + 1;
        const std::size_t at = entries + size * (index < count ? index : count - 1);
        std::uint32_t entry = 0;
        for (std::size_t i = 0; i < size; ++i) entry = entry << 8 | t.u8(at + i);
        outer = entry >> bits;
        inner = entry & ((1u << bits) - 1);
        return true;
    }

    [[nodiscard]] double delta(std::uint32_t outer, std::uint32_t inner) const noexcept
    {
        const table_bytes& t = *table_;
        if (t.u16(store_) != 1 || outer >= t.u16(store_ + 6)) return 0.0;
        const std::size_t data = store_ + t.u32(store_ + 8 + 4 * std::size_t{outer});
        const std::uint32_t items = t.u16(data), words = t.u16(data + 2), regions = t.u16(data + 4);
        if (inner >= items || (words & 0x7FFF) > regions) return 0.0;
        const bool is_long = (words & 0x8000) != 0;
        const std::size_t wide = words & 0x7FFF, narrow = regions - wide;
        const std::size_t row = is_long ? 4 * wide + 2 * narrow : 2 * wide + narrow;
        std::size_t at = data + 6 + 2 * std::size_t{regions} + row * inner;
        double sum = 0.0;
        for (std::uint32_t r = 0; r < regions && !t.is_short() && takes_step(); ++r) {
            const bool is_wide = r < wide;
            const std::int32_t own = is_long ? (is_wide ? t.i32(at) : t.i16(at)) : (is_wide ? t.i16(at) : t.i8(at));
            at += is_long ? (is_wide ? 4u : 2u) : (is_wide ? 2u : 1u);
            if (own != 0) sum += own * scalar(t.u16(data + 6 + 2 * std::size_t{r}));
        }
        return sum;
    }

    /// By how much a region counts at the place of the axes.
    [[nodiscard]] double scalar(std::uint32_t region) const noexcept
    {
        const table_bytes& t = *table_;
        const std::size_t list = store_ + t.u32(store_ + 2);
        const std::uint32_t axis_count = t.u16(list);
        if (region >= t.u16(list + 2)) return 0.0;
        double product = 1.0;
        for (std::uint32_t i = 0; i < axis_count && !t.is_short() && takes_step(); ++i) {
            const std::size_t at = list + 4 + 6 * (std::size_t{region} * axis_count + i);
            const std::int32_t start = t.i16(at), peak = t.i16(at + 2), end = t.i16(at + 4);
            const std::int32_t place = i < axes_.size() ? axes_[i] : 0;
            if (start > peak || peak > end || (start < 0 && end > 0) || peak == 0 || place == peak) continue;
            if (place <= start || place >= end) return 0.0;
            product *= place < peak ? double(place - start) / (peak - start) : double(end - place) / (end - peak);
        }
        return product;
    }

    [[nodiscard]] bool takes_step() const noexcept { return steps_left_ != 0 && --steps_left_ != 0; }

    const table_bytes* table_ = nullptr;
    mutable std::uint32_t steps_left_ = 1u << 22;
    std::size_t store_ = 0, map_ = 0;
    array_view<const std::int32_t> axes_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
