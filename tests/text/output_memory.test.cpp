// SPDX-License-Identifier: MIT
//
// What writing does to the caller's memory, seen from the memory.

#include "support/catch.hpp"
#include "support/guarded_memory.hpp"
#include "support/mesh_laws.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/typemesh.hpp>

#include <cstring>
#include <vector>

using namespace typemesh;

namespace {

const char* const three_words = "oEi xo\nEEo";

/// Writes a plan into two arrays that begin, or end, where memory does.
template <class Index, class Plan>
void write_between_guards(const Plan& plan, bool at_end)
{
    const mesh_size size = plan.size();
    const test::guarded_memory<test::full_vertex> vertices{size.vertices, at_end};
    const test::guarded_memory<Index> indices{size.indices(), at_end};
    REQUIRE(plan.write(into(vertices.elements(), indices.elements())));
    std::uint64_t highest = 0;
    for (const Index i : indices.elements()) highest = i > highest ? i : highest;
    CHECK(highest + 1 == size.vertices);
}

}  // namespace

TEMPLATE_TEST_CASE("writing stays within its arrays: the pages before and after them are never touched",
                   "[text][memory]", extruded<>, bevelled)
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(TestType{});
    auto plan = test::required(mesher.plan(three_words));
    for (const bool at_end : {false, true}) {
        write_between_guards<std::uint32_t>(*plan, at_end);
        write_between_guards<std::uint16_t>(*plan, at_end);
    }
}

TEMPLATE_TEST_CASE("what is written does not depend on what lay there, and all of it is written", "[text][memory]",
                   extruded<>, bevelled)
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(TestType{});
    auto plan = test::required(mesher.plan(three_words));
    const mesh_size size = plan->size();
    std::vector<std::vector<unsigned char>> left;
    for (const int before : {0x00, 0xFF, 0x5A}) {
        std::vector<test::full_vertex> vertices(size.vertices);
        std::vector<std::uint32_t> indices(size.indices());
        std::memset(static_cast<void*>(vertices.data()), before, size.vertices * sizeof(test::full_vertex));
        std::memset(indices.data(), before, size.indices() * sizeof(std::uint32_t));
        REQUIRE(plan->write(into(std::span{vertices}, std::span{indices})));
        auto& bytes = left.emplace_back(size.vertices * sizeof(test::full_vertex) + size.indices() * 4);
        std::memcpy(bytes.data(), vertices.data(), size.vertices * sizeof(test::full_vertex));
        std::memcpy(bytes.data() + size.vertices * sizeof(test::full_vertex), indices.data(), size.indices() * 4);
    }
    CHECK(left[0] == left[1]);
    CHECK(left[0] == left[2]);
}

TEST_CASE("a sink that is too small is left as it was, to the byte", "[text][memory]")
{
    test::toy_font font;
    text_mesher mesher{font};
    auto plan = test::required(mesher.plan(three_words));
    const mesh_size size = plan->size();
    for (const bool few_vertices : {false, true}) {
        std::vector<test::full_vertex> vertices(size.vertices - few_vertices);
        std::vector<std::uint32_t> indices(size.indices() - !few_vertices);
        std::memset(static_cast<void*>(vertices.data()), 0x5A, vertices.size() * sizeof(test::full_vertex));
        std::memset(indices.data(), 0x5A, indices.size() * 4);
        CHECK(plan->write(into(std::span{vertices}, std::span{indices})) == error::buffer_too_small);
        const std::size_t vertex_bytes = vertices.size() * sizeof(test::full_vertex);
        const std::vector<unsigned char> before(vertex_bytes + indices.size() * 4, 0x5A);
        std::vector<unsigned char> now = before;
        std::memcpy(now.data(), vertices.data(), vertex_bytes);
        std::memcpy(now.data() + vertex_bytes, indices.data(), indices.size() * 4);
        CHECK(now == before);
    }
}
