// SPDX-License-Identifier: MIT

// Must compile: the umbrella alone has every packed format that README names.

#include <typemesh/typemesh.hpp>

#include <type_traits>

using namespace typemesh;

struct packed {
    box_position position;
    half uv[2];
    snorm8 normal[4];
    snorm16 fine[4];
    unorm8 weight[4];
    unorm16 place[2];
    snorm10 tangent;
    unorm10 shade;
    octahedral16 short_direction;
    octahedral32 direction;
    rgba8 colour;
};
static_assert(std::is_trivially_copyable_v<packed>);
static_assert(sizeof(position_box) > 0);
