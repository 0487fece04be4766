// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/colour/colour_glyph.hpp>
#include <typemesh/colour/impl/paint_transform.hpp>
#include <typemesh/core/affine.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/glyph_id.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Adds shapes to a colour glyph. Equal shapes are kept once; the whole plane and nothing are numbers of their own.
class shape_builder {
public:
    static constexpr std::uint32_t everything = 0xFFFF'FFFFu;
    static constexpr std::uint32_t nothing = 0xFFFF'FFFEu;

    shape_builder(colour_glyph& out, std::uint32_t most) noexcept : out_{out}, most_{most} {}

    /// Whether there were too many shapes, or no memory for them.
    [[nodiscard]] bool is_full() const noexcept { return full_; }
    [[nodiscard]] bool is_out_of_memory() const noexcept { return no_memory_; }

    [[nodiscard]] std::uint32_t outline(glyph_id id, const affine& map) noexcept
    {
        return add({layer_shape::kind::outline, id, map, 0, 0});
    }
    /// A clip box, in the space that `map` maps to the glyph's. One without area is nothing.
    [[nodiscard]] std::uint32_t rectangle(const box& clip, const affine& map = {}) noexcept
    {
        if (clip.empty()) return nothing;
        return add({layer_shape::kind::rectangle, 0, after(map, onto(clip)), 0, 0});
    }

    [[nodiscard]] std::uint32_t both(std::uint32_t a, std::uint32_t b) noexcept
    {
        if (a == nothing || b == nothing) return nothing;
        if (a == everything || a == b) return b;
        if (b == everything) return a;
        return add({layer_shape::kind::both, 0, {}, a, b});
    }
    [[nodiscard]] std::uint32_t either(std::uint32_t a, std::uint32_t b) noexcept
    {
        if (a == everything || b == everything) return everything;
        if (a == nothing || a == b) return b;
        if (b == nothing) return a;
        return add({layer_shape::kind::either, 0, {}, a, b});
    }
    /// What `a` leaves of the whole plane is cut from the clip box.
    [[nodiscard]] std::uint32_t without(std::uint32_t a, std::uint32_t b) noexcept
    {
        if (a == nothing || b == everything || a == b) return nothing;
        if (b == nothing) return a;
        if (a == everything) {
            if (out_.clip.empty()) {
                ++out_.unbounded;
                return nothing;
            }
            a = rectangle(out_.clip);
        }
        return add({layer_shape::kind::without, 0, {}, a, b});
    }

private:
    [[nodiscard]] std::uint32_t add(const layer_shape& shape) noexcept
    {
        constexpr std::size_t looked_at = 32;  // equal shapes usually follow each other closely
        const std::size_t count = out_.shapes.size();
        for (std::size_t i = count; i-- > 0 && i + looked_at >= count;)
            if (out_.shapes[i] == shape) return static_cast<std::uint32_t>(i);
        if (count >= most_)
            full_ = true;
        else if (!out_.shapes.push_back(shape))
            no_memory_ = true;
        return full_ || no_memory_ ? nothing : static_cast<std::uint32_t>(count);
    }

    colour_glyph& out_;
    std::uint32_t most_;
    bool full_ = false, no_memory_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
