// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/glyph_id.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A glyph as it is built: its number in its face, and the glyph style with its face and map
/// (run_glyph_styles::outlines_of()).
struct glyph_key {
    glyph_id id = no_glyph;
    std::uint32_t glyph_style = 0;

    friend constexpr bool operator==(const glyph_key&, const glyph_key&) noexcept = default;
};

/// The different glyphs of a text, numbered from 0 in the order of first use.
///
/// A table with open addressing, at most half full; it starts small for every text, so that clear() costs nothing.
class glyph_set {
public:
    static constexpr std::uint32_t no_room = 0xFFFF'FFFFu;

    explicit glyph_set(memory source = heap()) noexcept : keys_{source}, slots_{source} {}

    void clear() noexcept
    {
        keys_.clear();
        slots_.clear();
    }

    [[nodiscard]] array_view<const glyph_key> keys() const noexcept { return keys_.view(); }

    /// The glyph's number, a new one if it was unknown; no_room if out of memory.
    [[nodiscard]] std::uint32_t number_of(glyph_key key) noexcept
    {
        if (2 * keys_.size() >= slots_.size() && !grow()) return no_room;
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = place_of(key) & mask;
        for (; slots_[at] != 0; at = (at + 1) & mask)
            if (keys_[slots_[at] - 1] == key) return slots_[at] - 1;
        const std::uint32_t number = append(key);
        if (number != no_room) slots_[at] = number + 1;
        return number;
    }

    /// A new number for a glyph that must not be found again.
    [[nodiscard]] std::uint32_t append(glyph_key key) noexcept
    {
        if (keys_.size() >= no_room - 1 || !keys_.push_back(key)) return no_room;
        return static_cast<std::uint32_t>(keys_.size() - 1);
    }

private:
    /// Neighbouring ids, for example of an alphabet, get distant places.
    static std::size_t place_of(glyph_key key) noexcept
    {
        const std::uint32_t mixed = key.id * 0x9E37'79B1u + key.glyph_style * 0x85EB'CA6Bu;
        return mixed ^ (mixed >> 15);
    }

    bool grow() noexcept
    {
        const std::size_t wanted = slots_.empty() ? 64 : 2 * slots_.size();
        if (!slots_.reserve(wanted)) return false;
        slots_.clear();
        std::uint32_t* table = slots_.append(wanted);
        for (std::size_t i = 0; i < wanted; ++i) table[i] = 0;
        for (std::size_t i = 0; i < keys_.size(); ++i) {
            std::size_t at = place_of(keys_[i]) & (wanted - 1);
            while (table[at] != 0) at = (at + 1) & (wanted - 1);
            table[at] = static_cast<std::uint32_t>(i + 1);
        }
        return true;
    }

    buffer<glyph_key> keys_;
    buffer<std::uint32_t> slots_;  // number + 1, or 0: free
};

}  // namespace typemesh::inline TYPEMESH_ABI
