// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/orientation.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// For each span of interior, the points that a sweep has met but could not cut into triangles yet: a chain along the
/// span's lower side (0) or its upper side (1).
///
///      c0 ---- c1 ----- c2 ----     p comes on the lower side. It sees all of a chain along the upper side. This chain
///        '.     .      .   ::::     is cut into (c0 p c1) (c1 p c2) and closed; the chain c2 p remains.
///          '.    .   .    :::::
///            '---- p ----------     From a chain along its own side, p cuts off all left turns, and becomes its end.
///
/// A span has both chains at once only after a merge. There they end in the same point m. An edge joins the next point
/// in the span to m and closes one of them. No partition into monotone polygons is needed first.
///
///      ------------.                  the chain along the upper side of the lower part,
///                    m    p           the chain along the lower side of the upper part: both end in m.
///      ------------'
///
/// `Output` takes the triangles and defines the type of their edges: see triangle_output.
template <class Output>
class chain_cutter {
    struct link {
        grid_point place;
        std::uint32_t point;
        std::uint32_t before;        // the previous link; 0: none
        typename Output::edge edge;  // to that link, as seen from the interior
    };

public:
    /// The chains of one span: their last links; 0: none.
    struct chains {
        std::uint32_t last[2];
    };

    explicit chain_cutter(Output out) noexcept : out_{out} {}

    /// Takes memory for loops of n points. False if out of memory.
    [[nodiscard]] bool open(workspace::scope& scratch, std::size_t n) noexcept
    {
        links_ = scratch.take<link>(2 * n + n / 2 + 2);  // one per point, one extra per merge, two extra per split
        return links_ != nullptr;
    }

    [[nodiscard]] const Output& output() const noexcept { return out_; }

    /// A span opens at v.
    void start(chains& c, std::uint32_t v, grid_point p) noexcept { c = {{add(p, out_.name(v), 0, {}), 0}}; }

    /// v lies on side `on`: closes the chain along the other side, extends the chain along this side.
    template <std::uint32_t on>
    void extend(chains& c, std::uint32_t v, grid_point p) noexcept
    {
        v = out_.name(v);
        const std::uint32_t own = c.last[on], other = c.last[1 - on];
        if (other == 0) {
            c.last[on] = push<on>(own, v, p, out_.template boundary<on>(links_[own].point, v));
            return;
        }
        const auto edge = fan<1 - on>(other, v, p);
        c.last[1 - on] = 0;
        if (own == 0) {
            links_[other].before = 0;
            c.last[on] = add(p, v, other, edge);
        } else {
            c.last[on] = push<on>(own, v, p, edge);
        }
    }

    /// v splits the span of `below`; the part above v gets `above`.
    void split(chains& below, chains& above, std::uint32_t v, grid_point p) noexcept
    {
        v = out_.name(v);
        std::uint32_t up = below.last[1], low = below.last[0];
        if (up == 0) up = add(links_[low].place, links_[low].point, 0, {});
        if (low == 0) low = add(links_[up].place, links_[up].point, 0, {});
        const auto diagonal = out_.diagonal();
        below = {{0, push<1>(up, v, p, diagonal.first)}};
        above = {{push<0>(low, v, p, diagonal.second), 0}};
    }

    /// v ends two spans, the lower one at its upper side and the upper one at its lower side; they become one.
    void merge(chains& lower, chains& upper, std::uint32_t v, grid_point p) noexcept
    {
        extend<0>(upper, v, p);
        extend<1>(lower, v, p);
        lower.last[0] = upper.last[0];
    }

    /// v ends the span.
    void finish(const chains& c, std::uint32_t v, grid_point p) noexcept
    {
        v = out_.name(v);
        if (c.last[0] != 0 && c.last[1] != 0) {
            const auto first = fan<0>(c.last[0], v, p);
            out_.join(first, fan<1>(c.last[1], v, p));
        } else if (c.last[0] != 0) {
            out_.close(fan<0>(c.last[0], v, p));
        } else {
            out_.close(fan<1>(c.last[1], v, p));
        }
    }

private:
    std::uint32_t add(grid_point p, std::uint32_t v, std::uint32_t before, typename Output::edge edge) noexcept
    {
        links_[++count_] = {p, v, before, edge};
        return count_;
    }

    struct delta {
        std::int64_t x, y;
        [[nodiscard]] static delta to(grid_point p, grid_point from) noexcept
        {
            return {std::int64_t{p.x} - from.x, std::int64_t{p.y} - from.y};
        }
    };

