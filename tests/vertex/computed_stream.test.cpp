// SPDX-License-Identifier: MIT

#include <typemesh/vertex/computed_stream.hpp>

#include <typemesh/vertex/colour.hpp>
#include <typemesh/vertex/position_box.hpp>

#include <array>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "support/guarded_bytes.hpp"

using namespace typemesh;

TEST_CASE("a computed stream contains its function's values, and wants only the function's attributes", "[vertex]")
{
    std::array<box_position, 3> places{};
    std::vector<rgba8> colours(3), tints(4);
    std::vector<std::uint32_t> indices;
    const auto box = position_box::around({0, 0, 0}, {2, 2, 0});
    const part_colours<> by_part{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    stream_sink sink{
        std::span{indices},
        computed_stream<attribute::position>(
            std::span{places}, [box](const surface_point<attribute::position>& s) noexcept { return box(s.position); }),
        computed_stream<attribute::part>(
            std::span{colours},
            [by_part](const surface_point<attribute::part>& s) noexcept { return by_part(s.part); }),
        constant_stream(std::span{tints}, rgba8{0.5f, 0.5f, 0.5f})};
    static_assert(mesh_sink<decltype(sink)>);
    static_assert(sink.wants == (attribute::position | attribute::part));
    CHECK(sink.begin({4, 0}) == error::buffer_too_small);
    REQUIRE_FALSE(sink.begin({3, 0}));
    for (const part p : {part::front, part::back, part::side}) {
        surface_point<sink.wants> s;
        s.position = {static_cast<float>(p), 2.0f, 0.0f};
        s.part = p;
        sink.vertex(s);
    }
    sink.end();
    CHECK(places[0] == box_position{0.0f, 1.0f, 0.0f});
    CHECK(places[2] == box_position{1.0f, 1.0f, 0.0f});
    CHECK(colours[1] == rgba8{0, 1, 0});
    CHECK(tints[2] == rgba8{0.5f, 0.5f, 0.5f});
    CHECK(tints[3] == rgba8{});
}

TEST_CASE("a computed stream in bytes does not write between its elements", "[vertex]")
{
    const test::guarded_bytes memory{8 + 12 * 2 + 4};
    std::vector<std::uint32_t> indices;
    stream_sink sink{
        std::span{indices},
        computed_stream<attribute::cluster, std::uint32_t>(
            memory.bytes(), 8, 12, [](const surface_point<attribute::cluster>& s) noexcept { return s.cluster + 1; })};
    CHECK(sink.begin({4, 0}) == error::buffer_too_small);
    REQUIRE_FALSE(sink.begin({3, 0}));
    for (cluster_id c = 0; c < 3; ++c) {
        surface_point<attribute::cluster> s;
        s.cluster = c;
        sink.vertex(s);
    }
    sink.end();
    const auto words = memory.as<std::uint32_t>();
    CHECK(std::vector<std::uint32_t>(words.begin(), words.end()) ==
          std::vector<std::uint32_t>{0xEEEEEEEE, 0xEEEEEEEE, 1, 0xEEEEEEEE, 0xEEEEEEEE, 2, 0xEEEEEEEE, 0xEEEEEEEE, 3});
}
