// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/morph/impl/keyed_outlines.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The points of a morphed outline: at the same parameters of its curves at every key, so that they move evenly
/// between keys.
///
/// Curves are divided at equal steps of t, into as many as Wang's bound requires where the curve bends most. The bound
/// is a multiple of the length of second differences of control points. These differences move evenly, so they are
/// nowhere longer than at one of the two keys beside, and the bound holds at every place (R. Goldman, Pyramid
/// Algorithms, 2003, 5.6.3).
struct morph_points {
    buffer<grid_point> places;     ///< all points at the first key, at the second key, ...
    buffer<contour_edge> edges;    ///< edges[i] runs from point i to the next point of its contour
    buffer<std::uint32_t> starts;  ///< as in contours

    explicit morph_points(memory source = heap()) noexcept
        : places{source}, edges{source}, starts{source}, from_{source}, kept_{source}, divided_{source}
    {
    }

    [[nodiscard]] std::uint32_t count() const noexcept { return static_cast<std::uint32_t>(edges.size()); }
    [[nodiscard]] std::uint32_t contours() const noexcept { return static_cast<std::uint32_t>(starts.size() - 1); }

    /// Divides the curves. Points that are equal at all keys become one. Contours of fewer than three points vanish.
    ///
    /// Fails  error::too_many_points, error::out_of_memory
    error divide(const keyed_outlines& outlines, double tolerance, const grid& g) noexcept
    {
        places.clear();
        edges.clear();
        starts.clear();
        kept_.clear();
        if (!starts.push_back(0)) return error::out_of_memory;
        const double rest = tolerance - g.snap_error() > g.snap_error() ? tolerance - g.snap_error() : g.snap_error();
        for (std::size_t c = 0; c + 1 < outlines.starts().size(); ++c)
            if (error e = add_contour(outlines, outlines.starts()[c], outlines.starts()[c + 1], rest, g)) return e;
        return place_all(outlines, g);
    }

    /// Computes the places anew, after a key was added.
    error place_all(const keyed_outlines& outlines, const grid& g) noexcept
    {
        places.clear();
        for (std::size_t k = 0; k < outlines.keys(); ++k)
            for (const contour_edge& e : edges)
                if (!places.push_back(g.snap(outlines.curves(k)[e.curve].at(as_double(e.t0)))))
                    return error::out_of_memory;
        return {};
    }

    /// Reverses all contours.
    void reverse() noexcept
    {
        const std::size_t n = count();
        for (std::uint32_t c = 0; c < contours(); ++c) {
            const std::size_t first = starts[c], size = starts[c + 1] - first;
            for (std::size_t k = 0; k * n < places.size(); ++k)
                for (std::size_t i = 0, j = size - 1; i < j; ++i, --j) {
                    const grid_point p = places[k * n + first + i];
                    places[k * n + first + i] = places[k * n + first + j];
                    places[k * n + first + j] = p;
                }
            for (std::size_t i = 0, j = size - 2; i < j && j < size; ++i, --j) {
                const contour_edge e = edges[first + i];
                edges[first + i] = edges[first + j];
                edges[first + j] = e;
            }
            for (std::size_t i = 0; i < size; ++i) {
                contour_edge& e = edges[first + i];
                e = {e.curve, e.t1, e.t0};
            }
        }
    }

    /// Divides a contour by a chord between its points u < v, given as numbers within the contour: into the points from
    /// u to v, and those from v to u, in this order. Call place_all() afterwards.
    error split(std::uint32_t contour, std::uint32_t u, std::uint32_t v) noexcept
    {
        const std::uint32_t first = starts[contour], size = starts[contour + 1] - first;
        divided_.clear();
        bool stored = divided_.append(edges.view().first(first));
        const auto put = [&](std::uint32_t from, std::uint32_t length) noexcept {
            for (std::uint32_t i = 0; i <= length; ++i) {
                contour_edge e = edges[first + (from + i) % size];
                if (i == length) e.t1 = chord;
                stored = stored && divided_.push_back(e);
            }
        };
        put(u, v - u);
        put(v, size - (v - u));
        stored = stored && divided_.append(edges.view().subspan(first + size)) && starts.push_back(0);
        if (!stored) return error::out_of_memory;
        edges.swap(divided_);
        for (std::size_t c = starts.size() - 1; c > contour + 1; --c) starts[c] = starts[c - 1] + 2;
        starts[contour + 1] = first + (v - u) + 1;
        return {};
    }

