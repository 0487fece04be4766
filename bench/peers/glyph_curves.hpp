// SPDX-License-Identifier: MIT
#pragma once

#include <hb-ot.h>
#include <hb.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace peers {

struct place {
    double x = 0, y = 0;
};
inline place operator+(place a, place b) { return {a.x + b.x, a.y + b.y}; }
inline place operator-(place a, place b) { return {a.x - b.x, a.y - b.y}; }
inline place operator*(double s, place a) { return {s * a.x, s * a.y}; }
inline double dot(place a, place b) { return a.x * b.x + a.y * b.y; }
inline double length(place a) { return std::hypot(a.x, a.y); }

/// The outline of a character, the em 1 long, in pieces so short that they count as the true curve: 256 a curve, whose chords
/// are off by less than 4e-6 em. Read by HarfBuzz, of the font's default instance.
class glyph_curves {
public:
    struct piece {
        place from, to;
        bool curved;
    };
    std::vector<piece> pieces;

    [[nodiscard]] place low() const { return low_; }
    [[nodiscard]] place high() const { return high_; }

    void add(piece p)
    {
        pieces.push_back(p);
        for (const place q : {p.from, p.to}) {
            low_ = {std::min(low_.x, q.x), std::min(low_.y, q.y)};
            high_ = {std::max(high_.x, q.x), std::max(high_.y, q.y)};
        }
    }

    /// What the non-zero rule fills, measured along many lines.
    [[nodiscard]] double area() const
    {
        constexpr int lines = 3000;
        const double step = (high_.y - low_.y) / lines;
        std::vector<std::vector<std::pair<double, int>>> crossings(lines);
        for (const piece& p : pieces) {
            const bool up = p.to.y > p.from.y;
            const place a = up ? p.from : p.to, b = up ? p.to : p.from;
            for (int i = std::max(0, int(std::ceil((a.y - low_.y) / step - 0.5))); i < lines; ++i) {
                const double y = low_.y + (i + 0.5) * step;
                if (y < a.y) continue;
                if (y >= b.y) break;
                crossings[std::size_t(i)].push_back({a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y), up ? 1 : -1});
            }
        }
        double sum = 0;
        for (auto& line : crossings) {
            std::sort(line.begin(), line.end());
            int winding = 0;
            for (std::size_t i = 0; i + 1 < line.size(); ++i)
                if ((winding += line[i].second) != 0) sum += (line[i + 1].first - line[i].first) * step;
        }
        return sum;
    }

    [[nodiscard]] double outline_length() const
    {
        double sum = 0;
        for (const piece& p : pieces) sum += length(p.to - p.from);
        return sum;
    }

    struct nearest {
        double distance = 1e30;
        bool curved = false;
    };

    /// The distance to the outline; call make_cells() first.
    [[nodiscard]] nearest to(place p) const
    {
        nearest best;
        const int x = cell(p.x), y = cell(p.y);
        for (int reach = 1; reach < 4096 && best.distance > reach / 2 * cell_size; reach *= 2)
            for (int i = -reach; i <= reach; ++i)
                for (int j = -reach; j <= reach; ++j) {
                    if (reach > 1 && std::max(std::abs(i), std::abs(j)) <= reach / 2) continue;
                    const auto found = cells_.find(key(x + i, y + j));
                    if (found == cells_.end()) continue;
                    for (const std::uint32_t k : found->second) improve(best, pieces[k], p);
                }
        return best;
    }

    void make_cells()
    {
        for (std::uint32_t i = 0; i < pieces.size(); ++i) {
            const piece& p = pieces[i];
            const int steps = 1 + int(length(p.to - p.from) / cell_size * 2);
            std::uint64_t last = ~std::uint64_t{0};
            for (int s = 0; s <= steps; ++s) {
                const place q = p.from + double(s) / steps * (p.to - p.from);
                const std::uint64_t k = key(cell(q.x), cell(q.y));
                if (k != last) cells_[k].push_back(i);
                last = k;
            }
        }
    }

