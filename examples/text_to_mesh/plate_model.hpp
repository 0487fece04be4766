// SPDX-License-Identifier: MIT
#pragma once

#include "model.hpp"
#include "options.hpp"
#include "policies.hpp"
#include "text_fonts.hpp"

#include <typemesh/plate/name_plate.hpp>

#include <string>

namespace text_to_mesh {

/// The plate of a text, as a model. An inlay has two solids, "plate" and "inlay".
class plate_model {
public:
    plate_model(const options& o, font_set& font);

    /// Plans the plate of a planned text, and writes its mesh. `page` and `how` are the text's. The model is empty after
    /// an error.
    [[nodiscard]] typemesh::result<void> make(const chosen_plan& text, const typemesh::glyph_run& page,
                                              const typemesh::text_options& how, model& out);

    /// Warns the user about the plate. True where there is something to say.
    [[nodiscard]] bool name_faults();
    /// "; 4 bridges hold 2 islands", or nothing.
    [[nodiscard]] std::string bridges_in_words() const;

private:
    [[nodiscard]] std::uint32_t pieces_of(typemesh::cell_set cells);
    [[nodiscard]] typemesh::result<void> add_solid(std::size_t k, model& out) const;

    const options& o_;
    chosen_mesher bolder_;  // of a backing's outline
    typemesh::name_plate plate_;
};

/// Why a plate cannot be made.
[[nodiscard]] std::string plate_refusal_in_words(const options& o, const typemesh::error& e);

/// Makes each solid of a model a mesh of its own in a file of nodes.
void part_solids(model& mesh);

}  // namespace text_to_mesh