    /// Whether an edge is a chord that split() has made, and follows no curve.
    [[nodiscard]] bool is_chord(std::uint32_t edge) const noexcept { return edges[edge].t1 < 0.0f; }

private:
    static constexpr std::uint32_t max_points = 100000;  // points of one glyph
    static constexpr float chord = -1.0f;                // instead of t1

    static std::uint32_t pieces(const keyed_outlines& outlines, std::uint32_t i, double tolerance) noexcept
    {
        double square = 0.0, share = 0.0;
        for (std::size_t k = 0; k < outlines.keys(); ++k) {
            const curve& c = outlines.curves(k)[i];
            if (c.degree == 1) return 1;
            share = c.degree == 2 ? 0.25 : 0.75;
            for (std::uint32_t j = 0; j + 2 <= c.degree; ++j) {
                const point d = c.p[j] - 2.0 * c.p[j + 1] + c.p[j + 2];
                square = dot(d, d) > square ? dot(d, d) : square;
            }
        }
        const double wanted = std::ceil(std::sqrt(share * std::sqrt(square) / tolerance));
        return wanted < 1.0 ? 1u : wanted > 10000.0 ? 10000u : static_cast<std::uint32_t>(wanted);
    }

    /// Where a parameter of a curve lies at all keys, appended to a list.
    static bool locate(const keyed_outlines& outlines, std::uint32_t i, float t, const grid& g,
                       buffer<grid_point>& out) noexcept
    {
        for (std::size_t k = 0; k < outlines.keys(); ++k)
            if (!out.push_back(g.snap(outlines.curves(k)[i].at(as_double(t))))) return false;
        return true;
    }

    error add_contour(const keyed_outlines& outlines, std::uint32_t first, std::uint32_t end, double tolerance,
                      const grid& g) noexcept
    {
        const std::size_t begin = edges.size(), keys = outlines.keys();
        kept_.clear();
        const auto is_same = [&](array_view<const grid_point> a, array_view<const grid_point> b) noexcept {
            for (std::size_t k = 0; k < keys; ++k)
                if (!(a[k] == b[k])) return false;
            return true;
        };
        for (std::uint32_t i = first; i < end; ++i) {
            const std::uint32_t n = pieces(outlines, i, tolerance);
            for (std::uint32_t k = 0; k < n; ++k) {
                const auto t0 = static_cast<float>(static_cast<double>(k) / n),
                           t1 = static_cast<float>(static_cast<double>(k + 1) / n);
                from_.clear();
                if (!locate(outlines, i, t0, g, from_)) return error::out_of_memory;
                if (edges.size() > begin && is_same(kept_.view().last(keys), from_.view())) {
                    edges.back() = {i, t0, t1};  // the point before has the edge that leaves the last of them
                    continue;
                }
                if (edges.size() >= max_points) return {error::too_many_points, max_points};
                if (!edges.push_back({i, t0, t1}) || !kept_.append(from_.view())) return error::out_of_memory;
            }
        }
        if (edges.size() - begin > 1 && is_same(kept_.view().last(keys), kept_.view().first(keys)))
            edges.truncate(edges.size() - 1);
        if (edges.size() - begin < 3) edges.truncate(begin);
        if (edges.size() != begin && !starts.push_back(count())) return error::out_of_memory;
        return {};
    }

    buffer<grid_point> from_, kept_;
    buffer<contour_edge> divided_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
