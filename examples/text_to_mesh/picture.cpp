// SPDX-License-Identifier: MIT
#include "picture.hpp"

#include "camera.hpp"
#include "raster.hpp"
#include "studio.hpp"
#include "view.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>
#include <unordered_map>

namespace text_to_mesh {
namespace {

constexpr int tile_side = 64;
constexpr std::uint32_t nothing = 0xFFFFFFFFu;

/// A triangle on the picture.
struct flat_triangle {
    raster_point at[3];
    double inverse[3];      ///< 1 / distance at the corners
    double plane[3];        ///< 1 / distance = plane[0] + plane[1] x + plane[2] y, x and y in steps from at[0]
    double lowest, highest; ///< of `inverse`, against rounding where the triangle is seen edge on
    std::uint32_t first;    ///< place of its first index
    std::uint32_t part;
    bool turned_away;
};

/// A line or, where both ends are one, a dot.
struct flat_line {
    double x[2], y[2], inverse[2];
    double radius;
    double opacity;
    vec3 colour;
};

struct tile {
    std::vector<std::uint32_t> triangles, lines;
};

/// Draws one model once.
class painter {
public:
    painter(const model& mesh, const overlay& over, const picture_options& options)
        : mesh_(mesh), over_(over), options_(options), view_(view_of(mesh, over, options))
    {
        columns_ = (width_ + tile_side - 1) / tile_side;
        rows_ = (height_ + tile_side - 1) / tile_side;
        tiles_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
        const bool flat = is_flat(mesh);
        if (options.background == background::studio && !flat) shadow_ = floor_shadow(mesh);
        prepare_triangles();
        if (options.wireframe) prepare_wireframe();
        prepare_overlay();
    }

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

    [[nodiscard]] std::vector<unsigned char> paint()
    {
        std::vector<unsigned char> rgb(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 3);
        depth_.resize(tile_side * tile_side * samples_per_pixel);
        owner_.resize(depth_.size());
        colour_.resize(tile_side * tile_side);
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column) paint_tile(column, row, rgb);
        return rgb;
    }

private:
    // ---- sorting into tiles ----

    template <class Add>
    void each_tile(double left, double top, double right, double bottom, Add&& add)
    {
        const int first_column = (std::max)(0, static_cast<int>(left) / tile_side),
                  last_column = (std::min)(columns_ - 1, static_cast<int>(right) / tile_side);
        const int first_row = (std::max)(0, static_cast<int>(top) / tile_side),
                  last_row = (std::min)(rows_ - 1, static_cast<int>(bottom) / tile_side);
        for (int row = first_row; row <= last_row; ++row)
            for (int column = first_column; column <= last_column; ++column)
                add(tiles_[static_cast<std::size_t>(row * columns_ + column)]);
    }

    /// False for what no picture can hold: infinite or absurd places.
    [[nodiscard]] static bool drawable(const camera::projected& p)
    {
        return p.x > -16000.0 && p.x < 16000.0 && p.y > -16000.0 && p.y < 16000.0 && p.inverse > 0.0 &&
               p.inverse < 1e30;
    }

    void prepare_triangles()
    {
        std::vector<model::part> parts = mesh_.parts;
        if (parts.empty()) parts.push_back({"", 0, mesh_.indices.size()});
        triangles_.reserve(mesh_.indices.size() / 3);
        for (std::size_t part = 0; part < parts.size(); ++part) {
            colours_.push_back(to_linear(colour_of(parts[part].name)));
            for (std::size_t i = 0; i + 2 < parts[part].index_count; i += 3)
                prepare_triangle(static_cast<std::uint32_t>(parts[part].first_index + i),
                                 static_cast<std::uint32_t>(part));
        }
    }

