// SPDX-License-Identifier: MIT
#pragma once

// A region's boundary moved inwards like the straight skeleton, by brute force: slow, plain, and without code of the room
// offset/. After every event all pairs are searched for the next event, in long doubles.

#include <typemesh/core/point.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace test {

/// A position or a direction, in cells.
struct real_point {
    long double x = 0, y = 0;

    friend real_point operator+(real_point a, real_point b) { return {a.x + b.x, a.y + b.y}; }
    friend real_point operator-(real_point a, real_point b) { return {a.x - b.x, a.y - b.y}; }
    friend real_point operator*(long double s, real_point a) { return {s * a.x, s * a.y}; }
};
inline long double dot(real_point a, real_point b) { return a.x * b.x + a.y * b.y; }
inline long double cross(real_point a, real_point b) { return a.x * b.y - a.y * b.x; }
inline long double length(real_point a) { return std::sqrt(dot(a, a)); }
inline real_point to_the_left(real_point d) { return {-d.y, d.x}; }

/// Twice the area that loops enclose, counter-clockwise positive.
inline long double doubled_area(const std::vector<std::vector<real_point>>& loops)
{
    long double sum = 0;
    for (const auto& l : loops)
        for (std::size_t i = 0; i < l.size(); ++i) sum += cross(l[i] - l[0], l[(i + 1) % l.size()] - l[0]);
    return sum;
}

/// The joins at a corner sharper than the mitre limit.
struct slow_joins {
    long double mitre_limit = 0;      ///< 0: none, every corner is mitred
    long double round_tolerance = 0;  ///< in cells, for the chords of a round join at `width`; 0: not rounded
    long double width = 0;            ///< in cells
    int max_turns = 32;

    /// The corner's turn is divided into this many equal turns, a power of two.
    [[nodiscard]] int turns(long double turn) const
    {
        if (!(mitre_limit > 0) || 1 <= mitre_limit * std::cos(turn / 2)) return 1;
        int n = 1;
        const auto is_enough = [&] {
            const long double c = std::cos(turn / n / 2);
            return 1 <= mitre_limit * c && !(round_tolerance > 0 && width * (1 - c) > round_tolerance);
        };
        while (!is_enough() && n < max_turns) n *= 2;
        return n;
    }
};

/// The loops of a region (outer ones counter-clockwise, holes clockwise) on their way inwards.
class slow_wavefront {
public:
    slow_wavefront(const std::vector<std::vector<typemesh::grid_point>>& loops, const slow_joins& joins = {})
    {
        for (const auto& l : loops) {
            std::vector<corner> front;
            for (std::size_t i = 0; i < l.size(); ++i) {
                const auto at = [&](std::size_t k) {
                    const auto p = l[k % l.size()];
                    return real_point{static_cast<long double>(p.x), static_cast<long double>(p.y)};
                };
                const real_point here = at(i);
                const real_point in = unit(here - at(i + l.size() - 1)), out = unit(at(i + 1) - here);
                const long double turn = std::atan2(-cross(in, out), dot(in, out));  // to the right
                const int turns = turn > 0 ? joins.turns(turn) : 1;
                for (int k = 1; k < turns; ++k) {
                    const long double angle = -turn * k / turns, c = std::cos(angle), s = std::sin(angle);
                    front.push_back({here, {c * in.x - s * in.y, s * in.x + c * in.y}, {}});
                }
                front.push_back({here, out, {}});
            }
            fronts_.push_back(std::move(front));
        }
    }

    /// Moves on to this distance from the start, which must not be less than now.
    void advance(long double distance)
    {
        for (int steps = 0; !fronts_.empty(); ++steps) {
            aim();
            const long double step = next_event();
            if (now_ + step > distance + close || steps > 100'000) {
                doubtful_ = doubtful_ || steps > 100'000;
                move(distance - now_);
                break;
            }
            move(step);
            meet();
            ++events_;
        }
        now_ = distance;
    }

    [[nodiscard]] std::vector<std::vector<real_point>> loops() const
    {
        std::vector<std::vector<real_point>> all;
        for (const auto& f : fronts_) {
            all.emplace_back();
            for (const corner& c : f) all.back().push_back(c.at);
        }
        return all;
    }
    [[nodiscard]] long double area() const { return test::doubled_area(loops()) / 2; }
    /// The integral of the area over the distance moved so far: exact except for the rounding of sums.
    [[nodiscard]] long double swept_volume() const { return volume_; }
    [[nodiscard]] std::size_t events() const { return events_; }
    /// Whether an event changed nothing, so that rounding decided its result.
    [[nodiscard]] bool is_doubtful() const { return doubtful_; }

private:
    static constexpr long double close = 1e-7L;  // cells: nearer than this is the same place

