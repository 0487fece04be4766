// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/markup/markup.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// A text with its spans, as basic_markup gives them.
template <class Char>
struct basic_marked_text {
    std::basic_string_view<Char> text;                      ///< without tags
    array_view<const markup_span> spans;                    ///< in the order of the text, without overlaps
    array_view<const basic_markup_look<Char>> looks;        ///< number 0 is the plain look
    array_view<const std::basic_string_view<Char>> rubies;  ///< for markup_span::ruby
    array_view<const inline_box> boxes = {};                ///< in the order of the text, which has U+FFFC there
};

namespace detail {

/// Appends text with tags. Members return false when out of memory.
template <class Char>
class markup_writer {
public:
    using view = std::basic_string_view<Char>;

    explicit markup_writer(buffer<Char>& out) noexcept : out_{&out} {}

    [[nodiscard]] bool ascii(std::string_view words) noexcept
    {
        for (const char c : words)
            if (!out_->push_back(static_cast<Char>(c))) return false;
        return true;
    }
    [[nodiscard]] bool words(view some) noexcept
    {
        return out_->append(array_view<const Char>{some.data(), some.size()});
    }

    /// Text, in which brackets are doubled.
    [[nodiscard]] bool text(view some) noexcept
    {
        for (;;) {
            const std::size_t bracket = some.find(static_cast<Char>('['));
            if (bracket == view::npos) return words(some);
            if (!words(some.substr(0, bracket + 1)) || !ascii("[")) return false;
            some.remove_prefix(bracket + 1);
        }
    }
    [[nodiscard]] bool closing(markup_tag t) noexcept { return ascii("[/") && ascii(name_of(t)) && ascii("]"); }
    [[nodiscard]] bool opening(markup_tag t) noexcept { return ascii("[") && ascii(name_of(t)) && ascii("]"); }
    [[nodiscard]] bool valued(markup_tag t) noexcept { return ascii("[") && ascii(name_of(t)) && ascii("="); }

    /// A number of millionths.
    [[nodiscard]] bool number(markup_tag t, std::int64_t n) noexcept { return valued(t) && digits(n) && ascii("]"); }
    [[nodiscard]] bool digits(std::int64_t n) noexcept
    {
        char all[24] = {}, *last = all + sizeof all, *first = last;
        std::int64_t rest = n < 0 ? -n : n;
        bool behind = false;  // a digit behind the point has been written
        for (int i = 0; i < 6; ++i, rest /= 10)
            if (behind || rest % 10 != 0) {
                behind = true;
                *--first = static_cast<char>('0' + rest % 10);
            }
        if (behind) *--first = '.';
        do *--first = static_cast<char>('0' + rest % 10);
        while ((rest /= 10) != 0);
        if (n < 0) *--first = '-';
        return ascii({first, static_cast<std::size_t>(last - first)});
    }
    [[nodiscard]] bool integer(markup_tag t, std::uint32_t n) noexcept
    {
        char digits[12] = {}, *last = digits + sizeof digits, *first = last;
        do *--first = static_cast<char>('0' + n % 10);
        while ((n /= 10) != 0);
        return valued(t) && ascii({first, static_cast<std::size_t>(last - first)}) && ascii("]");
    }
    [[nodiscard]] bool colour(markup_tag t, std::uint32_t rgb) noexcept
    {
        char digits[7] = {'#'};
        for (int i = 0; i < 6; ++i) digits[i + 1] = "0123456789abcdef"[rgb >> (20 - 4 * i) & 15];
        return valued(t) && ascii({digits, sizeof digits}) && ascii("]");
    }
    /// `quote`: its quotation mark, or 0.
    [[nodiscard]] bool quoted(markup_tag t, view value, char quote) noexcept
    {
        const std::string_view mark{&quote, quote != 0 ? std::size_t{1} : std::size_t{0}};
        return valued(t) && ascii(mark) && words(value) && ascii(mark) && ascii("]");
    }

private:
    [[nodiscard]] static constexpr std::string_view name_of(markup_tag t) noexcept
    {
        return markup_tag_forms[static_cast<std::size_t>(t)].name;
    }

