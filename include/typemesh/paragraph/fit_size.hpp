// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/paragraph/line_room.hpp>
#include <typemesh/paragraph/paragraph_options.hpp>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// Measures a paragraph at one size of an em after the other.
template <class Paragraph>
struct size_trial {
    Paragraph& words;
    double width, height;  // of the box
    paragraph_options options;

    /// Whether the text fits into the box at a size.
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

/// The largest size of an em at which a paragraph's text fits into a box, to a millionth. Lines end as the options say,
/// but no word is broken to fit a larger size, unless at every grapheme (wrap_mode::grapheme).
///
///     auto size = fit_size(words, 30.0, 10.0, options);            of 30 by 10, in the unit of the mesh
///     options.width = 30.0 / *size;
///     words.lay_out(options, run);                                 drawn with text_options::size = *size
///
///     width     along the lines: in columns down
///     height    across them, from the first line's ascender to the last one's descender
///     options   width and ellipsis do not count; with max_lines it fits into so many
///
/// Breakers that may make more lines of a wider room, as total_fit may, can leave a larger size that would fit.
///
/// Fails  error::bad_option: width or height are not positive and finite, the text demands more than max_lines, or
///        there is none, as before set(); and
///        as paragraph::measure() does
/// Cost   some 30 calls of measure()
template <class Paragraph>
result<double> fit_size(Paragraph& words, double width, double height, const paragraph_options& options = {}) noexcept
{
    if (!(width > 0.0) || !is_finite(width)) return error::bad("width");
    if (!(height > 0.0) || !is_finite(height)) return error::bad("height");
    detail::size_trial<Paragraph> trial{words, width, height, options};
    trial.options.ellipsis = {};
    trial.options.width = paragraph_options{}.width;
    if (options.wrap == wrap_mode::word_or_grapheme) trial.options.wrap = wrap_mode::word;

    // On as few lines as the text demands: it fits for certain so, and no larger size is less high.
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