    struct corner {
        real_point at, along;  // direction of the edge that leaves it
        real_point speed;
    };

    static real_point unit(real_point d) { return (1 / test::length(d)) * d; }

    /// The speed of each corner, with the lines of its two edges, which move inwards by 1.
    void aim()
    {
        for (auto& f : fronts_) {
            for (std::size_t i = 0; i < f.size(); ++i) {
                const real_point in = f[(i + f.size() - 1) % f.size()].along, out = f[i].along;
                if (dot(in, out) > 0) {
                    f[i].speed = (1 / (1 + dot(in, out))) * (to_the_left(in) + to_the_left(out));
                } else {
                    const long double c = cross(in, out);
                    f[i].speed = std::fabs(c) > 1e-17L ? (1 / c) * (out - in) : real_point{};
                }
            }
        }
    }

    void move(long double step)
    {
        now_ += step;
        const long double before = area();
        const auto half = [&] {
            for (auto& f : fronts_)
                for (corner& c : f) c.at = c.at + step / 2 * c.speed;
            return area();
        };
        const long double middle = half(), after = half();
        volume_ += step / 6 * (before + 4 * middle + after);  // the area is a square function between events
    }

    struct edge_ends {
        const corner *a, *b;

        [[nodiscard]] long double size() const { return dot(a->along, b->at - a->at); }
        [[nodiscard]] long double growth() const { return dot(a->along, b->speed - a->speed); }
    };
    [[nodiscard]] static edge_ends edge(const std::vector<corner>& f, std::size_t i)
    {
        return {&f[i], &f[(i + 1) % f.size()]};
    }

    /// Time until an edge has shrunk to nothing or a reflex corner runs into an edge.
    [[nodiscard]] long double next_event()
    {
        const long double least = ignored_ ? 1e-9L : 0;
        long double next = 1e300L;
        for (const auto& f : fronts_) {
            for (std::size_t i = 0; i < f.size(); ++i) {
                const edge_ends e = edge(f, i);
                if (e.growth() < 0) {
                    const long double t = (std::max)(0.0L, e.size()) / -e.growth();
                    if (t >= least) next = (std::min)(next, t);
                }
                const corner& before = f[(i + f.size() - 1) % f.size()];
                if (cross(before.along, f[i].along) >= 0) continue;
                for (const auto& g : fronts_) {
                    for (std::size_t k = 0; k < g.size(); ++k) {
                        if (&g[k] == &f[i] || &g[k] == &before) continue;
                        const long double t = until_hit(f[i], edge(g, k));
                        if (t >= least) next = (std::min)(next, t);
                    }
                }
            }
        }
        ignored_ = false;
        return next;
    }

    /// Time until a corner is on an edge; negative: never.
    [[nodiscard]] static long double until_hit(const corner& v, const edge_ends& e)
    {
        const real_point inward = to_the_left(e.a->along);
        const long double gap = dot(inward, v.at - e.a->at), closing = 1 - dot(inward, v.speed);
        if (!(closing > 0) || gap < -close) return -1;
        const auto place = [&](long double t) {  // along the edge
            return dot(e.a->along, v.at + t * v.speed - e.a->at - t * e.a->speed);
        };
        if (gap < close) {  // they touch: do they run into each other?
            const long double t = 1e-4L, s = place(t);
            const bool inside = s > 1e-3L * t && s < e.size() + t * e.growth() - 1e-3L * t;
            return inside ? 0 : -1;
        }
        const long double t = gap / closing, s = place(t);
        return s >= -close && s <= e.size() + t * e.growth() + close ? t : -1;
    }

    // --- events -----------------------------------------------------------------------------------------------------

    struct piece {
        std::size_t a, b;  // places
        real_point along;
        bool gone = false;
    };

