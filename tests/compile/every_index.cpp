// SPDX-License-Identifier: MIT

// Must compile: integers of every width and sign number vertices, wherever indices are written.

#include "../support/toy_font.hpp"

#include <typemesh/compat/d3dx_text.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <span>
#include <vector>

using namespace typemesh;

namespace {

template <class Index>
error everywhere(text_mesher<>& mesher, d3dx_text<>& maker)
{
    std::vector<d3dx_vertex> vertices;
    std::vector<Index> indices;
    const auto plan = mesher.plan("o");
    if (!plan) return plan.error();
    text_chunks chunks;
    if (const auto done = chunks.cut(*plan); !done) return done.error();
    if (const auto done = chunks.write(*plan, into(vertices, indices)); !done) return done.error();
    if (const auto done = plan->write(into(vertices, indices)); !done) return done.error();
    if (const auto done = plan->write(into(std::span{vertices}, std::span{indices})); !done) return done.error();
    if (const auto done = plan->write(stream_sink{std::span{indices}}); !done) return done.error();
    const auto made = maker.plan("o");
    if (!made) return made.error();
    return made->write(std::span{vertices}, std::span{indices}).error();
}

}  // namespace

error every_index(text_mesher<>& mesher, d3dx_text<>& maker)
{
    if (error e = everywhere<std::uint8_t>(mesher, maker)) return e;
    if (error e = everywhere<std::uint16_t>(mesher, maker)) return e;
    if (error e = everywhere<std::uint32_t>(mesher, maker)) return e;
    if (error e = everywhere<std::uint64_t>(mesher, maker)) return e;
    if (error e = everywhere<std::int8_t>(mesher, maker)) return e;
    if (error e = everywhere<std::int16_t>(mesher, maker)) return e;
    if (error e = everywhere<int>(mesher, maker)) return e;
    return everywhere<long long>(mesher, maker);
}