    buffer<Char>* out_;
};

/// Prints spans, look by look.
template <class Char>
class markup_printer {
public:
    using view = std::basic_string_view<Char>;
    using look = basic_markup_look<Char>;

    explicit markup_printer(buffer<Char>& out) noexcept : write_{out} {}

    [[nodiscard]] error print(const basic_marked_text<Char>& m) noexcept
    {
        std::uint32_t at = 0, ruby = 0;
        for (const markup_span& s : m.spans) {
            if (s.first < at || s.last < s.first || s.last > m.text.size()) return error::bad("spans");
            if (s.look != 0 && s.look >= m.looks.size()) return error::bad("look");
            if (s.ruby > m.rubies.size()) return error::bad("ruby");
            const bool goes_on = s.ruby == ruby && s.first == at;
            if (ruby != 0 && !goes_on && !write_.closing(markup_tag::ruby)) return error::out_of_memory;
            if (error e = put_text(m, at, s.first)) return e;
            if (s.ruby != 0 && !goes_on)
                if (error e = put_words(markup_tag::ruby, m.rubies[s.ruby - 1])) return e;
            ruby = s.ruby;
            const look& l = s.look != 0 ? m.looks[s.look] : plain_;
            if (error e = open(l)) return e;
            if (error e = put_text(m, s.first, s.last)) return e;
            if (!close(l)) return error::out_of_memory;
            at = s.last;
        }
        if (ruby != 0 && !write_.closing(markup_tag::ruby)) return error::out_of_memory;
        if (error e = put_text(m, at, static_cast<std::uint32_t>(m.text.size()))) return e;
        return box_ == m.boxes.size() ? error{} : error::bad("boxes");
    }

private:
    /// Text, and the boxes in it.
    error put_text(const basic_marked_text<Char>& m, std::uint32_t at, std::uint32_t last) noexcept
    {
        constexpr view object = object_character<Char>();
        for (; box_ < m.boxes.size() && m.boxes[box_].unit < last; ++box_) {
            const inline_box& b = m.boxes[box_];
            if (b.unit < at || m.text.substr(b.unit, object.size()) != object) return error::bad("boxes");
            if (!write_.text(m.text.substr(at, b.unit - at))) return error::out_of_memory;
            if (error e = put_box(b)) return e;
            at = b.unit + static_cast<std::uint32_t>(object.size());
        }
        if (at > last) return error::bad("boxes");
        return write_.text(m.text.substr(at, last - at)) ? error{} : error{error::out_of_memory};
    }
    error put_box(const inline_box& b) noexcept
    {
        std::int64_t width = 0, ascent = 0, descent = 0;
        const bool sound = in_millionths(b.width, width) && in_millionths(b.ascent, ascent) &&
                           in_millionths(b.descent, descent) && width >= 0 && ascent + descent >= 0;
        if (!sound) return error::bad("boxes");
        const bool ok = write_.valued(markup_tag::box) && write_.digits(width) && write_.ascii(",") &&
                        write_.digits(ascent) && (descent == 0 || (write_.ascii(",") && write_.digits(descent)));
        return ok && write_.ascii("]") ? error{} : error{error::out_of_memory};
    }
    /// Whether a number is a multiple of a millionth, up to 1000.
    static bool in_millionths(double value, std::int64_t& n) noexcept
    {
        constexpr auto unit = static_cast<double>(markup_unit);
        if (!is_finite(value) || value < -1000.0 || value > 1000.0) return false;
        n = static_cast<std::int64_t>(value * unit + (value < 0.0 ? -0.5 : 0.5));
        return same(static_cast<double>(n) / unit, value);
    }

    /// Calls what(tag) for each tag of a look that is on, in their order or backwards, until it returns an error.
    template <class What>
    static error each_tag(const look& l, bool backwards, const What& what) noexcept
    {
        for (std::uint32_t i = 0; i < markup_tag_count; ++i) {
            const auto t = static_cast<markup_tag>(backwards ? markup_tag_count - 1 - i : i);
            const bool on = t == markup_tag::superscript ? l.position == script_position::superscript
                            : t == markup_tag::subscript ? l.position == script_position::subscript
                                                         : t != markup_tag::ruby && t != markup_tag::box && l.has(t);
            if (on)
                if (error e = what(t)) return e;
        }
        return {};
    }

