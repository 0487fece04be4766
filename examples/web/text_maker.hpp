// SPDX-License-Identifier: MIT
#pragma once

#include "fonts.hpp"
#include "mesh_arrays.hpp"
#include "settings.hpp"

#include <typemesh/glyph/glyph_cache.hpp>
#include <typemesh/typemesh.hpp>

#include <chrono>
#include <memory>
#include <string_view>

namespace typemesh_web {

/// What is to be meshed: a text, or the page that it was laid out as.
struct text_job {
    std::u16string_view text;
    const typemesh::glyph_run* page = nullptr;
    bool instances = false;  ///< each different letter once, and where they stand
    std::chrono::steady_clock::time_point begun = {};
};

/// A text_mesher whose policies are some of those that the options choose from.
class text_maker {
public:
    text_maker() = default;
    text_maker(const text_maker&) = delete;
    text_maker& operator=(const text_maker&) = delete;
    virtual ~text_maker() = default;

    /// Takes the options; gives whether these policies are those that they choose, and else changes nothing.
    [[nodiscard]] virtual bool take(const text_to_mesh::options& o) = 0;

    /// Fills `out`. Nothing of the plan outlives the call, so the cache may be cleared behind it.
    [[nodiscard]] virtual typemesh::error make(const text_job& job, mesh_arrays& out) = 0;
};

/// The maker for these options, which has taken them. Fonts and cache must outlive it.
[[nodiscard]] std::unique_ptr<text_maker> maker_for(const text_to_mesh::options& o, font_set& fonts,
                                                    typemesh::glyph_cache<>& cache);

}  // namespace typemesh_web