    void prepare_triangle(std::uint32_t first, std::uint32_t part)
    {
        flat_triangle t{};
        t.first = first;
        t.part = part;
        double x[3], y[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const camera::projected p = camera_.project(to_vec3(mesh_.vertices[mesh_.indices[first + i]].position));
            if (!drawable(p)) return;
            t.at[i] = {static_cast<std::int32_t>(std::lround(p.x * pixel_steps)),
                       static_cast<std::int32_t>(std::lround(p.y * pixel_steps))};
            t.inverse[i] = p.inverse;
            x[i] = t.at[i].x;
            y[i] = t.at[i].y;
        }
        const double area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
        if (area == 0.0) return;
        t.turned_away = area > 0.0;  // y runs down here
        // What is turned away sits a hair farther back, so that it never shines through at the outline.
        const double shift = t.turned_away ? 1.0 - 1e-5 : 1.0;
        const double a = t.inverse[1] - t.inverse[0], b = t.inverse[2] - t.inverse[0];
        t.plane[0] = t.inverse[0] * shift;
        t.plane[1] = (a * (y[2] - y[0]) - b * (y[1] - y[0])) / area * shift;
        t.plane[2] = (b * (x[1] - x[0]) - a * (x[2] - x[0])) / area * shift;
        t.lowest = (std::min)({t.inverse[0], t.inverse[1], t.inverse[2]}) * shift;
        t.highest = (std::max)({t.inverse[0], t.inverse[1], t.inverse[2]}) * shift;
        const auto number = static_cast<std::uint32_t>(triangles_.size());
        triangles_.push_back(t);
        const auto [left, right] = std::minmax({x[0], x[1], x[2]});
        const auto [top, bottom] = std::minmax({y[0], y[1], y[2]});
        each_tile(left / pixel_steps, top / pixel_steps, right / pixel_steps, bottom / pixel_steps,
                  [&](tile& in) { in.triangles.push_back(number); });
    }

    /// Each edge once, however many triangles and doubled vertices share it.
    void prepare_wireframe()
    {
        std::unordered_map<std::string, std::uint32_t> seen;
        std::vector<std::uint32_t> welded(mesh_.vertices.size());
        seen.reserve(mesh_.vertices.size());
        for (std::size_t i = 0; i < welded.size(); ++i) {
            std::string key(sizeof(float) * 3, '\0');
            std::memcpy(key.data(), mesh_.vertices[i].position, key.size());
            welded[i] = seen.emplace(std::move(key), static_cast<std::uint32_t>(i)).first->second;
        }
        std::vector<std::uint64_t> edges;
        edges.reserve(mesh_.indices.size());
        for (std::size_t t = 0; t + 2 < mesh_.indices.size(); t += 3) {
            bool drawn = true;
            for (std::size_t i = 0; i < 3; ++i)
                drawn = drawn && drawable(camera_.project(to_vec3(mesh_.vertices[mesh_.indices[t + i]].position)));
            for (std::size_t i = 0; drawn && i < 3; ++i) {
                const std::uint64_t a = welded[mesh_.indices[t + i]], b = welded[mesh_.indices[t + (i + 1) % 3]];
                if (a != b) edges.push_back((std::min)(a, b) << 32 | (std::max)(a, b));
            }
        }
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        static const unsigned char ink[3] = {28, 30, 38};
        for (const std::uint64_t edge : edges)
            prepare_line(mesh_.vertices[edge >> 32].position, mesh_.vertices[edge & 0xFFFFFFFFu].position, ink,
                         double{options_.line_px} / 2.0, 0.6);
    }

    void prepare_overlay()
    {
        for (const overlay::segment& s : over_.segments)
            prepare_line(s.a, s.b, s.rgb, double{options_.line_px} * 0.75, 1.0);
        static const unsigned char white[3] = {255, 255, 255};
        for (const overlay::dot& d : over_.dots) {
            prepare_line(d.p, d.p, white, double{d.radius_px} + 1.0, 0.85);
            prepare_line(d.p, d.p, d.rgb, double{d.radius_px}, 1.0);
        }
    }

