// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/refine/impl/refinable_mesh.hpp>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Weights of a mesh's points, so that the radical centre of each triangle lies inside it.
///
///             c                 The *power* of a place at a point of weight w is its squared distance less w. The
///           / | \               radical centre o has the same power at all corners. The perpendicular from o to an
///         /   |   \             edge meets it at a *foot*, where both ends of the edge have the same power. It depends
///       f2-___o___-f1           on the ends and their weights alone, so both triangles of the edge have the same foot.
///       /     |     \           If o lies inside, the triangle consists of six right triangles.
///      a------f3-----b          With equal weights, o is the centre of the circle around the triangle.
///
/// That o lies on the inner side of an edge, and that a foot lies on its edge, are linear inequalities of the weights.
/// settle() corrects weights for one broken inequality after the other, until none is broken. It goes somewhat farther
/// than the inequalities, so that rounding to the grid does no harm.
///
/// From  M. Bern, S. Mitchell & J. Ruppert, Linear-size nonobtuse triangulation of polygons (1995), where the weights
///       are the squared radii of circles that touch; P. Mullen, P. Memari, F. de Goes & M. Desbrun, HOT:
///       Hodge-optimized triangulations (2011), for weights; S. Agmon, The relaxation method for linear inequalities
///       (1954)
class radical_weights {
public:
    explicit radical_weights(memory source = heap()) noexcept
        : all_{source}, triangles_{source}, fans_{source}, in_fans_{source}, waiting_{source}
    {
    }

    void clear() noexcept { all_.clear(); }

    /// Reads a mesh. The points that it had before keep their weights; others may have been added since. False if out
    /// of memory.
    [[nodiscard]] bool open(const refinable_mesh& mesh) noexcept
    {
        const std::size_t old = all_.size(), n = mesh.vertex_count();
        weighted* const added = all_.append(n - old);
        triangles_.clear();
        measured* const to = triangles_.append(mesh.triangle_count());
        if (added == nullptr || to == nullptr) return false;
        for (std::size_t i = 0; i < n - old; ++i) added[i].weight = 0.0;
        for (weighted& v : all_) v.pace = 0x1p1000;
        for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
            to[t] = measure(mesh, t);
            for (int k = 0; k < 3; ++k) {
                const double square = to[t].square(k);
                for (const int end : {(k + 1) % 3, (k + 2) % 3}) {
                    double& pace = all_[to[t].corner[end]].pace;
                    pace = square < pace ? square : pace;
                }
            }
        }
        for (weighted& v : all_) v.pace *= v.pace;
        return list_fans();
    }

    /// Corrects weights in up to so many passes over all triangles. Whether no triangle needs a correction any more.
    /// With a margin of 1, centres keep 0.3 of the inscribed circle's radius from the edges, and feet keep 0.08 of an
    /// edge from its ends; with less, so much less. 0 < margin <= 1.
    ///
    /// Cost   O(n), and O(1) for each correction on average; a pass looks only at triangles whose weights have changed
    [[nodiscard]] bool settle(int passes, double margin) noexcept
    {
        margin_ = margin;
        for (std::uint64_t& word : waiting_) word = ~std::uint64_t{0};
        if (triangles_.size() % 64 != 0) waiting_.back() = (std::uint64_t{1} << triangles_.size() % 64) - 1;
        for (; passes != 0; --passes) {
            bool is_settled = true;
            for (std::size_t word = 0; word < waiting_.size(); ++word)
                for (std::uint64_t left = waiting_[word]; left != 0;) {
                    const int bit = std::countr_zero(left);
                    waiting_[word] &= ~(std::uint64_t{1} << bit);
                    if (!correct(64 * word + static_cast<std::size_t>(bit))) is_settled = false;
                    left = bit == 63 ? 0 : waiting_[word] & (~std::uint64_t{1} << bit);
                }
            if (is_settled) return true;
        }
        return false;
    }

    /// Whether the radical centre of a triangle lies inside, its feet lie on its edges, and all that with a fifth of
    /// the distance that settle() aims at.
    [[nodiscard]] bool is_centred(std::uint32_t t) const noexcept
    {
        const measured& m = triangles_[t];
        for (int k = 0; k < 3; ++k) {
            const double square = m.square(k), off = foot_offset(m, k);
            const double wanted = 0.2 * margin_ * m.wanted * std::sqrt(square),
                         most = (1.0 - 0.4 * margin_ * foot_margin) * square;
            if (height(m, k) < wanted || off > most || off < -most) return false;
        }
        return true;
    }

    /// The share of the edge from u to v, whose squared length is given, at which its foot lies.
    [[nodiscard]] double foot_share(std::uint32_t u, std::uint32_t v, double square) const noexcept
    {
        return 0.5 * (1.0 + (all_[u].weight - all_[v].weight) / square);
    }

    /// The radical centre of a triangle, in cells, relative to its first corner.
    [[nodiscard]] point centre_of(const refinable_mesh& mesh, std::uint32_t t) const noexcept
    {
        const std::uint32_t a = mesh.origin(4 * t), b = mesh.origin(4 * t + 1), c = mesh.origin(4 * t + 2);
        const grid_point p = mesh.place(a), q = mesh.place(b), r = mesh.place(c);
        const double qx = static_cast<double>(q.x) - p.x, qy = static_cast<double>(q.y) - p.y,
                     rx = static_cast<double>(r.x) - p.x, ry = static_cast<double>(r.y) - p.y;
        const double at_q = qx * qx + qy * qy - all_[b].weight + all_[a].weight,
                     at_r = rx * rx + ry * ry - all_[c].weight + all_[a].weight;
        const double scale = 0.5 / static_cast<double>(orientation(p, q, r));
        return {(at_q * ry - at_r * qy) * scale, (at_r * qx - at_q * rx) * scale};
    }