    error open(const look& l) noexcept
    {
        return each_tag(l, false, [&](markup_tag t) noexcept -> error {
            switch (t) {
            case markup_tag::size: return put_number(t, l.size);
            case markup_tag::rise: return put_number(t, l.rise);
            case markup_tag::spacing: return put_number(t, l.spacing);
            case markup_tag::depth: return put_number(t, l.depth);
            case markup_tag::bevel: return put_number(t, l.bevel);
            case markup_tag::font: return put_words(t, l.font);
            case markup_tag::language:
                return is_language_tag(l.language) ? put_words(t, l.language) : error::bad("lang");
            case markup_tag::colour:
                if (l.colour > 0xFF'FFFF) return error::bad("colour");
                return write_.colour(t, l.colour) ? error{} : error{error::out_of_memory};
            case markup_tag::mark:
                if (l.mark > 0xFF'FFFF) return error::bad("mark");
                return write_.colour(t, l.mark) ? error{} : error{error::out_of_memory};
            case markup_tag::style:
                if (l.style == static_cast<std::uint32_t>(no_style)) return error::bad("style");
                return write_.integer(t, l.style) ? error{} : error{error::out_of_memory};
            case markup_tag::bold:
            case markup_tag::italic:
            case markup_tag::underline:
            case markup_tag::strike:
            case markup_tag::overline:
            case markup_tag::superscript:
            case markup_tag::subscript:
            case markup_tag::ruby:
            case markup_tag::box: break;
            }
            return write_.opening(t) ? error{} : error{error::out_of_memory};
        });
    }
    [[nodiscard]] bool close(const look& l) noexcept
    {
        return !each_tag(
            l, true, [&](markup_tag t) noexcept { return write_.closing(t) ? error{} : error{error::out_of_memory}; });
    }

    error put_number(markup_tag t, double value) noexcept
    {
        const markup_tag_form& form = markup_tag_forms[static_cast<std::size_t>(t)];
        std::int64_t n = 0;
        if (!in_millionths(value, n) || n < form.low || n > form.high) return error::bad(form.name.data());
        return write_.number(t, n) ? error{} : error{error::out_of_memory};
    }

    error put_words(markup_tag t, view value) noexcept
    {
        const auto has = [value](char c) noexcept { return value.find(static_cast<Char>(c)) != view::npos; };
        const markup_tag_form& form = markup_tag_forms[static_cast<std::size_t>(t)];
        const bool plain =
            !value.empty() && value[0] != static_cast<Char>('"') && value[0] != static_cast<Char>('\'') && !has(']');
        const char quote = plain ? '\0' : has('"') ? '\'' : '"';
        if (value.empty() || (!plain && has(quote))) return error::bad(form.name.data());
        return write_.quoted(t, value, quote) ? error{} : error{error::out_of_memory};
    }

    markup_writer<Char> write_;
    look plain_;
    std::size_t box_ = 0;  // the next one
};

}  // namespace detail

/// Appends a text with tags that basic_markup reads as the same text with the same spans. Tags are closed in the
/// reverse order; none crosses another.
///
/// Fails  error::bad_option: "spans" or "boxes" overlap, lie outside the text or are not in its order; a "look"
///        or "ruby" does not exist; or no tag can express a value, which the option names: a number out of range or
///        with more than six decimals, words that are empty or contain a ] and both quotation marks;
///        error::out_of_memory. What `out` has then gained means nothing.
/// Cost   O(text + tags)
template <class Char>
result<void> print_markup(const basic_marked_text<Char>& marked, buffer<Char>& out) noexcept
{
    return detail::markup_printer<Char>{out}.print(marked);
}
template <class Char>
result<void> print_markup(const basic_markup<Char>& read, buffer<Char>& out) noexcept
{
    return print_markup<Char>({read.text(), read.spans(), read.looks(), read.rubies(), read.boxes()}, out);
}

}  // namespace typemesh::inline TYPEMESH_ABI