    void prepare_line(const float (&a)[3], const float (&b)[3], const unsigned char (&rgb)[3], double radius,
                      double opacity)
    {
        const camera::projected p = camera_.project(to_vec3(a)), q = camera_.project(to_vec3(b));
        if (!drawable(p) || !drawable(q)) return;
        const auto number = static_cast<std::uint32_t>(lines_.size());
        lines_.push_back({{p.x, q.x}, {p.y, q.y}, {p.inverse, q.inverse}, radius, opacity, to_linear(rgb)});
        const double reach = radius + 1.0;
        each_tile((std::min)(p.x, q.x) - reach, (std::min)(p.y, q.y) - reach, (std::max)(p.x, q.x) + reach,
                  (std::max)(p.y, q.y) + reach, [&](tile& in) { in.lines.push_back(number); });
    }

    // ---- one tile ----

    void paint_tile(int column, int row, std::vector<unsigned char>& rgb)
    {
        const tile& in = tiles_[static_cast<std::size_t>(row * columns_ + column)];
        const raster_window window{column * tile_side, row * tile_side, (std::min)((column + 1) * tile_side, width_),
                                   (std::min)((row + 1) * tile_side, height_)};
        const auto place = [&](int x, int y) {
            return static_cast<std::size_t>((y - window.top) * tile_side + (x - window.left));
        };
        if (!in.triangles.empty() || !in.lines.empty()) {
            std::fill(depth_.begin(), depth_.end(), 0.0F);
            std::fill(owner_.begin(), owner_.end(), nothing);
        }
        for (const std::uint32_t number : in.triangles) {
            const flat_triangle& t = triangles_[number];
            each_covered_pixel(t.at[0], t.at[1], t.at[2], window, [&](int x, int y, unsigned mask) {
                cover(t, number, x, y, mask, place(x, y) * samples_per_pixel);
            });
        }
        for (int y = window.top; y < window.bottom; ++y)
            for (int x = window.left; x < window.right; ++x)
                colour_[place(x, y)] =
                    in.triangles.empty() ? backdrop(x, y) : resolve(x, y, place(x, y) * samples_per_pixel);
        for (const std::uint32_t number : in.lines) paint_line(lines_[number], window);
        for (int y = window.top; y < window.bottom; ++y) {
            unsigned char* out = rgb.data() + (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                               static_cast<std::size_t>(window.left)) *
                                                  3;
            for (int x = window.left; x < window.right; ++x) {
                const vec3 c = colour_[place(x, y)];
                *out++ = to_srgb(c.x);
                *out++ = to_srgb(c.y);
                *out++ = to_srgb(c.z);
            }
        }
    }

    void cover(const flat_triangle& t, std::uint32_t number, int x, int y, unsigned mask, std::size_t first_sample)
    {
        const double corner =
            t.plane[0] + t.plane[1] * (x * pixel_steps - t.at[0].x) + t.plane[2] * (y * pixel_steps - t.at[0].y);
        for (; mask != 0; mask &= mask - 1) {
            const auto s = static_cast<std::size_t>(std::countr_zero(mask));
            const double inverse = (std::min)(
                t.highest, (std::max)(t.lowest, corner + t.plane[1] * sample_x[s] + t.plane[2] * sample_y[s]));
            if (static_cast<float>(inverse) <= depth_[first_sample + s]) continue;
            depth_[first_sample + s] = static_cast<float>(inverse);
            owner_[first_sample + s] = number;
        }
    }

    /// The mean of a pixel's samples. Each triangle in it is shaded once, in the middle of its samples.
    [[nodiscard]] vec3 resolve(int x, int y, std::size_t first_sample) const
    {
        vec3 sum;
        unsigned left = 0xFFFFu;
        while (left != 0) {
            const std::uint32_t owner = owner_[first_sample + static_cast<std::size_t>(std::countr_zero(left))];
            unsigned mine = 0;
            std::int32_t sx = 0, sy = 0;
            for (unsigned s = 0; s < samples_per_pixel; ++s) {
                if (owner_[first_sample + s] != owner) continue;
                mine |= 1u << s;
                sx += sample_x[s];
                sy += sample_y[s];
            }
            left &= ~mine;
            const int count = std::popcount(mine);
            const vec3 colour = owner == nothing
                                    ? backdrop(x, y)
                                    : shade(triangles_[owner], double(x) * pixel_steps + double(sx) / count,
                                            double(y) * pixel_steps + double(sy) / count, x, y, mine);
            sum = sum + (double(count) / samples_per_pixel) * colour;
        }
        return sum;
    }

