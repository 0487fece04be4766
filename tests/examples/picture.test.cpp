// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include "text_to_mesh/picture/picture.hpp"

#include "extruded_ring.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

using namespace text_to_mesh;

namespace {

struct image {
    int w = 0, h = 0;
    std::vector<unsigned char> rgb;

    image(const model& mesh, const picture_options& options, const overlay& over = {})
    {
        rgb = draw(mesh, over, options, w, h);
    }
    [[nodiscard]] const unsigned char* at(int x, int y) const { return rgb.data() + (y * w + x) * 3; }
    [[nodiscard]] bool white(int x, int y) const
    {
        return at(x, y)[0] == 255 && at(x, y)[1] == 255 && at(x, y)[2] == 255;
    }
    [[nodiscard]] bool same(int x, int y, const unsigned char* other) const
    {
        return std::equal(other, other + 3, at(x, y));
    }
};

picture_options plain(int width, int height)
{
    picture_options o;
    o.width = width;
    o.height = height;
    o.background = background::white;
    return o;
}

/// A flat square from -1 to 1 at this z, in cells * cells * 2 triangles with wavy inner corners.
model square(int cells, float z, const char* part)
{
    model m;
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) {
            const bool inner = i > 0 && j > 0 && i < cells && j < cells;
            const double wave = inner ? 0.3 / cells * std::sin(double(7 * i + 3 * j)) : 0.0;
            m.vertices.push_back({{static_cast<float>(2.0 * i / cells - 1.0 + wave),
                                   static_cast<float>(2.0 * j / cells - 1.0 - wave), z},
                                  {0, 0, 1},
                                  {0, 0}});
        }
    }
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const auto a = static_cast<std::uint32_t>(j * (cells + 1) + i), b = a + 1,
                       d = a + static_cast<std::uint32_t>(cells) + 1, c = d + 1;
            for (const std::uint32_t index : {a, b, c, a, c, d}) m.indices.push_back(index);
        }
    }
    m.parts = {{part, 0, m.indices.size()}};
    return m;
}

/// Both in one model; `first` comes first.
model together(const model& first, const model& second)
{
    model m = first;
    const auto base = static_cast<std::uint32_t>(m.vertices.size());
    m.vertices.insert(m.vertices.end(), second.vertices.begin(), second.vertices.end());
    for (model::part part : second.parts) {
        part.first_index += m.indices.size();
        m.parts.push_back(part);
    }
    for (const std::uint32_t i : second.indices) m.indices.push_back(base + i);
    return m;
}

}  // namespace

TEST_CASE("a flat wall of many triangles is one colour without cracks, in every shading", "[picture]")
{
    picture_options options = plain(300, 300);
    options.shading = GENERATE(shading::flat, shading::gouraud, shading::phong);
    const image one(square(1, 0.0F, "front"), options), many(square(23, 0.0F, "front"), options);
    CHECK((one.rgb == many.rgb));
    CHECK(many.white(2, 2));
    bool uniform = true;
    for (int y = 20; y < 280; ++y)
        for (int x = 20; x < 280; ++x) uniform = uniform && many.same(x, y, many.at(150, 150));
    CHECK(uniform);
}

TEST_CASE("what is nearer hides what is behind, in whatever order they are drawn", "[picture]")
{
    model lesser = square(2, 0.0F, "front");
    for (model_vertex& v : lesser.vertices) {
        v.position[0] *= 0.5F;
        v.position[1] *= 0.5F;
    }
    const model greater = square(2, -1.0F, "side");
    picture_options options = plain(200, 200);
    options.yaw = 0.0F;
    options.pitch = 0.0F;
    const image one(together(lesser, greater), options), other(together(greater, lesser), options);
    CHECK((one.rgb == other.rgb));
    CHECK_FALSE(one.same(100, 100, one.at(25, 25)));
    for (model_vertex& v : lesser.vertices) v.position[2] = -2.0F;
    const image hidden(together(lesser, greater), options);
    CHECK(hidden.same(100, 100, hidden.at(25, 25)));
}

TEST_CASE("a solid is drawn inside the margin, with its hole, and the same twice", "[picture]")
{
    picture_options options = plain(400, 300);
    options.yaw = GENERATE(-170.0F, -60.0F, 0.0F, 25.0F, 90.0F);
    options.pitch = GENERATE(-30.0F, 0.0F, 12.0F);
    const model ring = extruded_ring(32);
    const image picture(ring, options);
    REQUIRE(picture.w == 400);
    REQUIRE(picture.h == 300);
    int left = 400, right = -1, top = 300, bottom = -1;
    for (int y = 0; y < 300; ++y) {
        for (int x = 0; x < 400; ++x) {
            if (picture.white(x, y)) continue;
            left = (std::min)(left, x);
            right = (std::max)(right, x);
            top = (std::min)(top, y);
            bottom = (std::max)(bottom, y);
        }
    }
    const int margin = 24;  // 6 % of the longer side
    CHECK(left >= margin - 1);
    CHECK(right <= 400 - margin);
    CHECK(top >= margin - 1);
    CHECK(bottom <= 300 - margin);
    CHECK((std::abs(left + right - 399) <= 2 && std::abs(top + bottom - 299) <= 2));
    CHECK((right - left >= 400 - 2 * margin - 3 || bottom - top >= 300 - 2 * margin - 3));
    if (options.yaw == 0.0F && options.pitch == 0.0F) CHECK(picture.white((left + right) / 2, (top + bottom) / 2));
    CHECK((image(ring, options).rgb == picture.rgb));
}