    /// Makes boundaries simple that touch themselves. It cuts edges where corners lie on them, joins corners that are
    /// close, drops edges without length and pairs of edges that lie on each other, and leads the rest around each place
    /// so that every pass stays in its own sector of interior.
    void meet()
    {
        std::vector<real_point> places;
        const auto place_of = [&](real_point p) {
            for (std::size_t i = 0; i < places.size(); ++i)
                if (length(places[i] - p) < 2 * close) return i;
            places.push_back(p);
            return places.size() - 1;
        };
        std::vector<piece> pieces;
        std::size_t before = 0;
        for (const auto& f : fronts_) {
            before += f.size();
            for (std::size_t i = 0; i < f.size(); ++i) cut(edge(f, i), place_of, pieces);
        }
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            piece& p = pieces[i];
            p.gone = p.gone || p.a == p.b;
            for (std::size_t k = i + 1; k < pieces.size() && !p.gone; ++k)
                if (!pieces[k].gone && pieces[k].a == p.b && pieces[k].b == p.a) p.gone = pieces[k].gone = true;
        }
        const std::size_t fronts = fronts_.size();
        trace(places, pieces);
        std::size_t after = 0;
        for (const auto& f : fronts_) after += f.size();
        if (before == after && fronts == fronts_.size()) {
            ignored_ = true;
            if (++idle_ > 50) doubtful_ = true;
        }
    }

    /// Appends an edge, cut at every corner that lies on it.
    template <class Places>
    void cut(const edge_ends& e, const Places& place_of, std::vector<piece>& pieces) const
    {
        std::vector<std::pair<long double, std::size_t>> on;
        const long double size = e.size();
        if (size > close) {
            for (const auto& f : fronts_) {
                for (const corner& c : f) {
                    const long double s = dot(e.a->along, c.at - e.a->at);
                    if (&c != e.a && &c != e.b && s > close && s < size - close &&
                        std::fabs(cross(e.a->along, c.at - e.a->at)) < close)
                        on.emplace_back(s, place_of(c.at));
                }
            }
        }
        std::sort(on.begin(), on.end());
        std::size_t from = place_of(e.a->at);
        for (const auto& o : on) {
            pieces.push_back({from, o.second, e.a->along});
            from = o.second;
        }
        pieces.push_back({from, place_of(e.b->at), e.a->along});
    }

    /// The piece that follows `p` at its end: the last one clockwise before `p`'s own way back.
    [[nodiscard]] static std::size_t follow(const piece& p, const std::vector<piece>& pieces)
    {
        std::size_t best = pieces.size();
        long double widest = -1;
        const real_point back = -1 * p.along;
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            if (pieces[k].gone || pieces[k].a != p.b) continue;
            long double angle = std::atan2(cross(pieces[k].along, back), dot(pieces[k].along, back));
            if (angle < 0) angle += 2 * std::acos(-1.0L);  // from the piece counter-clockwise to the way back
            if (best == pieces.size() || angle < widest) {
                widest = angle;
                best = k;
            }
        }
        return best;
    }

    void trace(const std::vector<real_point>& places, std::vector<piece>& pieces)
    {
        fronts_.clear();
        std::vector<std::size_t> next(pieces.size(), pieces.size());
        std::vector<bool> taken(pieces.size() + 1, false);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (pieces[i].gone) continue;
            next[i] = follow(pieces[i], pieces);
            doubtful_ = doubtful_ || next[i] == pieces.size() || taken[next[i]];
            taken[next[i]] = true;
        }
        std::vector<bool> done(pieces.size() + 1, false);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            std::vector<corner> f;
            for (std::size_t k = i; k < pieces.size() && !pieces[k].gone && !done[k]; k = next[k]) {
                done[k] = true;
                f.push_back({places[pieces[k].a], pieces[k].along, {}});
            }
            straighten(f);
            if (f.size() > 2) fronts_.push_back(std::move(f));
        }
    }

    /// Drops corners between two pieces of one edge.
    static void straighten(std::vector<corner>& f)
    {
        for (std::size_t i = 0; i < f.size() && f.size() > 2;) {
            const real_point in = f[(i + f.size() - 1) % f.size()].along, out = f[i].along;
            if (dot(in, out) > 0 && std::fabs(cross(in, out)) < 1e-17L)
                f.erase(f.begin() + static_cast<std::ptrdiff_t>(i));
            else
                ++i;
        }
    }

    std::vector<std::vector<corner>> fronts_;
    long double now_ = 0, volume_ = 0;
    std::size_t events_ = 0;
    int idle_ = 0;
    bool ignored_ = false, doubtful_ = false;
};

}  // namespace test
