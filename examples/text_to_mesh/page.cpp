// SPDX-License-Identifier: MIT
#include "page.hpp"

#include "report.hpp"

#include <typemesh/paragraph/paragraph.hpp>

namespace text_to_mesh {

std::string lay_out_page(const options& o, font_set& font, typemesh::glyph_run& page)
{
    if (!o.page) return {};
    typemesh::paragraph words{font};
    const typemesh::shape_options how{
        .direction = o.direction, .language = o.language, .script = o.script, .features = o.features};
    typemesh::paragraph_options lines = o.lines;
    lines.ellipsis = o.ellipsis;
    typemesh::error e = words.set(o.text, how, o.letter_spacing);
    if (!e) e = words.lay_out(lines, page);
    return e ? in_words(e) : std::string{};
}

}  // namespace text_to_mesh
