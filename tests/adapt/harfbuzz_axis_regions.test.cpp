// SPDX-License-Identifier: MIT
#include <typemesh/adapt/impl/harfbuzz_axis_regions.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "support/catch.hpp"

using namespace typemesh;

namespace {

/// A face whose tables are these bytes.
struct made_face {
    std::vector<std::pair<hb_tag_t, std::string>> tables;
    hb_face_t* face = hb_face_create_for_tables(
        [](hb_face_t*, hb_tag_t tag, void* user) -> hb_blob_t* {
            for (const auto& [name, bytes] : static_cast<made_face*>(user)->tables)
                if (name == tag)
                    return hb_blob_create(bytes.data(), static_cast<unsigned>(bytes.size()), HB_MEMORY_MODE_READONLY,
                                          nullptr, nullptr);
            return nullptr;
        },
        this, nullptr);

    made_face() = default;
    made_face(const made_face&) = delete;
    made_face& operator=(const made_face&) = delete;
    ~made_face() { hb_face_destroy(face); }

    [[nodiscard]] std::vector<std::int32_t> masters(std::uint32_t axis)
    {
        buffer<std::int32_t> out;
        CHECK_FALSE(detail::harfbuzz_axis_regions(face, axis, out).read_masters());
        return sorted(out);
    }
    [[nodiscard]] std::vector<std::int32_t> changes(std::uint32_t axis)
    {
        buffer<std::int32_t> out;
        CHECK_FALSE(detail::harfbuzz_axis_regions(face, axis, out).read_changes());
        return sorted(out);
    }
    static std::vector<std::int32_t> sorted(const buffer<std::int32_t>& out)
    {
        std::vector<std::int32_t> all(out.begin(), out.end());
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
    }
};

std::string words(const std::vector<int>& all)
{
    std::string bytes;
    for (const int w : all) {
        bytes += static_cast<char>(w >> 8 & 0xFF);
        bytes += static_cast<char>(w & 0xFF);
    }
    return bytes;
}

}  // namespace

TEST_CASE("regions of a variation store begin, peak and end where the table says", "[adapt][morph]")
{
    made_face f;
    // HVAR: version, the store at 20; the store: format 1, its list of regions at 8; two axes, two regions
    const std::vector<int> hvar = {1, 0, 0, 20,     0,      0,       0,       0, 0,      0,      1,      0, 8, 0,
                                   2, 2, 0, 0x2000, 0x4000, -0x4000, -0x4000, 0, 0x1000, 0x2000, 0x2000, 0, 0, 0};
    f.tables = {{HB_TAG('H', 'V', 'A', 'R'), words(hvar)}};
    CHECK(f.masters(0) == std::vector<std::int32_t>{0, 0x1000, 0x2000, 0x2001, 0x4000});
    CHECK(f.masters(1) == std::vector<std::int32_t>{-0x4000, 0});
    CHECK(f.masters(2).empty());
}

TEST_CASE("regions of gvar are shared, a glyph's own, or between two places", "[adapt][morph]")
{
    made_face f;
    // One axis, one shared peak at 36, one glyph with data at 40: three tuples
    std::vector<int> gvar = {1, 0, 1,      1, 0, 36, 1, 1,      0, 40,     0,       0, 0,      34,     0,      0,
                             0, 0, 0x3000, 0, 3, 22, 4, 0x0000, 4, 0x8000, -0x2000, 4, 0xC000, 0x1800, 0x1400, 0x2800};
    f.tables = {{HB_TAG('g', 'v', 'a', 'r'), words(gvar)}};
    CHECK(f.masters(0) == std::vector<std::int32_t>{-0x2001, -0x2000, 0, 0x1400, 0x1800, 0x2800, 0x3000, 0x3001});
}

