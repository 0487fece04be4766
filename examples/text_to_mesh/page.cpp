// SPDX-License-Identifier: MIT
#include "page.hpp"

#include "report.hpp"

#include <typemesh/paragraph/fit_size.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/paragraph/total_fit.hpp>

#include <algorithm>
#include <cstdio>

namespace text_to_mesh {
namespace {

typemesh::shape_options shape_options_of(const options& o)
{
    return {.direction = o.direction,
            .language = o.language,
            .script = o.script,
            .features = o.features,
            .columns = o.columns};
}

/// The largest size of an em at which the text, grown by o.growth on each side, fits into the box of --fit.
template <class Paragraph>
typemesh::result<double> size_in_box(const options& o, Paragraph& words, double along, double across,
                                     const typemesh::paragraph_options& lines)
{
    double low = 0.0, high = 0.0;
    const auto found = typemesh::fit_size(words, along, across, lines);
    if (!found || o.growth == 0.0) return found;
    // The larger letters are, the less of the box is left: what is found for a size too large is too small.
    for (high = *found; high > low * (1.0 + 1e-6);) {
        const double middle = low + (high - low) / 2, edge = 2.0 * o.growth * middle;
        if (edge >= std::min(along, across)) {
            high = middle;
            continue;
        }
        const auto inner = typemesh::fit_size(words, along - edge, across - edge, lines);
        if (!inner) return inner;
        if (*inner < middle) {
            high = middle;
            low = std::max(low, *inner);
        } else {
            low = middle;
            high = std::min(high, *inner);
        }
    }
    return low;
}

/// Tells what an ellipsis lacks. Gives whether it did.
bool name_ellipsis_losses(const options& o, font_set& font)
{
    typemesh::glyph_run run;
    if (typemesh::layout(font, o.ellipsis, shape_options_of(o), {}, run)) return false;  // the page fails likewise
    if (run.invalid_units > 0) std::fputs("text_to_mesh: --ellipsis: is not valid UTF-8.\n", stderr);
    if (run.missing > 0)
        std::fputs("text_to_mesh: --ellipsis: the font has no glyph for it; three full stops are drawn instead.\n",
                   stderr);
    return run.invalid_units > 0 || run.missing > 0;
}

template <class Breaker>
std::string lay_out_lines(const options& o, const Breaker& breaker, font_set& font, typemesh::glyph_run& page,
                          double& size)
{
    typemesh::paragraph words{font, typemesh::heap(), typemesh::unicode_analyser{}, breaker};
    typemesh::paragraph_options lines = o.lines;
    lines.ellipsis = o.ellipsis;
    typemesh::error e = words.set(o.text, shape_options_of(o), spans_of(o.styles, o.text), o.letter_spacing);
    if (!e && o.fit_width > 0.0) {
        const bool columns = o.direction == typemesh::direction::top_to_bottom;
        const double along = columns ? o.fit_height : o.fit_width;
        const auto found = size_in_box(o, words, along, columns ? o.fit_width : o.fit_height, lines);
        if (found.error() == typemesh::error::bad_option) return "--fit: the text demands more lines than --max-lines.";
        if (!found) return in_words(found.error());
        size = *found;
        lines.width = along / size - 2.0 * o.growth;
    }
    if (!e) e = words.lay_out(lines, page);
    if (e) return in_words(e);
    bool warned = !o.ellipsis.empty() && name_ellipsis_losses(o, font);
    if (const std::uint32_t moved = words.shaped().styles.moved(); moved != 0) {
        std::fprintf(stderr,
                     "text_to_mesh: --style: %u %s inside a character or a combined number; the whole of it is "
                     "styled.\n",
                     moved, moved == 1 ? "end stands" : "ends stand");
        warned = true;
    }
    return warned && o.strict ? "--strict: nothing is written." : std::string{};
}

}  // namespace

std::string lay_out_page(const options& o, font_set& font, typemesh::glyph_run& page, double& size)
{
    if (!o.page) return {};
    if (!o.even_lines) return lay_out_lines(o, typemesh::first_fit{}, font, page, size);
    const typemesh::total_fit even{.emergency_stretch = 0.5};  // lines of few words have few spaces to stretch
    return lay_out_lines(o, even, font, page, size);
}

}  // namespace text_to_mesh
