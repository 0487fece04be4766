// SPDX-License-Identifier: MIT

#include <typemesh/fill/outer_of.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/filled_shape.hpp"
#include "support/regions.hpp"

using namespace typemesh;

namespace {

/// The loops that bound one piece of interior, found from triangles: two that share an edge belong to one piece.
class pieces {
public:
    pieces(const region& r, workspace& space)
    {
        triangle_list triangles;
        REQUIRE_FALSE(monotone{}(r, space, triangles));
        std::vector<std::uint32_t> loop_of(r.points().size());
        for (std::uint32_t k = 0; k < r.loop_count(); ++k)
            for (std::uint32_t i = r.starts()[k]; i < r.starts()[k + 1]; ++i) loop_of[i] = k;
        parent_.resize(r.loop_count());
        for (std::uint32_t k = 0; k < parent_.size(); ++k) parent_[k] = k;
        for (const triangle t : triangles)  // a triangle's corners are points of loops round its own piece
            for (const std::uint32_t corner : {t.b, t.c}) parent_[root(loop_of[t.a])] = root(loop_of[corner]);
    }
    std::uint32_t root(std::uint32_t k) const
    {
        while (parent_[k] != k) k = parent_[k];
        return k;
    }

private:
    std::vector<std::uint32_t> parent_;
};

bool is_outer(const region& r, std::uint32_t k)
{
    double area = 0.0;
    const std::uint32_t first = r.starts()[k], end = r.starts()[k + 1];
    for (std::uint32_t i = first; i < end; ++i) {
        const grid_point a = r.points()[i], b = r.points()[i + 1 == end ? first : i + 1];
        area += static_cast<double>(a.x) * b.y - static_cast<double>(a.y) * b.x;
    }
    return area > 0.0;
}

void check(const test::filled_shape& f)
{
    const region& r = f.filled;
    workspace space;
    std::vector<std::uint32_t> outer(r.loop_count());
    REQUIRE(outer_of(r, space, outer));
    const pieces same_piece{r, space};
    for (std::uint32_t k = 0; k < r.loop_count(); ++k) {
        CHECK(is_outer(r, outer[k]));
        CHECK(same_piece.root(outer[k]) == same_piece.root(k));
        if (is_outer(r, k)) CHECK(outer[k] == k);
    }
}

/// Boxes and diamonds on a coarse lattice: nested, touching in corners and along sides, crossing.
test::shape heap_of_boxes(test::dice& d, int count, int width)
{
    test::shape s{"boxes", {}};
    for (int i = 0; i < count; ++i) {
        const int x = d.roll(width), y = d.roll(width), w = 1 + d.roll(width / 4 + 1), h = 1 + d.roll(width / 4 + 1);
        if (d.roll(3) == 0)
            s.loops.push_back({{8 * x, 8 * (y + w)},
                               {8 * (x + w), 8 * y},
                               {8 * (x + 2 * w), 8 * (y + w)},
                               {8 * (x + w), 8 * (y + 2 * w)}});
        else
            s.loops.push_back({{8 * x, 8 * y}, {8 * (x + w), 8 * y}, {8 * (x + w), 8 * (y + h)}, {8 * x, 8 * (y + h)}});
    }
    return s;
}

}  // namespace

TEST_CASE("each hole has the outer loop of the interior around it", "[fill][outer_of]")
{
    test::dice d{77};
    std::size_t with_islands = 0;
    for (int i = 0; i < 1000; ++i) {
        const test::shape s = heap_of_boxes(d, 10 + d.roll(40), 10 + d.roll(30));
        INFO(s);
        const test::filled_shape f{s, fill_rule::even_odd};
        check(f);
        with_islands += f.filled.outers() > 1 && f.filled.holes() > 0 ? 1u : 0u;
    }
    CHECK(with_islands > 100);
}

TEST_CASE("outer_of() works for nests of any depth and order", "[fill][outer_of]")
{
    test::dice d{5};
    for (int i = 0; i < 200; ++i) {
        test::shape s{"nest", {}};
        for (int k = 0; k < 12; ++k) {
            const int r = 100 * (k + 1);
            s.loops.push_back({{-r, -r}, {r, -r}, {r, r}, {-r, r}});
        }
        for (std::size_t k = s.loops.size(); k > 1; --k)
            std::swap(s.loops[k - 1], s.loops[static_cast<std::size_t>(d.roll(static_cast<int>(k)))]);
        const test::filled_shape f{s, fill_rule::even_odd};
        REQUIRE(f.filled.holes() == 6);
        check(f);
    }
}

TEST_CASE("outer_of() needs only a few bytes of scratch memory a loop", "[fill][outer_of]")
{
    test::counting_memory memory;
    workspace space{memory.source()};
    const test::filled_shape f{{"hole", {{{0, 0}, {90, 0}, {90, 90}, {0, 90}}, {{10, 10}, {20, 10}, {20, 20}}}},
                               fill_rule::even_odd};
    std::vector<std::uint32_t> outer(2);
    REQUIRE(outer_of(f.filled, space, outer));
    const std::size_t before = memory.requests;
    REQUIRE(outer_of(f.filled, space, outer));
    CHECK(memory.requests == before);
    CHECK(outer_of(region{}, space, {}));

    test::counting_memory none{.fail_at = 1};
    workspace empty{none.source()};
    CHECK(outer_of(f.filled, empty, outer) == error::out_of_memory);
}