    [[nodiscard]] vec3 backdrop(int x, int y) const
    {
        if (options_.background == background::white) return {1, 1, 1};
        const vec3 plain = studio_backdrop((y + 0.5) / height_);
        const double lit = shadow_.light_along(camera_.eye, camera_.ray(x + 0.5, y + 0.5));
        return plain * mix(vec3{0.03, 0.04, 0.07}, {1, 1, 1}, lit);  // shadows in daylight are a little blue
    }

    // ---- shading ----

    struct weights {
        double of[3];
    };

    /// The share of each corner at a place in the picture, right in perspective.
    [[nodiscard]] static weights weigh(const flat_triangle& t, double x, double y)
    {
        const auto twice = [](double ax, double ay, double bx, double by) { return ax * by - ay * bx; };
        double dx[3], dy[3];
        for (int i = 0; i < 3; ++i) {
            dx[i] = t.at[i].x - x;
            dy[i] = t.at[i].y - y;
        }
        const double a = twice(dx[1], dy[1], dx[2], dy[2]) * t.inverse[0];
        const double b = twice(dx[2], dy[2], dx[0], dy[0]) * t.inverse[1];
        const double c = twice(dx[0], dy[0], dx[1], dy[1]) * t.inverse[2];
        const double sum = a + b + c;
        return {{a / sum, b / sum, c / sum}};
    }

    [[nodiscard]] const model_vertex& corner(const flat_triangle& t, std::size_t i) const
    {
        return mesh_.vertices[mesh_.indices[t.first + i]];
    }

    [[nodiscard]] light light_on(vec3 normal) const { return studio_light(normal, camera_.in_camera_axes(normal)); }

    [[nodiscard]] vec3 shade(const flat_triangle& t, double x, double y, int px, int py, unsigned mask) const
    {
        const weights w = weigh(t, x, y);
        const double sign = t.turned_away ? -1.0 : 1.0;
        light lit;
        if (options_.shading == shading::flat) {
            const vec3 a = to_vec3(corner(t, 0).position);
            const vec3 n = cross(to_vec3(corner(t, 1).position) - a, to_vec3(corner(t, 2).position) - a);
            lit = light_on(sign * normalised(n));
        } else if (options_.shading == shading::gouraud) {
            for (std::size_t i = 0; i < 3; ++i) {
                const light at = light_on(sign * normalised(to_vec3(corner(t, i).normal)));
                lit.diffuse = lit.diffuse + w.of[i] * at.diffuse;
                lit.gloss = lit.gloss + w.of[i] * at.gloss;
            }
        } else {
            vec3 n;
            for (std::size_t i = 0; i < 3; ++i) n = n + w.of[i] * to_vec3(corner(t, i).normal);
            lit = light_on(sign * normalised(n));
        }
        vec3 base = colours_[t.part];
        if (options_.texture == texture::checker)
            base = mix(mix(base, {0.85, 0.85, 0.85}, 0.85), 0.55 * base, checker(t, px, py, mask));
        return base * lit.diffuse + lit.gloss;
    }

