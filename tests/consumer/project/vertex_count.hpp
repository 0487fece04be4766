// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

std::uint64_t vertex_count_of_other_part(const char* text);

// 0 where the font is missing; it is the linking that counts.
static std::uint64_t vertex_count(const char* text)
{
    auto font = typemesh::harfbuzz_font::open("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf");
    if (!font) return 0;
    typemesh::text_mesher mesher{*font};
    const auto plan = mesher.plan(text);
    return plan ? plan->size().vertices : 0;
}
