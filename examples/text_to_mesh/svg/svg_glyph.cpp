// SPDX-License-Identifier: MIT
#include "svg_glyph.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace text_to_mesh {
namespace {

using namespace typemesh;

/// Makes the layers of a drawing.
class layer_writer {
public:
    layer_writer(const svg_drawing& from, colour_glyph& to) : from_{from}, to_{to}, clips_(from.clips.size(), none) {}

    /// Gives the colours of the layers.
    [[nodiscard]] bool write(std::vector<rgb_colour>& colours)
    {
        std::vector<std::uint32_t> together;  // the shapes of one layer
        for (std::size_t i = 0; i < from_.items.size(); ++i) {
            const svg_drawing::item& one = from_.items[i];
            const std::uint32_t shape = add({.id = static_cast<glyph_id>(one.shape)});
            together.push_back(one.within == svg_drawing::no_clip ? shape : both(shape, clip(one.within)));
            if (i + 1 < from_.items.size() && same_colour(from_.items[i + 1].colour, one.colour)) continue;
            fits_ = fits_ && to_.layers.push_back({any_of(together), {}});
            colours.push_back(one.colour);
            together.clear();
        }
        if (!from_.view.empty()) to_.clip = from_.view;
        return fits_;
    }

private:
    static constexpr std::uint32_t none = 0xFFFF'FFFFu;

    std::uint32_t add(const layer_shape& shape)
    {
        fits_ = fits_ && to_.shapes.push_back(shape);
        return static_cast<std::uint32_t>(to_.shapes.size() - 1);
    }
    std::uint32_t both(std::uint32_t a, std::uint32_t b)
    {
        return add({.is = layer_shape::kind::both, .a = a, .b = b});
    }
    /// What any of some shapes cover. They are joined in pairs, so that each point takes part in few of the joins.
    std::uint32_t any_of(std::vector<std::uint32_t> shapes)
    {
        for (; shapes.size() > 1; shapes.resize((shapes.size() + 1) / 2))
            for (std::size_t i = 0; i < shapes.size(); i += 2)
                shapes[i / 2] = i + 1 == shapes.size()
                                    ? shapes[i]
                                    : add({.is = layer_shape::kind::either, .a = shapes[i], .b = shapes[i + 1]});
        return shapes.front();
    }
    /// The shape of a clip; a clip without shapes is what a shape leaves of itself.
    std::uint32_t clip(std::size_t number)
    {
        if (clips_[number] != none) return clips_[number];
        const svg_drawing::clip& c = from_.clips[number];
        std::vector<std::uint32_t> shapes;
        for (const auto& [shape, within] : c.shapes) {
            const std::uint32_t whole = add({.id = static_cast<glyph_id>(shape)});
            shapes.push_back(within == svg_drawing::no_clip ? whole : both(whole, clip(within)));
        }
        std::uint32_t all = 0;
        if (shapes.empty())
            all = add({.is = layer_shape::kind::without, .a = 0, .b = 0});
        else
            all = any_of(std::move(shapes));
        if (c.inside != svg_drawing::no_clip) all = both(all, clip(c.inside));
        clips_[number] = all;
        return all;
    }

    const svg_drawing& from_;
    colour_glyph& to_;
    std::vector<std::uint32_t> clips_;
    bool fits_ = true;
};

}  // namespace

bool same_colour(const rgb_colour& a, const rgb_colour& b)
{
    return std::memcmp(a.rgb, b.rgb, sizeof a.rgb) == 0 && a.alpha == b.alpha;
}

bool write_layers(const svg_drawing& from, colour_glyph& to, std::vector<rgb_colour>& colours)
{
    return layer_writer{from, to}.write(colours);
}

}  // namespace text_to_mesh