TEST_CASE("a closed solid shows nothing of its inside", "[picture]")
{
    // Normals that point out are lit from outside: turning all triangles inside out must change the picture, leaving out the hidden
    // half of them must not.
    picture_options options = plain(300, 300);
    options.yaw = 0.0F;
    options.pitch = 0.0F;
    model ring = extruded_ring(32);
    const image whole(ring, options);
    std::vector<std::uint32_t> kept(ring.indices.begin(),
                                    ring.indices.begin() + static_cast<std::ptrdiff_t>(ring.parts[0].index_count));
    kept.insert(kept.end(), ring.indices.begin() + static_cast<std::ptrdiff_t>(ring.parts[2].first_index),
                ring.indices.end());
    model open = ring;
    open.parts[2].first_index = open.parts[0].index_count;
    open.parts = {open.parts[0], open.parts[2]};
    open.indices = kept;
    std::size_t changed = 0;
    const image without_back(open, options);
    for (std::size_t i = 0; i < whole.rgb.size(); ++i) changed += whole.rgb[i] != without_back.rgb[i];
    CHECK(changed == 0);
}

TEST_CASE("the picture's height follows the text, within limits", "[picture]")
{
    picture_options options;
    model wide = square(1, 0.0F, "front"), tall = wide;
    for (model_vertex& v : wide.vertices) v.position[0] *= 60.0F;
    for (model_vertex& v : tall.vertices) v.position[1] *= 60.0F;
    const image strip(wide, options), column(tall, options), even(square(1, 0.0F, "front"), options);
    CHECK((strip.w == 1280 && strip.h == 360));
    CHECK((column.w == 480 && column.h == 960));
    CHECK((even.w >= 900 && even.w <= 1280 && even.h == 960));
    CHECK(strip.rgb.size() == 1280u * 360u * 3u);
}

TEST_CASE("an empty model gives an empty background", "[picture]")
{
    const image nothing(model{}, plain(64, 48));
    CHECK((nothing.rgb == std::vector<unsigned char>(64 * 48 * 3, 255)));
    const image studio(model{}, picture_options{});
    CHECK(studio.w == 1280);
    CHECK((studio.h >= 360 && studio.h <= 960));
}

TEST_CASE("places that are no numbers and triangles without area are left out", "[picture]")
{
    model broken = extruded_ring(8);
    const model sound = broken;
    const auto first = static_cast<std::uint32_t>(broken.vertices.size());
    broken.vertices.push_back({{std::numeric_limits<float>::quiet_NaN(), 0, 0}, {0, 0, 1}, {0, 0}});
    broken.vertices.push_back({{std::numeric_limits<float>::infinity(), 0, 0}, {0, 0, 1}, {0, 0}});
    broken.vertices.push_back({{0.9F, 0, 0}, {0, 0, 0}, {0, 0}});
    for (const std::uint32_t i : {first, first + 2, 0u, first + 1, 1u, 2u, first + 2, first + 2, first + 2})
        broken.indices.push_back(i);
    broken.parts[2].index_count += 9;
    picture_options options = plain(200, 160);
    options.wireframe = true;
    CHECK((image(broken, options).rgb == image(sound, options).rgb));
    options.background = background::studio;
    CHECK(image(broken, options).rgb.size() == 200u * 160u * 3u);
}

TEST_CASE("a dot before the solid is seen, and one behind it is not", "[picture]")
{
    picture_options options = plain(200, 200);
    const model wall = square(3, 0.0F, "front");
    overlay over;
    over.dots.push_back({{0, 0, -0.2F}, {0, 0, 255}, 4.0F});
    const image hidden(wall, options, over);
    over.dots[0].p[2] = 0.0F;
    const image seen(wall, options, over);
    CHECK(hidden.at(100, 100)[2] < 200);
    CHECK((seen.at(100, 100)[0] == 0 && seen.at(100, 100)[2] == 255));
    CHECK(seen.same(120, 120, hidden.at(120, 120)));
}

TEST_CASE("the wireframe draws each edge once, however many vertices are doubled there", "[picture]")
{
    picture_options options = plain(200, 200);
    options.wireframe = true;
    model wall = square(3, 0.0F, "front");
    const image shared(wall, options);
    model split = wall;
    split.vertices.clear();
    for (std::uint32_t i = 0; i < wall.indices.size(); ++i) {
        split.vertices.push_back(wall.vertices[wall.indices[i]]);
        split.indices[i] = i;
    }
    // Not equal to the last bit: the edges come in another order.
    const image doubled(split, options);
    int most = 0;
    for (std::size_t i = 0; i < shared.rgb.size(); ++i)
        most = (std::max)(most, std::abs(int{shared.rgb[i]} - int{doubled.rgb[i]}));
    CHECK(most <= 1);
    options.wireframe = false;
    CHECK((image(wall, options).rgb != shared.rgb));
}

TEST_CASE("no triangle is drawn larger than the largest pixels per unit, and the box around a model foretells them",
          "[picture]")
{
    const model ring = extruded_ring();
    picture_options look;
    look.width = look.height = GENERATE(320, 1280);
    const double most = pixels_per_unit(ring, look);
    const double lens = 0.14, longer = look.width;
    CHECK(most > 0.5 * (1.0 - 2.0 * double{look.margin}) * longer / 2.0);
    CHECK(most < longer / 2.0 / lens);
    model box;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const auto pick = [&](unsigned bit, float low, float high) { return (corner & bit) != 0 ? high : low; };
        box.vertices.push_back({{pick(1, -1.0F, 1.0F), pick(2, -1.0F, 1.0F), pick(4, -0.5F, 0.0F)}, {}, {}});
        box.indices.push_back(corner);
    }
    CHECK(pixels_per_unit(box, look) > 0.7 * most);
    CHECK(pixels_per_unit(box, look) < 1.1 * most);
    look.height = look.width *= 2;
    CHECK(pixels_per_unit(ring, look) > 1.9 * most);
    CHECK(pixels_per_unit({}, look) == 0.0);
}
