// SPDX-License-Identifier: MIT
#include "letters.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace text_to_mesh {
namespace {

using namespace typemesh;

/// As files have it: a bar has no letter and no word.
float number_of(std::uint32_t number) { return number == not_a_letter ? -1.0f : static_cast<float>(number); }

/// What of the text a letter shows, in one line.
std::string shown(std::string_view text, const text_letter& l)
{
    std::string own{text.substr(l.text.first, l.text.last - l.text.first)};
    for (char& c : own)
        if (c == '\n') c = ' ';
    return own;
}

/// The mesh of letters that is being made from the mesh of a text.
class parting {
public:
    parting(const chosen_plan& plan, const model& whole, const add_part_function& add_part)
        : plan_{plan}, whole_{whole}, add_part_{add_part}, new_number_(whole.vertices.size())
    {
    }

    /// Adds the mesh of a row, which is made of these glyphs, ascending.
    void add(const text_letter& row, std::string name, const std::vector<std::size_t>& glyphs, model& out)
    {
        model::letter made{std::move(name), out.vertices.size(), 0, out.parts.size(), 0};
        for (const std::size_t g : glyphs) add_vertices(g, row.pivot, out);
        for (const part p : plan_.parts()) {
            for (const style_id style : plan_.styles()) {
                const auto first = static_cast<std::uint32_t>(out.indices.size());
                for (const std::size_t g : glyphs) add_indices(g, p, plan_.glyphs_of(style), out);
                const auto count = static_cast<std::uint32_t>(out.indices.size()) - first;
                add_part_(out, p, {0, 0, first, count}, style);
            }
        }
        made.vertex_count = out.vertices.size() - made.first_vertex;
        made.part_count = out.parts.size() - made.first_part;
        out.letters.push_back(std::move(made));
    }

private:
    void add_vertices(std::size_t glyph, vec3 pivot, model& out)
    {
        for (const part p : plan_.parts()) {
            const mesh_range r = plan_.range(glyph, p);
            for (std::size_t i = r.first_vertex; i < r.first_vertex + r.vertex_count; ++i) {
                new_number_[i] = static_cast<std::uint32_t>(out.vertices.size());
                model_vertex v = whole_.vertices[i];
                v.position[0] -= pivot.x;
                v.position[1] -= pivot.y;
                v.position[2] -= pivot.z;
                out.vertices.push_back(v);
                if (whole_.vertex_letters.empty()) continue;
                out.vertex_letters.push_back(whole_.vertex_letters[i]);
                for (float& from_origin : out.vertex_letters.back().pivot) from_origin = 0.0f;
            }
        }
    }
    void add_indices(std::size_t glyph, part p, const glyph_span& of_style, model& out)
    {
        if (glyph < of_style.first || glyph >= of_style.last) return;
        const mesh_range r = plan_.range(glyph, p);
        for (std::size_t i = r.first_index; i < r.first_index + r.index_count; ++i)
            out.indices.push_back(new_number_[whole_.indices[i]]);
    }

    const chosen_plan& plan_;
    const model& whole_;
    const add_part_function& add_part_;
    std::vector<std::uint32_t> new_number_;
};

}  // namespace

void name_vertices(const chosen_plan& plan, std::string_view text, model& mesh)
{
    mesh.vertex_letters.resize(mesh.vertices.size());
    for (std::size_t g = 0; g < plan.glyphs().size(); ++g) {
        const text_letter& row = plan.row_of(g);
        const model::vertex_letter own{number_of(plan.letter_of(g)),
                                       number_of(row.word),
                                       static_cast<float>(row.line),
                                       {row.pivot.x, row.pivot.y, row.pivot.z}};
        for (const part p : plan.parts()) {
            const mesh_range r = plan.range(g, p);
            for (std::size_t i = r.first_vertex; i < r.first_vertex + r.vertex_count; ++i) mesh.vertex_letters[i] = own;
        }
    }
    for (const text_letter& l : plan.letters().letters) mesh.letter_texts.push_back(shown(text, l));
}

void part_letters(const chosen_plan& plan, std::string_view text, model& mesh, const add_part_function& add_part)
{
    const letter_rows rows = plan.letters();
    const std::size_t letters = rows.letters.size();
    std::vector<std::vector<std::size_t>> glyphs(letters + rows.bars.size());
    for (std::size_t g = 0; g < plan.glyphs().size(); ++g) {
        const std::uint32_t letter = plan.letter_of(g);
        const auto bar = static_cast<std::size_t>(&plan.row_of(g) - rows.bars.data());
        glyphs[letter == not_a_letter ? letters + bar : letter].push_back(g);
    }
    model made;
    made.name = mesh.name;
    parting one{plan, mesh, add_part};
    for (std::size_t k = 0; k < glyphs.size(); ++k) {
        const bool is_bar = k >= letters;
        const text_letter& row = is_bar ? rows.bars[k - letters] : rows.letters[k];
        one.add(row, is_bar ? "bar" : shown(text, row), glyphs[k], made);
        made.places.push_back({k, {row.pivot.x, row.pivot.y, row.pivot.z}, is_bar ? "" : shown(text, row)});
        if (!is_bar) made.places.back().numbers = {{static_cast<std::uint32_t>(k), row.word, row.line}};
    }
    mesh = std::move(made);
}

}  // namespace text_to_mesh
