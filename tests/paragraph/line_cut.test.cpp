// SPDX-License-Identifier: MIT
#include "support/shaped_paragraph.hpp"

#include <typemesh/paragraph/impl/line_cut.hpp>

using namespace typemesh;
using test::shaped_paragraph;

namespace {

struct cut_at {
    bool changes;
    line_cut cut;

    cut_at(shaped_paragraph& p, std::uint32_t cluster, std::uint32_t place, double share = 1.0)
    {
        const auto made = make_cut(p.shaped, p.font, cluster, place, share, cut);
        REQUIRE(made);
        changes = *made;
    }
};

}  // namespace

TEST_CASE("a safe place changes nothing and costs nothing", "[paragraph]")
{
    shaped_paragraph p{"ab cd"};
    const std::size_t calls = p.font.calls, clusters = p.shaped.all_clusters();
    CHECK_FALSE(cut_at(p, 2, 3).changes);
    CHECK(p.font.calls == calls);
    CHECK(p.shaped.all_clusters() == clusters);
}

TEST_CASE("a kerned pair that is parted is shaped again from the nearest safe place", "[paragraph]")
{
    shaped_paragraph p{"xAVx"};
    const cut_at made{p, 1, 2};
    REQUIRE(made.changes);
    CHECK(made.cut.before_from == 1);
    CHECK(made.cut.before_count == 1);
    CHECK(made.cut.behind_to == 3);
    CHECK(made.cut.behind_count == 1);
    CHECK(made.cut.end_change == 100.0);  // A has its whole width again
    CHECK(made.cut.begin_change == 0.0);
}

TEST_CASE("a ligature that is parted shows its letters", "[paragraph]")
{
    shaped_paragraph p{"xfiy"};
    const cut_at made{p, 1, 2, 0.5};
    REQUIRE(made.changes);
    CHECK(p.shaped.glyph(p.shaped.cluster(made.cut.before_first).glyph).id == 'f');
    CHECK(p.shaped.glyph(p.shaped.cluster(made.cut.behind_first).glyph).id == 'i');
    CHECK(made.cut.end_change == 500.0 - 350.0);
    CHECK(made.cut.begin_change == 500.0 - 350.0);
}

TEST_CASE("a soft hyphen shows at a line's end, in either encoding", "[paragraph]")
{
    for (const text_view text : {text_view{std::u16string_view{u"ab\u00ADcd"}}, text_view{"ab\xC2\xAD"
                                                                                          "cd"}}) {
        shaped_paragraph p{text};
        const std::uint32_t place = text.encoding() == encoding::utf8 ? 4 : 3;
        const cut_at made{p, 2, place};
        REQUIRE(made.changes);
        const text_cluster& last = p.shaped.cluster(made.cut.before_first + made.cut.before_count - 1);
        CHECK(p.shaped.glyph(last.glyph).id == 0x2010);
        CHECK(last.first == 2);
        CHECK_FALSE(has(last.flags, cluster_flags::hangs));
        CHECK(made.cut.end_change == 500.0);
        CHECK(made.cut.behind_count == 0);
        CHECK(made.cut.behind_to == 3);
    }
}