    /// Makes triangles from v to every edge of a chain on the opposite side. Returns the edge from v to the chain's
    /// end.
    template <std::uint32_t along>
    auto fan(std::uint32_t at, std::uint32_t v, grid_point p) noexcept
    {
        std::uint32_t before = links_[at].before;
        if (before == 0) return out_.template boundary<1 - along>(links_[at].point, v);
        const auto first = out_.template next_outer<along>();
        auto edge = out_.nobody();
        delta b = delta::to(p, links_[at].place);
        do {
            const delta a = delta::to(p, links_[before].place);
            const std::int64_t turn = a.x * b.y - a.y * b.x;  // orientation(a, b, p)
            edge = out_.template cut<along>(links_[before], links_[at], v, p, along == 0 ? turn : -turn, edge);
            b = a;
            at = before;
            before = links_[at].before;
        } while (before != 0);
        out_.close(edge);
        return first;
    }

    /// Cuts off the corners at the end of the chain along `on` that turn towards the interior, and makes v its end.
    /// `edge` joins v to the chain's end.
    template <std::uint32_t on>
    [[nodiscard]] std::uint32_t push(std::uint32_t at, std::uint32_t v, grid_point p,
                                     typename Output::edge edge) noexcept
    {
        const std::uint32_t before = links_[at].before;
        if (before != 0) {
            const std::int64_t doubled_area = corner<on>(before, at, p);
            if (doubled_area > 0) at = cut_corners<on>(before, at, v, p, doubled_area, edge);
        }
        return add(p, v, at, edge);
    }
    /// The same, where at least one such corner exists. Updates `edge`. Returns the last link that remains.
    template <std::uint32_t on>
    [[nodiscard]] std::uint32_t cut_corners(std::uint32_t before, std::uint32_t at, std::uint32_t v, grid_point p,
                                            std::int64_t doubled_area, typename Output::edge& edge) noexcept
    {
        do {
            edge = out_.template cut<on>(links_[before], links_[at], v, p, doubled_area, edge);
            at = before;
            before = links_[at].before;
            if (before == 0) break;
            doubled_area = corner<on>(before, at, p);
        } while (doubled_area > 0);
        return at;
    }
    template <std::uint32_t on>
    [[nodiscard]] std::int64_t corner(std::uint32_t before, std::uint32_t at, grid_point p) const noexcept
    {
        const std::int64_t turn = orientation(links_[before].place, links_[at].place, p);
        return on == 0 ? turn : -turn;
    }

    link* links_ = nullptr;
    std::uint32_t count_ = 0;
    Output out_;
};

/// Writes triangles one after the other and keeps the smallest doubled area. Ignores edges.
class triangle_output {
public:
    struct edge {};
    struct edge_pair {
        edge first, second;
    };

    explicit triangle_output(triangle* write) noexcept : write_{write} {}

    [[nodiscard]] triangle* end() const noexcept { return write_; }
    /// The smallest doubled area of all triangles.
    [[nodiscard]] std::int64_t smallest() const noexcept { return smallest_; }
    [[nodiscard]] static std::uint32_t name(std::uint32_t v) noexcept { return v; }

    /// Writes the triangle of v and the two links a, b of a chain along side `along`; its doubled area is given. `edge`
    /// joins b and v. Returns the edge of a and v.
    template <std::uint32_t along, class Link>
    edge cut(const Link& a, const Link& b, std::uint32_t v, grid_point, std::int64_t doubled_area, edge) noexcept
    {
        if (doubled_area < smallest_) [[unlikely]]
            smallest_ = doubled_area;
        *write_++ = {a.point, along == 0 ? b.point : v, along == 0 ? v : b.point};
        return {};
    }
    /// The edge that joins b and v in the next triangle.
    template <std::uint32_t along>
    [[nodiscard]] static edge next_outer() noexcept
    {
        return {};
    }
    /// The region's own edge from `left` to v on side `on`.
    template <std::uint32_t on>
    [[nodiscard]] static edge boundary(std::uint32_t, std::uint32_t) noexcept
    {
        return {};
    }
    /// Both sides of an edge; neither has a triangle yet.
    [[nodiscard]] static edge_pair diagonal() noexcept { return {}; }
    [[nodiscard]] static edge nobody() noexcept { return {}; }
    /// These two are the sides of one edge.
    static void join(edge, edge) noexcept {}
    /// This is an edge of the region.
    static void close(edge) noexcept {}

private:
    triangle* write_;
    std::int64_t smallest_ = (std::numeric_limits<std::int64_t>::max)();
};

/// Cuts nothing: for a sweep that only proves.
struct no_cutter {
    struct chains {};
    [[nodiscard]] static bool open(workspace::scope&, std::size_t) noexcept { return true; }
    static void start(chains&, std::uint32_t, grid_point) noexcept {}
    template <std::uint32_t on>
    static void extend(chains&, std::uint32_t, grid_point) noexcept
    {
    }
    static void split(chains&, chains&, std::uint32_t, grid_point) noexcept {}
    static void merge(chains&, chains&, std::uint32_t, grid_point) noexcept {}
    static void finish(const chains&, std::uint32_t, grid_point) noexcept {}
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