private:
    static constexpr double inner_margin = 0.3;  // of the radius of the inscribed circle
    static constexpr double foot_margin = 0.08;  // of an edge

    struct weighted {
        double weight;
        double pace;  // how much it moves by a correction: the fourth power of the length of its shortest edge
    };

    /// A triangle: what is opposite corner k concerns the edge between the two others.
    struct measured {
        std::uint32_t corner[3];
        double dot[3];  // of the edges at a corner
        double wanted;  // the least height of the radical centre above an edge, times four areas

        /// The squared length of the edge opposite a corner.
        [[nodiscard]] double square(int k) const noexcept { return dot[(k + 1) % 3] + dot[(k + 2) % 3]; }
    };

    [[nodiscard]] static measured measure(const refinable_mesh& mesh, std::uint32_t t) noexcept
    {
        measured m{};
        grid_point at[3];
        for (std::uint32_t k = 0; k < 3; ++k) {
            m.corner[k] = mesh.origin(4 * t + k);
            at[k] = mesh.start(4 * t + k);
        }
        double around = 0.0;
        for (int k = 0; k < 3; ++k) {
            const grid_point o = at[k], p = at[(k + 1) % 3], q = at[(k + 2) % 3];
            const std::int64_t px = std::int64_t{p.x} - o.x, py = std::int64_t{p.y} - o.y, qx = std::int64_t{q.x} - o.x,
                               qy = std::int64_t{q.y} - o.y;
            m.dot[k] = static_cast<double>(px * qx + py * qy);
        }
        for (int k = 0; k < 3; ++k) around += std::sqrt(m.square(k));
        const auto doubled = static_cast<double>(orientation(at[0], at[1], at[2]));
        m.wanted = 2.0 * inner_margin * doubled * doubled / around;
        return m;
    }

    /// Lists the triangles around each point. False if out of memory.
    [[nodiscard]] bool list_fans() noexcept
    {
        fans_.clear();
        in_fans_.clear();
        waiting_.clear();
        std::uint32_t* const starts = fans_.append(all_.size() + 1);
        std::uint32_t* const list = in_fans_.append(3 * triangles_.size());
        if (starts == nullptr || list == nullptr || !waiting_.append((triangles_.size() + 63) / 64)) return false;
        for (std::size_t v = 0; v <= all_.size(); ++v) starts[v] = 0;
        for (const measured& t : triangles_)
            for (const std::uint32_t v : t.corner) ++starts[v];
        std::uint32_t count = 0;
        for (std::size_t v = 0; v <= all_.size(); ++v) starts[v] = count += starts[v];  // where the list of v ends
        for (std::size_t t = triangles_.size(); t-- != 0;)
            for (const std::uint32_t v : triangles_[t].corner) list[--starts[v]] = static_cast<std::uint32_t>(t);
        return true;
    }

    /// Corrects the weights of a triangle's corners. If that was necessary, all triangles around them wait for a look
    /// again. Whether it was not.
    [[nodiscard]] bool correct(std::size_t triangle) noexcept
    {
        const measured& t = triangles_[triangle];
        bool is_right = true;
        for (int k = 0; k < 3; ++k) {
            const bool is_inside = centre(t, k), is_on_edge = move_foot(t, k);
            is_right = is_right && is_inside && is_on_edge;
        }
        if (is_right) return true;
        for (const std::uint32_t v : t.corner)
            for (std::uint32_t i = fans_[v]; i < fans_[v + 1]; ++i)
                waiting_[in_fans_[i] / 64] |= std::uint64_t{1} << in_fans_[i] % 64;
        return false;
    }

    /// The height of the radical centre above the edge opposite corner k, times the edge's length and four areas.
    [[nodiscard]] double height(const measured& t, int k) const noexcept
    {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const double w = all_[t.corner[k]].weight;
        return t.square(k) * t.dot[k] + t.dot[j] * (all_[t.corner[i]].weight - w) +
               t.dot[i] * (all_[t.corner[j]].weight - w);
    }

    /// Twice the distance of a foot from the middle of the edge opposite corner k, times the edge's length.
    [[nodiscard]] double foot_offset(const measured& t, int k) const noexcept
    {
        return all_[t.corner[(k + 1) % 3]].weight - all_[t.corner[(k + 2) % 3]].weight;
    }

    /// Moves the radical centre to the inner side of the edge opposite corner k, if it is not there. Whether it was.
    [[nodiscard]] bool centre(const measured& t, int k) noexcept
    {
        const double square = t.square(k), wanted = margin_ * t.wanted * std::sqrt(square), now = height(t, k);
        if (now >= wanted) return true;
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        weighted &a = all_[t.corner[i]], &b = all_[t.corner[j]], &c = all_[t.corner[k]];
        const double at_a = t.dot[j] * a.pace, at_b = t.dot[i] * b.pace, at_c = square * c.pace;
        const double step = (1.1 * wanted - now) / (t.dot[j] * at_a + t.dot[i] * at_b + square * at_c);
        a.weight += step * at_a;
        b.weight += step * at_b;
        c.weight -= step * at_c;
        return false;
    }

    /// Moves the foot of the edge opposite corner k away from the edge's ends, if it is not. Whether it was.
    [[nodiscard]] bool move_foot(const measured& t, int k) noexcept
    {
        const double square = t.square(k), off = foot_offset(t, k), most = (1.0 - 2.0 * margin_ * foot_margin) * square;
        if (off <= most && off >= -most) return true;
        weighted &a = all_[t.corner[(k + 1) % 3]], &b = all_[t.corner[(k + 2) % 3]];
        const double step = ((off > 0.0 ? 0.95 * most : -0.95 * most) - off) / (a.pace + b.pace);
        a.weight += step * a.pace;
        b.weight -= step * b.pace;
        return false;
    }

    double margin_ = 1.0;
    buffer<weighted> all_;
    buffer<measured> triangles_;
    buffer<std::uint32_t> fans_, in_fans_;  // where the triangles around a point begin, and these
    buffer<std::uint64_t> waiting_;         // a bit for each triangle: whether it needs a look
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
