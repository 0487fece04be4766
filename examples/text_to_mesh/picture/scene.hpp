// SPDX-License-Identifier: MIT
#pragma once

#include "camera.hpp"
#include "flat_triangle.hpp"
#include "model.hpp"
#include "picture_options.hpp"
#include "view.hpp"

#include <cstdint>
#include <vector>

namespace text_to_mesh {

/// A line or, where both ends are one, a dot.
struct flat_line {
    double x[2], y[2], inverse[2];
    double radius;
    double opacity;
    vec3 colour;
};

/// What a picture shows: the triangles and lines that its camera sees, on the picture, and for each of its square tiles
/// the numbers of those that may reach into it. Tiles stand row by row; what is infinitely far off is left out.
class scene {
public:
    static constexpr int tile_side = 64;  ///< in pixels

    struct tile {
        std::vector<std::uint32_t> triangles, lines;
    };

    scene(const model& mesh, const overlay& over, const picture_options& options, const view& seen);

    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] const tile& at(int column, int row) const
    {
        return tiles_[static_cast<std::size_t>(row * columns_ + column)];
    }
    [[nodiscard]] const flat_triangle& triangle(std::uint32_t number) const { return triangles_[number]; }
    [[nodiscard]] const flat_line& line(std::uint32_t number) const { return lines_[number]; }

private:
    template <class Add>
    void each_tile(double left, double top, double right, double bottom, Add&& add);

    void add_triangles(const model& mesh);
    void add_triangle(const model& mesh, std::uint32_t first, std::uint32_t part);
    void add_wireframe(const model& mesh, double radius);
    void add_overlay(const overlay& over, double radius);
    void add_line(const float (&a)[3], const float (&b)[3], const unsigned char (&rgb)[3], double radius,
                  double opacity);

    camera from_;
    int columns_, rows_;
    std::vector<flat_triangle> triangles_;
    std::vector<flat_line> lines_;
    std::vector<tile> tiles_;
};

}  // namespace text_to_mesh
