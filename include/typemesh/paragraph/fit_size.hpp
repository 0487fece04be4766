// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/layout_options.hpp>
#include <typemesh/layout/line_room.hpp>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// Measures a paragraph at several sizes of an em.
template <class Paragraph>
struct size_trial {
    Paragraph& words;
    double width, height;  // the width and height of the box
    layout_options options;

    /// Whether the text fits into the box at this size.
    result<bool> fits(double size) noexcept
    {
        options.width = width / size;
        const auto measured = words.measure(options);
        if (!measured) return measured.error();
        return is_whole() && measured->width * size <= widened(width) && measured->height * size <= widened(height);
    }
    /// Whether the last layout dropped nothing.
    [[nodiscard]] bool is_whole() const noexcept
    {
        return words.lines().empty() || words.lines().back().last == words.shaped().text().size();
    }
};

}  // namespace detail

/// The largest size of an em at which a paragraph's text fits into a box, to a millionth. Lines end as the options say.
/// However, no word is broken for the sake of a larger size, except with wrap_mode::grapheme.
///
///     auto size = fit_size(words, 30.0, 10.0, options);            30 by 10, in the unit of the mesh
///     options.width = 30.0 / *size;
///     words.lay_out(options, run);                                 draw with text_options::size = *size
///
///     width     along the lines; in columns down
///     height    across the lines, from the first line's ascender to the last line's descender
///     options   width and ellipsis are ignored; the text has at most max_lines lines
///
/// Some breakers, such as total_fit, may make more lines if the width is greater. A larger size that fits may then be
/// missed.
///
/// Fails  error::bad_option: width or height are not positive and finite, the text needs more than max_lines lines,
///        or there is no text, as before set(). It also fails as paragraph::measure() does
/// Cost   some 30 calls of measure()
template <class Paragraph>
result<double> fit_size(Paragraph& words, double width, double height, const layout_options& options = {}) noexcept
{
    if (!(width > 0.0) || !is_finite(width)) return error::bad("width");
    if (!(height > 0.0) || !is_finite(height)) return error::bad("height");
    detail::size_trial<Paragraph> trial{words, width, height, options};
    trial.options.ellipsis = {};
    trial.options.width = layout_options{}.width;
    if (options.wrap == wrap_mode::word_or_grapheme) trial.options.wrap = wrap_mode::word;

    // Measure with as few lines as the text's line breaks allow. The text certainly fits at the size `low`, and at no
    // size above `high`.
    const auto natural = words.measure(trial.options);
    if (!natural) return natural.error();
    if (!trial.is_whole()) return error::bad("max_lines");
    double high = height / natural->height, low = high;
    if (!(natural->height > 0.0) || !is_finite(high)) high = low = width / natural->width;
    if (natural->width * low > width) low = width / natural->width;
    auto fits = trial.fits(high);
    if (!fits || *fits) return fits ? result<double>{high} : fits.error();
    while (high > low * (1.0 + 1e-6)) {
        const double middle = low + (high - low) / 2;
        fits = trial.fits(middle);
        if (!fits) return fits.error();
        (*fits ? low : high) = middle;
    }
    return low;
}

}  // namespace typemesh::inline TYPEMESH_ABI
