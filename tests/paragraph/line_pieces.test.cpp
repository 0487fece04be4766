// SPDX-License-Identifier: MIT
#include "support/shaped_paragraph.hpp"

#include <typemesh/paragraph/impl/line_pieces.hpp>

using namespace typemesh;
using test::shaped_paragraph;

TEST_CASE("a line's slices are its clusters, with what its ends change", "[paragraph]")
{
    shaped_paragraph p{"xAV AVx"};
    const auto& list = p.wrapped(wrap_mode::grapheme, 0.0);
    for (std::size_t first = 0; first < list.pieces.size(); ++first)
        for (std::size_t last = first + 1; last <= list.pieces.size(); ++last) {
            line_slices line;
            REQUIRE_FALSE(append_pieces(line, p.pieces, {list, first, last}, p.shaped, p.font));
            const auto width = line.finish(p.shaped, 0, 0.0, {});
            REQUIRE(width);
            double expected = list.pieces[first].begin_change + list.pieces[last - 1].end_change;
            for (std::size_t k = first; k < last; ++k)
                expected += list.pieces[k].width + (k + 1 < last ? list.pieces[k].space : 0.0);
            CHECK(*width == expected);
            cluster_id at = list.pieces[first].first;
            for (const line_slice& s : line.slices())
                for (std::uint32_t c = s.first; c < s.last; ++c) {
                    CHECK(p.shaped.cluster(c).first == at);
                    at = p.shaped.cluster(c).last;
                }
            CHECK(at == list.pieces[last - 1].last);
        }
}
