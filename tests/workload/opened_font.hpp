// SPDX-License-Identifier: MIT
#pragma once

// The fonts of the workload, opened.

#include "support/catch.hpp"
#include "support/workload.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace test {

inline typemesh::harfbuzz_font opened(const std::string& path, const typemesh::font_options& how = {})
{
    INFO(path);
    auto font = typemesh::harfbuzz_font::open(path.c_str(), how);
    REQUIRE(font);
    return std::move(*font);
}

/// The indices of all parts of a glyph, or of a group of merged ones.
template <class Mesh>
std::vector<std::uint32_t> indices_of(const auto& plan, std::size_t glyph, const Mesh& m)
{
    std::vector<std::uint32_t> own;
    for (const typemesh::part p : plan.parts()) {
        const typemesh::mesh_range r = plan.range(glyph, p);
        own.insert(own.end(), m.indices.begin() + r.first_index, m.indices.begin() + r.first_index + r.index_count);
    }
    return own;
}

/// Calls use(font, path, script) for each script of each font that is installed.
template <class Use>
void for_each_script(const Use& use)
{
    for (const workload_font& file : workload_fonts()) {
        if (!file.available()) continue;
        typemesh::harfbuzz_font font = opened(file.path);
        for (const std::string script : {"latin", "arabic", "chinese", "japanese"})
            if (file.serves(script)) use(font, file.path, script);
    }
}

}  // namespace test
