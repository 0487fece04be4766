// SPDX-License-Identifier: MIT
#pragma once

#include "fonts.hpp"
#include "marked_words.hpp"
#include "mesh_arrays.hpp"
#include "settings.hpp"
#include "text_to_mesh/solids.hpp"

#include <typemesh/extrude/tubed.hpp>
#include <typemesh/glyph/glyph_cache.hpp>
#include <typemesh/typemesh.hpp>

#include <chrono>
#include <string_view>

namespace typemesh_web {

// The solids of the page. text_to_mesh has more, which would make the module larger.
using web_upright = typemesh::one_of<text_to_mesh::plain_solid, typemesh::bevelled>;
using web_solid =
    typemesh::one_of<web_upright, typemesh::outlined<web_upright, text_to_mesh::plain_solid>, text_to_mesh::bent_solid,
                     text_to_mesh::bent_bevels, typemesh::inflated, typemesh::tubed>;
using web_plan = typemesh::text_plan<web_solid>;

/// What is to be meshed: a text, or the page that it was laid out as.
struct text_job {
    std::u16string_view text;
    const typemesh::glyph_run* page = nullptr;
    bool instances = false;                ///< each different letter once, and where they stand
    bool letters = false;                  ///< vertices know their letters
    const marked_words* marked = nullptr;  ///< tags ask for solids and colours of their own
    std::chrono::steady_clock::time_point begun = {};
};

/// The options for shaping. They refer to the strings in `o`.
[[nodiscard]] typemesh::shape_options shape_options_of(const text_to_mesh::options& o);

/// The mesher of a session. Fonts and cache must outlive it.
class text_maker {
public:
    text_maker(font_set& fonts, typemesh::glyph_cache<>& cache);

    /// Takes options for the texts that follow.
    void take(const text_to_mesh::options& o);

    /// Fills `out`. Nothing of the plan outlives the call, so the cache may be cleared behind it.
    [[nodiscard]] typemesh::result<void> make(const text_job& job, mesh_arrays& out);

private:
    [[nodiscard]] typemesh::result<void> make_solids(const text_job& job, mesh_arrays& out);
    [[nodiscard]] typemesh::result<void> add(const text_job& job, mesh_arrays& out);
    font_set* fonts_;
    text_to_mesh::options options_;  // the texts in them are read while a plan is made
    typemesh::text_mesher<web_solid> mesher_;
};

}  // namespace typemesh_web
