// SPDX-License-Identifier: MIT
#pragma once

#include "backdrop.hpp"
#include "model.hpp"
#include "picture_options.hpp"
#include "raster.hpp"
#include "scene.hpp"
#include "surface.hpp"
#include "vec3.hpp"
#include "view.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace text_to_mesh {

/// Draws one model once, tile by tile: which triangle each sample shows, what colour that is, then the lines over it.
class painter {
public:
    painter(const model& mesh, const overlay& over, const picture_options& options);

    [[nodiscard]] int width() const { return seen_.width; }
    [[nodiscard]] int height() const { return seen_.height; }
    /// width() * height() * 3 bytes of sRGB, rows from the top.
    [[nodiscard]] std::vector<unsigned char> paint();

private:
    static constexpr int tile_side = scene::tile_side;

    void paint_tile(int column, int row, std::vector<unsigned char>& rgb);
    void cover(const flat_triangle& t, std::uint32_t number, int x, int y, unsigned mask, std::size_t first_sample);
    /// The mean of a pixel's samples. Each triangle in it is shaded once, in the middle of its samples.
    [[nodiscard]] vec3 resolve(int x, int y, std::size_t first_sample) const;
    void paint_line(const flat_line& line, raster_window window);

    const view seen_;
    const backdrop backdrop_;
    const scene scene_;
    const surface surface_;
    std::vector<float> depth_;          ///< of one tile's samples: 1 / distance, 0 where there is nothing
    std::vector<std::uint32_t> owner_;  ///< the triangle that a sample shows
    std::vector<vec3> colour_;          ///< of one tile's pixels
};

}  // namespace text_to_mesh
