// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Records the areas that segments sweep, as outlines of nodes. An outline grows at two ends, above the two ends of its
/// segment, until it is closed. If the segment is split, both pieces grow the same outline.
///
///            head            tail                 split in s:   head      tail=s=head     tail
///             |               |                                  |            / \          |
///             |  --segment--> |                                  | --piece-> /   \ -piece->|
///             |               |                                  |                         |
///             +---------------+  counter-clockwise               +-------------------------+
class cell_outlines {
public:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    /// The corners where the outline of a segment's cell grows.
    struct ends {
        std::uint32_t head = none, tail = none;
    };
    struct corner {
        std::uint32_t node;
        std::uint32_t next;
    };
    struct cell {
        std::uint32_t line;
        std::uint32_t corner;  ///< any corner of its outline
    };

    buffer<corner> corners;
    buffer<cell> cells;
    bool failed = false;  ///< out of memory: everything after this is undefined

    explicit cell_outlines(memory source) noexcept : corners{source}, cells{source} {}

    /// Removes all cells; keeps the storage.
    void clear() noexcept
    {
        corners.clear();
        cells.clear();
    }

    /// Opens a cell over the segment of a line from node a to node b; both may be the same node.
    ends open(std::uint32_t line, std::uint32_t a, std::uint32_t b) noexcept
    {
        const ends begun{add(a), add(b)};
        if (failed || !cells.push_back({line, begun.head})) {
            failed = true;
            return begun;
        }
        corners[begun.head].next = begun.tail;
        return begun;
    }
    void at_head(ends& of, std::uint32_t node) noexcept
    {
        const std::uint32_t c = add(node);
        if (failed) return;
        corners[c].next = of.head;
        of.head = c;
    }
    void at_tail(ends& of, std::uint32_t node) noexcept
    {
        const std::uint32_t c = add(node);
        if (failed) return;
        corners[of.tail].next = c;
        of.tail = c;
    }
    /// The segment ends in a node.
    void close(ends& of, std::uint32_t node) noexcept
    {
        at_tail(of, node);
        if (!failed) corners[of.tail].next = of.head;
    }
    /// The segment ends at a level, with some length left.
    void close(const ends& of) noexcept { corners[of.tail].next = of.head; }

    /// `of` becomes the left piece; the result is the right piece.
    ends split(ends& of, std::uint32_t node) noexcept
    {
        const std::uint32_t c = add(node);
        const ends right{c, of.tail};
        of.tail = c;
        return right;
    }

private:
    std::uint32_t add(std::uint32_t node) noexcept
    {
        if (!corners.push_back({node, none})) failed = true;
        return static_cast<std::uint32_t>(corners.size() - 1);
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
