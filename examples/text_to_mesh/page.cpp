// SPDX-License-Identifier: MIT
#include "page.hpp"

#include "report.hpp"

#include <typemesh/paragraph/fit_size.hpp>
#include <typemesh/paragraph/paragraph.hpp>

#include <cstdio>

namespace text_to_mesh {

std::string lay_out_page(const options& o, font_set& font, typemesh::glyph_run& page, double& size)
{
    if (!o.page) return {};
    typemesh::paragraph words{font};
    const typemesh::shape_options how{.direction = o.direction,
                                      .language = o.language,
                                      .script = o.script,
                                      .features = o.features,
                                      .columns = o.columns};
    typemesh::paragraph_options lines = o.lines;
    lines.ellipsis = o.ellipsis;
    typemesh::error e = words.set(o.text, how, spans_of(o.styles, o.text), o.letter_spacing);
    if (!e && o.fit_width > 0.0) {
        const bool columns = o.direction == typemesh::direction::top_to_bottom;
        const double along = columns ? o.fit_height : o.fit_width;
        const auto found = typemesh::fit_size(words, along, columns ? o.fit_width : o.fit_height, lines);
        if (found.error() == typemesh::error::bad_option) return "--fit: the text demands more lines than --max-lines.";
        if (!found) return in_words(found.error());
        size = *found;
        lines.width = along / size;
    }
    if (!e) e = words.lay_out(lines, page);
    if (e) return in_words(e);
    if (const std::uint32_t moved = words.shaped().styles.moved(); moved != 0) {
        std::fprintf(stderr, "text_to_mesh: --style: %u %s inside a character; the whole character is styled.\n", moved,
                     moved == 1 ? "end stands" : "ends stand");
        if (o.strict) return "--strict: nothing is written.";
    }
    return {};
}

}  // namespace text_to_mesh
