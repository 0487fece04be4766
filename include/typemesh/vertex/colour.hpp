// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/vertex/normalised.hpp>
#include <typemesh/vertex/part.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A colour of four bytes, red first in memory (R8G8B8A8, GL_RGBA). It is made from numbers between 0 and 1.
struct rgba8 {
    unorm8 r;
    unorm8 g;
    unorm8 b;
    unorm8 a = 1.0f;

    friend constexpr bool operator==(const rgba8&, const rgba8&) noexcept = default;
};

/// A colour of four bytes, blue first in memory (B8G8R8A8, D3DCOLOR, FColor).
struct bgra8 {
    unorm8 b;
    unorm8 g;
    unorm8 r;
    unorm8 a;

    bgra8() = default;
    constexpr bgra8(rgba8 c) noexcept : b{c.b}, g{c.g}, r{c.r}, a{c.a} {}
    friend constexpr bool operator==(const bgra8&, const bgra8&) noexcept = default;
};

/// One colour (or any other T) per part, for a writer that wants attribute::part: call it with s.part. For a single
/// colour, use a plain member of the writer. Bevels have the colour of the side unless they get a colour of their own.
template <class T = rgba8>
struct part_colours {
    T front;
    T back;
    T side;
    T front_bevel = side;
    T back_bevel = side;

    [[nodiscard]] constexpr T operator()(part p) const noexcept
    {
        if (p == part::front) return front;
        if (p == part::back) return back;
        if (p == part::front_bevel) return front_bevel;
        return p == part::back_bevel ? back_bevel : side;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