TEST_CASE("conditions of an axis are changes before them and behind them", "[adapt][morph]")
{
    made_face f;
    // GSUB 1.1, variations at 14; one record, whose set at 16 has a condition at 6: axis 1 from 0.25 to 0.75
    f.tables = {{HB_TAG('G', 'S', 'U', 'B'),
                 words({1, 1, 0, 0, 0, 0, 14, 1, 0, 0, 1, 0, 16, 0, 0, 1, 0, 6, 1, 1, 0x1000, 0x3000})}};
    CHECK(f.changes(1) == std::vector<std::int32_t>{0x1000, 0x3001});
    CHECK(f.changes(0).empty());
}

TEST_CASE("damaged tables are read within their bounds", "[adapt][morph]")
{
    std::mt19937 random{11};
    for (int i = 0; i < 300; ++i) {
        made_face f;
        for (const hb_tag_t tag : {HB_TAG('g', 'v', 'a', 'r'), HB_TAG('C', 'F', 'F', '2'), HB_TAG('G', 'D', 'E', 'F'),
                                   HB_TAG('G', 'S', 'U', 'B'), HB_TAG('M', 'V', 'A', 'R')}) {
            std::string bytes(random() % 120, '\0');
            for (char& b : bytes) b = static_cast<char>(random() % 4 == 0 ? random() : random() % 8);
            f.tables.emplace_back(tag, bytes);
        }
        buffer<std::int32_t> out;
        const error e = detail::harfbuzz_axis_regions(f.face, 0, out).read_masters();
        CHECK((!e || e == error::not_a_font));
        for (const std::int32_t c : out) CHECK((c >= -0x4000 && c <= 0x4000));
        static_cast<void>(detail::harfbuzz_axis_regions(f.face, 0, out).read_changes());
    }
}

TEST_CASE("each coordinate is listed once, and not more than 1024 of them", "[adapt][morph]")
{
    // One axis; regions from 0 to different peaks, all of them three times.
    const auto store_of = [](int peaks) {
        std::vector<int> hvar = {1, 0, 0, 20, 0, 0, 0, 0, 0, 0, 1, 0, 8, 0, 1, 3 * peaks};
        for (int round = 0; round < 3; ++round)
            for (int i = 0; i < peaks; ++i) hvar.insert(hvar.end(), {0, 16 * (i + 1), 0x4000});
        return words(hvar);
    };
    buffer<std::int32_t> out;
    made_face f;
    f.tables = {{HB_TAG('H', 'V', 'A', 'R'), store_of(1000)}};
    REQUIRE_FALSE(detail::harfbuzz_axis_regions(f.face, 0, out).read_masters());
    CHECK(out.size() == 1002);
    made_face g;
    g.tables = {{HB_TAG('H', 'V', 'A', 'R'), store_of(1023)}};
    CHECK(detail::harfbuzz_axis_regions(g.face, 0, out).read_masters() == error::not_a_font);
}

TEST_CASE("glyphs and features that share their bytes do not cost more than the table is long", "[adapt][morph]")
{
    // Every other of 65,535 glyphs has the same 4095 tuples; 65,535 records have the same 65,535 conditions.
    std::vector<int> gvar = {1, 0, 1, 0, 0, 0, 0xFFFF, 1, 4, 20};  // the data is at 20 + 4 * 65,536
    for (int i = 0; i <= 0xFFFF; ++i) gvar.insert(gvar.end(), {0, i % 2 == 0 ? 0 : 4});
    gvar.push_back(0x0FFF);
    std::vector<int> gsub = {1, 1, 0, 0, 0, 0, 14, 1, 0, 0, 0xFFFF};
    for (int i = 0; i < 0xFFFF; ++i) gsub.insert(gsub.end(), {8, 0, 0, 0});  // the set is at 14 + 0x80000
    gsub.push_back(0xFFFF);
    made_face f;
    f.tables = {{HB_TAG('g', 'v', 'a', 'r'), words(gvar)}, {HB_TAG('G', 'S', 'U', 'B'), words(gsub)}};
    buffer<std::int32_t> out;
    CHECK(detail::harfbuzz_axis_regions(f.face, 0, out).read_masters() == error::not_a_font);
    CHECK(detail::harfbuzz_axis_regions(f.face, 0, out).read_changes() == error::not_a_font);
}