    /// How much of these samples lies in dark squares.
    [[nodiscard]] double checker(const flat_triangle& t, int px, int py, unsigned mask) const
    {
        int dark = 0;
        const int count = std::popcount(mask);
        for (; mask != 0; mask &= mask - 1) {
            const int s = std::countr_zero(mask);
            const weights w = weigh(t, double(px) * pixel_steps + sample_x[s], double(py) * pixel_steps + sample_y[s]);
            double u = 0.0, v = 0.0;
            for (std::size_t i = 0; i < 3; ++i) {
                u += w.of[i] * double{corner(t, i).uv[0]};
                v += w.of[i] * double{corner(t, i).uv[1]};
            }
            const double squares = std::floor(u * double{options_.checks}) + std::floor(v * double{options_.checks});
            dark += squares - 2.0 * std::floor(squares / 2.0) > 0.5 ? 1 : 0;
        }
        return double(dark) / count;
    }

    // ---- lines and dots over it ----

    void paint_line(const flat_line& line, raster_window window)
    {
        const double reach = line.radius + 1.0;
        const auto within = [](double v, int low, int high) {
            return v < low ? low : (v > high ? high : static_cast<int>(v));
        };
        const int left = within(std::floor((std::min)(line.x[0], line.x[1]) - reach), window.left, window.right);
        const int right = within(std::ceil((std::max)(line.x[0], line.x[1]) + reach), window.left, window.right);
        const int top = within(std::floor((std::min)(line.y[0], line.y[1]) - reach), window.top, window.bottom);
        const int bottom = within(std::ceil((std::max)(line.y[0], line.y[1]) + reach), window.top, window.bottom);
        const double dx = line.x[1] - line.x[0], dy = line.y[1] - line.y[0];
        const double length2 = dx * dx + dy * dy;
        const double closer = 1.0 + (line.radius + 2.0) / camera_.pixels;  // lifts the line off the surface it lies on
        for (int y = top; y < bottom; ++y) {
            for (int x = left; x < right; ++x) {
                const double ox = x + 0.5 - line.x[0], oy = y + 0.5 - line.y[0];
                const double along = length2 > 0.0 ? clamp01((ox * dx + oy * dy) / length2) : 0.0;
                const double ex = ox - along * dx, ey = oy - along * dy;
                const double covered = clamp01(line.radius + 0.5 - std::sqrt(ex * ex + ey * ey));
                if (covered <= 0.0) continue;
                const double inverse = (line.inverse[0] + along * (line.inverse[1] - line.inverse[0])) * closer;
                const std::size_t pixel = static_cast<std::size_t>((y - window.top) * tile_side + (x - window.left));
                int seen = 0;
                for (std::size_t s = 0; s < samples_per_pixel; ++s)
                    seen += double{depth_[pixel * samples_per_pixel + s]} <= inverse ? 1 : 0;
                colour_[pixel] = mix(colour_[pixel], line.colour, covered * line.opacity * seen / samples_per_pixel);
            }
        }
    }

    const model& mesh_;
    const overlay& over_;
    const picture_options& options_;
    const view view_;
    const camera& camera_ = view_.from;
    const int width_ = view_.width, height_ = view_.height;
    floor_shadow shadow_;
    int columns_ = 0, rows_ = 0;
    std::vector<flat_triangle> triangles_;
    std::vector<flat_line> lines_;
    std::vector<vec3> colours_;  ///< of the parts
    std::vector<tile> tiles_;
    std::vector<float> depth_;          ///< of one tile's samples: 1 / distance, 0 where there is nothing
    std::vector<std::uint32_t> owner_;  ///< the triangle that a sample shows
    std::vector<vec3> colour_;          ///< of one tile's pixels
};

}  // namespace

double pixels_per_unit(const model& mesh, const picture_options& options)
{
    const camera from = view_of(mesh, {}, options).from;
    double most = 0.0;
    each_point(mesh, {}, [&](vec3 p) { most = (std::max)(most, from.pixels * from.project(p).inverse); });
    return most;
}

std::vector<unsigned char> draw(const model& mesh, const overlay& over, const picture_options& options, int& w, int& h)
{
    painter one(mesh, over, options);
    w = one.width();
    h = one.height();
    return one.paint();
}

}  // namespace text_to_mesh
