// SPDX-License-Identifier: MIT
//
// Built with clang's memory sanitizer: writes a text into memory that nobody has initialised. The sanitizer ends the
// program if anything depends on what lay there; afterwards all of it must be initialised.

#include "support/mesh_laws.hpp"
#include "support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

#include <sanitizer/msan_interface.h>

#include <cstdio>
#include <cstdlib>

using namespace typemesh;

namespace {

template <class Mesher>
bool writes_all(const char* name, Mesher mesher)
{
    auto plan = mesher.plan("oEi xo\nEEo", {.merge = true});
    if (!plan) return false;
    const mesh_size size = plan->size();
    const std::size_t vertex_bytes = size.vertices * sizeof(test::full_vertex), index_bytes = size.indices() * 4;
    auto* vertices = static_cast<test::full_vertex*>(std::malloc(vertex_bytes));
    auto* indices = static_cast<std::uint32_t*>(std::malloc(index_bytes));
    const bool written = vertices != nullptr && indices != nullptr &&
                         plan->write(into(std::span{vertices, static_cast<std::size_t>(size.vertices)},
                                          std::span{indices, static_cast<std::size_t>(size.indices())}))
                             .has_value();
    const bool all =
        written && __msan_test_shadow(vertices, vertex_bytes) == -1 && __msan_test_shadow(indices, index_bytes) == -1;
    std::printf("%s: %s\n", name, all ? "all is written" : "something is not written");
    std::free(vertices);
    std::free(indices);
    return all;
}

}  // namespace

int main()
{
    test::toy_font font;
    const bool good[] = {
        writes_all("monotone", text_mesher{font}),
        writes_all("constrained_delaunay", text_mesher{font}.with(constrained_delaunay{})),
        writes_all("flat", text_mesher{font}.with(flat{})),
        writes_all("shared_normals", text_mesher{font}.with(extruded<shared_normals>{})),
        writes_all("averaged_normals", text_mesher{font}.with(extruded<averaged_normals>{})),
        writes_all("creased_normals", text_mesher{font}.with(extruded<creased_normals>{})),
    };
    for (const bool b : good)
        if (!b) return 1;
    return 0;
}
