// SPDX-License-Identifier: MIT
#pragma once

// Pieces for breakers of lines, without a text.

#include "support/catch.hpp"

#include <typemesh/paragraph/first_fit.hpp>

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace test {

using piece_list = std::vector<typemesh::break_piece>;
using ends_of = std::vector<std::uint32_t>;

template <class Breaker>
ends_of broken(const Breaker& how, const piece_list& pieces, const typemesh::line_room& room)
{
    typemesh::buffer<std::uint32_t> ends;
    REQUIRE_FALSE(how.break_lines(pieces, room, ends));
    return {ends.begin(), ends.end()};
}

inline piece_list words(std::initializer_list<double> widths)
{
    piece_list all;
    for (const double w : widths) all.push_back({.width = w, .space = 1.0, .stretch = 1.0});
    all.back().end = typemesh::piece_end::paragraph;
    return all;
}

struct measured_line {
    double width = 0.0, stretch = 0.0;
};

/// Pieces [first, last) as a line.
inline measured_line line_of(const piece_list& pieces, std::size_t first, std::size_t last,
                             const typemesh::line_room& room)
{
    const bool fresh = first == 0 || pieces[first - 1].end == typemesh::piece_end::paragraph;
    double pen = room.start(fresh) + pieces[first].begin_change, stretch = 0.0;
    measured_line line;
    for (std::size_t k = first; k < last; ++k) {
        const typemesh::break_piece& p = pieces[k];
        if (p.width > 0.0 || (k + 1 == last && p.is_visible()))
            line = {pen + p.width + (k + 1 == last ? p.end_change : 0.0), stretch};
        pen += p.width + p.space;
        stretch += p.stretch;
        if (p.tab) pen = room.after_tab(pen), stretch = 0.0;
    }
    return line;
}

}  // namespace test
