// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/glyph_id.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// The different glyphs of a text, numbered from 0 in the order in which they came.
///
/// A table with open addressing, at most half full; it begins small with every text, so that clear() costs nothing.
class glyph_set {
public:
    static constexpr std::uint32_t no_room = 0xFFFF'FFFFu;

    explicit glyph_set(memory source = heap()) noexcept : ids_{source}, slots_{source} {}

    void clear() noexcept
    {
        ids_.clear();
        slots_.clear();
    }

    [[nodiscard]] std::span<const glyph_id> ids() const noexcept { return ids_.view(); }

    /// The glyph's number, a new one where it was not known; no_room when the memory gives none.
    [[nodiscard]] std::uint32_t number_of(glyph_id id) noexcept
    {
        if (2 * ids_.size() >= slots_.size() && !grow()) return no_room;
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = place_of(id) & mask;
        for (; slots_[at] != 0; at = (at + 1) & mask)
            if (ids_[slots_[at] - 1] == id) return slots_[at] - 1;
        const std::uint32_t number = append(id);
        if (number != no_room) slots_[at] = number + 1;
        return number;
    }

    /// A number of its own for a glyph that shall not be found again.
    [[nodiscard]] std::uint32_t append(glyph_id id) noexcept
    {
        if (ids_.size() >= no_room - 1 || !ids_.push_back(id)) return no_room;
        return static_cast<std::uint32_t>(ids_.size() - 1);
    }

private:
    /// Neighbouring ids, as those of an alphabet, go to places far apart.
    static std::size_t place_of(glyph_id id) noexcept
    {
        const std::uint32_t mixed = id * 0x9E37'79B1u;
        return mixed ^ (mixed >> 15);
    }

    bool grow() noexcept
    {
        const std::size_t wanted = slots_.empty() ? 64 : 2 * slots_.size();
        if (!slots_.reserve(wanted)) return false;
        slots_.clear();
        std::uint32_t* slots = slots_.append(wanted);
        for (std::size_t i = 0; i < wanted; ++i) slots[i] = 0;
        for (std::size_t i = 0; i < ids_.size(); ++i) {
            std::size_t at = place_of(ids_[i]) & (wanted - 1);
            while (slots[at] != 0) at = (at + 1) & (wanted - 1);
            slots[at] = static_cast<std::uint32_t>(i + 1);
        }
        return true;
    }

    buffer<glyph_id> ids_;
    buffer<std::uint32_t> slots_;  // number + 1, or 0: free
};

}  // namespace typemesh::inline TYPEMESH_ABI
