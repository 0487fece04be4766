// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/orientation.hpp>
#include <typemesh/core/workspace.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The part of a span of interior between two consecutive points of it.
///
///       .------- - - -'-.         No point that sees it lies inside it or on its vertical sides. So `left` and `right`
///      /:::::::::::::::::\        see each other, in the extreme case along an edge of the region.
///     left:::::::::::::::right
///        \::::::::::::::/
///         '--> - - - --'          The region's edge along its lower side begins at the point `below`.
struct trapezoid {
    std::uint32_t left;
    std::uint32_t right;
    std::uint32_t below;
    std::uint32_t next;  // links lists of trapezoids
};

/// For monotone_sweep.hpp, instead of a cutter: numbers the points in sweep order and records all n + h - c trapezoids.
class trapezoid_output {
public:
    /// For a span: the last point met in it, and the point where its lower side begins.
    struct chains {
        std::uint32_t last;
        std::uint32_t below;
    };

    trapezoid_output(trapezoid* write, std::uint32_t* rank) noexcept : write_{write}, rank_{rank} {}

    /// One past the last trapezoid.
    [[nodiscard]] trapezoid* end() const noexcept { return write_; }

    [[nodiscard]] static bool open(workspace::scope&, std::size_t) noexcept { return true; }
    void start(chains& c, std::uint32_t v, grid_point) noexcept
    {
        number(v);
        c = {v, v};
    }
    template <std::uint32_t on>
    void extend(chains& c, std::uint32_t v, grid_point) noexcept
    {
        number(v);
        write(c, v);
        c.last = v;
        if (on == 0) c.below = v;
    }
    void split(chains& below, chains& above, std::uint32_t v, grid_point) noexcept
    {
        number(v);
        write(below, v);
        below.last = v;
        above = {v, v};
    }
    void merge(chains& lower, const chains& upper, std::uint32_t v, grid_point) noexcept
    {
        number(v);
        write(lower, v);
        write(upper, v);
        lower.last = v;
    }
    void finish(const chains& c, std::uint32_t v, grid_point) noexcept
    {
        number(v);
        write(c, v);
    }

private:
    void number(std::uint32_t v) noexcept { rank_[v] = count_++; }
    void write(const chains& c, std::uint32_t v) noexcept { *write_++ = {c.last, v, c.below, 0}; }

    trapezoid* write_;
    std::uint32_t* rank_;
    std::uint32_t count_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