private:
    static constexpr double cell_size = 1.0 / 128;

    static int cell(double x) { return int(std::floor(x / cell_size)); }
    static std::uint64_t key(int x, int y) { return std::uint64_t(std::uint32_t(x)) << 32 | std::uint32_t(y); }
    static void improve(nearest& best, const piece& e, place p)
    {
        const place along = e.to - e.from;
        const double all = dot(along, along), t = all > 0 ? std::clamp(dot(p - e.from, along) / all, 0.0, 1.0) : 0.0;
        const double d = length(p - (e.from + t * along));
        if (d < best.distance) best = {d, e.curved};
    }

    place low_{1e30, 1e30}, high_{-1e30, -1e30};
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

/// A font whose outlines are read by HarfBuzz.
class outline_font {
public:
    explicit outline_font(const std::string& file)
    {
        hb_blob_t* blob = hb_blob_create_from_file(file.c_str());
        face_.reset(hb_face_create(blob, 0));
        hb_blob_destroy(blob);
        font_.reset(hb_font_create(face_.get()));
        hb_draw_funcs_set_move_to_func(draw_.get(), move, nullptr, nullptr);
        hb_draw_funcs_set_line_to_func(draw_.get(), line, nullptr, nullptr);
        hb_draw_funcs_set_quadratic_to_func(draw_.get(), quadratic, nullptr, nullptr);
        hb_draw_funcs_set_cubic_to_func(draw_.get(), cubic, nullptr, nullptr);
    }

    /// Without pieces where the font lacks the character, or it is blank.
    [[nodiscard]] glyph_curves curves_of(std::uint32_t character) const
    {
        hb_codepoint_t glyph = 0;
        reader r{{}, 1.0 / hb_face_get_upem(face_.get())};
        if (hb_font_get_nominal_glyph(font_.get(), character, &glyph) != 0)
            hb_font_get_glyph_shape(font_.get(), glyph, draw_.get(), &r);
        return r.curves;
    }

private:
    struct reader {
        glyph_curves curves;
        double scale;

        [[nodiscard]] place at(float x, float y) const { return {scale * double(x), scale * double(y)}; }
        void curve(std::array<place, 4> c)
        {
            place last = c[0];
            for (int i = 1; i <= 256; ++i) {
                const double t = i / 256.0, u = 1 - t;
                const place next = u * u * u * c[0] + 3 * u * u * t * c[1] + 3 * u * t * t * c[2] + t * t * t * c[3];
                curves.add({last, next, true});
                last = next;
            }
        }
    };
    static place pen(const hb_draw_state_t* s, const reader& r) { return r.at(s->current_x, s->current_y); }
    static void move(hb_draw_funcs_t*, void*, hb_draw_state_t*, float, float, void*) {}
    static void line(hb_draw_funcs_t*, void* to, hb_draw_state_t* s, float x, float y, void*)
    {
        auto& r = *static_cast<reader*>(to);
        r.curves.add({pen(s, r), r.at(x, y), false});
    }
    static void quadratic(hb_draw_funcs_t*, void* to, hb_draw_state_t* s, float x1, float y1, float x, float y, void*)
    {
        auto& r = *static_cast<reader*>(to);
        const place a = pen(s, r), b = r.at(x1, y1), c = r.at(x, y);
        r.curve({a, a + 2.0 / 3 * (b - a), c + 2.0 / 3 * (b - c), c});
    }
    static void cubic(hb_draw_funcs_t*, void* to, hb_draw_state_t* s, float x1, float y1, float x2, float y2, float x,
                      float y, void*)
    {
        auto& r = *static_cast<reader*>(to);
        r.curve({pen(s, r), r.at(x1, y1), r.at(x2, y2), r.at(x, y)});
    }

    std::unique_ptr<hb_face_t, void (*)(hb_face_t*)> face_{nullptr, hb_face_destroy};
    std::unique_ptr<hb_font_t, void (*)(hb_font_t*)> font_{nullptr, hb_font_destroy};
    std::unique_ptr<hb_draw_funcs_t, void (*)(hb_draw_funcs_t*)> draw_{hb_draw_funcs_create(), hb_draw_funcs_destroy};
};

}  // namespace peers
