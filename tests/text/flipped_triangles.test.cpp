// SPDX-License-Identifier: MIT

#include <typemesh/text/flipped_triangles.hpp>
#include <typemesh/typemesh.hpp>

#include "support/catch.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"

#include <string>
#include <vector>

using namespace typemesh;

namespace {

/// Places and indices as they are written.
struct collected {
    static constexpr attribute wants = attribute::position;

    std::vector<vec3> places;
    std::vector<std::uint32_t> indices;

    error begin(mesh_size) noexcept { return {}; }
    void vertex(const surface_point<wants>& v) noexcept { places.push_back(v.position); }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
    {
        for (const std::uint32_t i : {a, b, c}) indices.push_back(i);
    }
    void end() noexcept {}
};

struct counts {
    std::uint64_t flipped = 0, all = 0;
    [[nodiscard]] double share() const { return static_cast<double>(flipped) / static_cast<double>(all); }
};

/// Front triangles of the mesh as written, in floats, that do not turn the way they should seen from the front.
template <class Plan, class To = collected>
counts counted(const Plan& plan, To to = {})
{
    REQUIRE(plan.write(to));
    counts found;
    for (std::size_t i = 0; i + 2 < to.indices.size(); i += 3, ++found.all) {
        const vec3 a = to.places[to.indices[i]], b = to.places[to.indices[i + 1]], c = to.places[to.indices[i + 2]];
        const double area = (double(b.x) - double(a.x)) * (double(c.y) - double(a.y)) -
                            (double(b.y) - double(a.y)) * (double(c.x) - double(a.x));
        found.flipped += area > 0.0 ? 0u : 1u;
    }
    return found;
}

}  // namespace

TEST_CASE("flipped triangles are counted as the written floats have them, near the origin and far from it",
          "[text][flipped_triangles]")
{
    test::toy_font font;
    text_mesher mesher = text_mesher{font}.with(flat{});
    std::uint64_t most = 0;
    for (const char* text : {"o", "Eo", "oooooooooooooooooooooooooooooooooooooooo"}) {
        for (const double away : {0.0, 1e3, 1e5, 1e6}) {
            text_options options{.tolerance = 1.0 / 16000};
            options.shape.letter_spacing = away;
            const auto plan = test::required(mesher.plan(text, options));
            INFO(text << " spaced by " << away);
            const std::uint64_t flipped = flipped_triangles(*plan);
            CHECK(flipped == counted(*plan).flipped);
            if (away == 0.0 && std::string{text} != "oooooooooooooooooooooooooooooooooooooooo") CHECK(flipped == 0);
            most = (std::max)(most, flipped);
        }
    }
    CHECK(most > 100);
}

TEST_CASE("no triangle is flipped because depths run the other way", "[text][flipped_triangles]")
{
    test::toy_font font;
    text_mesher mesher = text_mesher{font}.with(flat{});
    text_options options;
    options.frame.toward = {0.0f, 0.0f, -1.0f};
    CHECK(flipped_triangles(*test::required(mesher.plan("oE", options))) == 0);
}

namespace {

/// Caps as `half` positions hold them.
struct halved : collected {
    void vertex(const surface_point<wants>& v) noexcept
    {
        const auto rounded = [](float f) noexcept { return static_cast<float>(half{f}); };
        places.push_back({rounded(v.position.x), rounded(v.position.y), rounded(v.position.z)});
    }
};

/// As position_box holds them.
struct boxed : collected {
    position_box box = position_box::around({}, {1.0f, 1.0f, 1.0f});

    void vertex(const surface_point<wants>& v) noexcept { places.push_back(box.decoded(box(v.position))); }
};

}  // namespace

TEST_CASE("half positions turn no triangle over within an em of the origin, but half of them a long line away",
          "[text][flipped_triangles]")
{
    test::toy_font font;
    text_mesher mesher = text_mesher{font}.with(flat{});
    CHECK(counted(*test::required(mesher.plan("o")), halved{}).share() <= 0.0);
    const auto far = test::required(mesher.plan(std::string(400, 'o')));
    CHECK(counted(*far, halved{}).share() > 0.5);
    boxed packed;
    packed.box = position_box::around(far->bounds().low, far->bounds().high);
    CHECK(counted(*far, packed).share() < 0.5 * counted(*far, halved{}).share());
}
