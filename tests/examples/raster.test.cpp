// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include "text_to_mesh/picture/raster.hpp"

#include <bit>
#include <random>
#include <vector>

using namespace text_to_mesh;

namespace {

/// How often each sample of a small picture is covered.
class counted {
public:
    explicit counted(int side) : side_(side), times_(static_cast<std::size_t>(side * side) * samples_per_pixel) {}

    void add(raster_point a, raster_point b, raster_point c)
    {
        each_covered_pixel(a, b, c, {0, 0, side_, side_}, [&](int x, int y, unsigned mask) {
            for (; mask != 0; mask &= mask - 1)
                times_[static_cast<std::size_t>(y * side_ + x) * samples_per_pixel +
                       static_cast<std::size_t>(std::countr_zero(mask))] += 1;
        });
    }

    [[nodiscard]] bool everywhere(int expected) const
    {
        for (const int t : times_)
            if (t != expected) return false;
        return true;
    }

    [[nodiscard]] int most() const
    {
        int m = 0;
        for (const int t : times_) m = t > m ? t : m;
        return m;
    }

private:
    int side_;
    std::vector<int> times_;
};

constexpr int side = 24;
constexpr std::int32_t whole = side * pixel_steps;

}  // namespace

TEST_CASE("a square cut into many triangles covers every sample exactly once", "[raster]")
{
    // A net of cells with shaken inner corners, some of them exactly on samples; diagonals and turns at random.
    std::mt19937 random(GENERATE(1u, 2u, 3u, 4u, 5u, 6u));
    const int cells = GENERATE(1, 3, 11, 40);
    std::vector<raster_point> net;
    const std::int32_t step = whole / cells;
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) {
            const auto shake = [&] {
                return static_cast<std::int32_t>(random() % static_cast<unsigned>(step / 2 + 1)) - step / 4;
            };
            const auto line = [&](int k, std::int32_t shaken) {
                return k == 0 ? -8 : (k == cells ? whole + 8 : k * step + shaken);
            };
            raster_point p{line(i, shake()), line(j, shake())};
            if (random() % 3 == 0 && i > 0 && i < cells && j > 0 && j < cells)
                p = {p.x / 16 * 16 + 8, p.y / 16 * 16 + 8};
            net.push_back(p);
        }
    }
    counted picture(side);
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const auto at = [&](int x, int y) { return net[static_cast<std::size_t>(y * (cells + 1) + x)]; };
            const raster_point a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            if (random() % 2 != 0) {
                picture.add(a, b, c);
                picture.add(c, a, d);
            } else {
                picture.add(b, d, a);
                picture.add(d, b, c);
            }
        }
    }
    CHECK(picture.everywhere(1));
}

TEST_CASE("a fan around a sample covers it once, whatever its outgoing_edges", "[raster]")
{
    const raster_point hub{12 * pixel_steps + sample_x[5], 9 * pixel_steps + sample_y[5]};
    const unsigned seed = GENERATE(1u, 2u, 3u);
    std::mt19937 random(seed);
    std::vector<raster_point> rim;
    for (int edge = 0; edge < 4; ++edge) {
        std::int32_t at = 0;
        while (at < whole) {
            rim.push_back(edge == 0   ? raster_point{at, 0}
                          : edge == 1 ? raster_point{whole, at}
                          : edge == 2 ? raster_point{whole - at, whole}
                                      : raster_point{0, whole - at});
            at += 1 + static_cast<std::int32_t>(random() % 300);
        }
    }
    counted picture(side);
    for (std::size_t i = 0; i < rim.size(); ++i) picture.add(hub, rim[i], rim[(i + 1) % rim.size()]);
    CHECK(picture.everywhere(1));
}

TEST_CASE("a triangle without area covers nothing, and one far outside is cut off", "[raster]")
{
    counted picture(side);
    picture.add({8, 8}, {800, 800}, {400, 400});
    picture.add({8, 8}, {8, 8}, {400, 500});
    picture.add({-50000, -50000}, {-40000, -50000}, {-40000, -100});
    CHECK(picture.everywhere(0));
    picture.add({-16000000, -16000000}, {16000000, -16000000}, {0, 16000000});
    CHECK(picture.everywhere(1));
    CHECK(picture.most() == 1);
}

TEST_CASE("each row and column of a pixel's sixteen holds one sample", "[raster]")
{
    unsigned rows = 0, columns = 0;
    for (int s = 0; s < samples_per_pixel; ++s) {
        rows |= 1u << (sample_y[s] / 16);
        columns |= 1u << (sample_x[s] / 16);
    }
    CHECK(rows == 0xFFFFu);
    CHECK(columns == 0xFFFFu);
}
