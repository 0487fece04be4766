// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/mesh_laws.hpp"
#include "support/toy_font.hpp"

#include <typemesh/adapt/threads.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/typemesh.hpp>

#include <atomic>
#include <cstring>
#include <thread>
#include <vector>

using namespace typemesh;
using test::full_mesh;

namespace {

const char* const texts[] = {"oEix", "xxoo", "EiEiEi", "o", "x~o E", "ii\noo"};

}  // namespace

TEMPLATE_TEST_CASE("threads that share a very small cache build the same meshes as one thread", "[threads][cache]",
                   extruded<>, bevelled)
{
    const std::size_t bound = GENERATE(std::size_t{0}, std::size_t{4000}, std::size_t{1} << 20);
    std::vector<full_mesh> expected;
    {
        test::toy_font font;
        auto mesher = text_mesher{font}.with(TestType{});
        for (const char* text : texts) {
            full_mesh& m = expected.emplace_back();
            REQUIRE(mesher.build(text, into(m.vertices, m.indices)));
        }
    }
    glyph_cache<mutex_lock> cache{bound};
    std::atomic<int> wrong{0};
    std::vector<std::thread> threads;
    for (unsigned t = 0; t < 4; ++t) {
        threads.emplace_back([&, t] {
            test::toy_font font;
            auto mesher = text_mesher{font}.with(TestType{}).with(cached_in{cache, 1});
            for (unsigned i = 0; i < 200; ++i) {
                const unsigned which = (i * 7 + t) % 6;
                auto plan = mesher.plan(texts[which]);
                if (i % 5 == 0) cache.clear();
                full_mesh m;
                const bool same = plan && plan->write(into(m.vertices, m.indices)).has_value() &&
                                  m.indices == expected[which].indices &&
                                  std::memcmp(m.vertices.data(), expected[which].vertices.data(),
                                              m.vertices.size() * sizeof(test::full_vertex)) == 0;
                wrong += same ? 0 : 1;
            }
        });
    }
    for (std::thread& t : threads) t.join();
    CHECK(wrong == 0);
    CHECK(cache.statistics().pinned == 0);
    CHECK(cache.statistics().bytes <= bound);
}
