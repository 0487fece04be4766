// SPDX-License-Identifier: MIT
#pragma once

#include "values.hpp"

#include <typemesh/markup/markup_styles.hpp>
#include <typemesh/markup/print_markup.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Text with tags -> text, spans, looks -> styles; and printed again.
namespace fuzz {

namespace markup_laws {

using namespace typemesh;

/// Pieces of tags are frequent; any unit stands anywhere.
template <class Char>
std::basic_string<Char> read_source(values& in, std::size_t most)
{
    static constexpr std::string_view pieces[] = {"[b]",
                                                  "[/b]",
                                                  "[i]",
                                                  "[/i]",
                                                  "[/]",
                                                  "[[",
                                                  "]",
                                                  "[",
                                                  "[size=",
                                                  "[/size]",
                                                  "[rise=-",
                                                  "0.25]",
                                                  "1.5]",
                                                  "1000]",
                                                  "]x",
                                                  "[colour=#c33]",
                                                  "[color=",
                                                  "#01aBcD",
                                                  "[style=7]",
                                                  "[/style]",
                                                  "[font=a b]",
                                                  "[font=\"",
                                                  "\"",
                                                  "'",
                                                  "[lang=ja]",
                                                  "[ruby=x",
                                                  "[/ruby]",
                                                  "[sup]",
                                                  "[/sup]",
                                                  "[sub]",
                                                  "[/sub]",
                                                  "[depth=0.1]",
                                                  "[bevel=2]",
                                                  "/",
                                                  "=",
                                                  ".",
                                                  "0",
                                                  "9",
                                                  "-",
                                                  "[u]",
                                                  "[/depth]",
                                                  "[s]",
                                                  "[spacing=.1]",
                                                  "[/spacing]",
                                                  "[/colour]",
                                                  "[/font]",
                                                  "x",
                                                  "yz",
                                                  "[mark=#ff0]",
                                                  "[/mark]",
                                                  "[box=1.2,.8]",
                                                  "[box=",
                                                  ","};
    std::basic_string<Char> source;
    while (!in.empty() && source.size() < most) {
        const std::uint32_t byte = in.byte();
        if (byte < std::size(pieces))
            for (const char c : pieces[byte]) source += static_cast<Char>(c);
        else if (byte < 0x60)
            source += static_cast<Char>(in.bits(sizeof(Char)));
        else
            source += static_cast<Char>(byte);
    }
    return source;
}

/// What is left when well-formed tags are taken out.
template <class Char>
std::basic_string<Char> stripped(const std::basic_string<Char>& source)
{
    std::basic_string<Char> text;
    for (std::size_t i = 0; i < source.size(); ++i) {
        const bool doubled = source[i] == '[' && i + 1 < source.size() && source[i + 1] == '[';
        if (source[i] != '[' || doubled) {
            text += source[i];
            if (doubled) ++i;
            continue;
        }
        const std::size_t bracket = i;
        while (source[i] != ']' && source[i] != '=') ++i;
        if (i == bracket + 4 && source[bracket + 1] == 'b' && source[bracket + 2] == 'o' && source[bracket + 3] == 'x')
            text += detail::object_character<Char>();
        if (source[i] == '=' && (source[i + 1] == '"' || source[i + 1] == '\'')) i = source.find(source[i + 1], i + 2);
        i = source.find(static_cast<Char>(']'), i);
    }
    return text;
}

template <class Char>
broken_law of_boxes(const basic_markup<Char>& read)
{
    std::size_t at = 0;
    for (const inline_box& b : read.boxes()) {
        const auto object = detail::object_character<Char>();
        if (b.unit < at || read.text().substr(b.unit, object.size()) != object) return "a box is at another place";
        if (!(b.width >= 0.0) || !(b.ascent + b.descent >= 0.0)) return "a box of negative size";
        at = b.unit + object.size();
    }
    return "";
}

template <class Char>
broken_law of_spans(const basic_markup<Char>& read)
{
    std::uint32_t at = 0, look = 0, ruby = 0, last_ruby = 0;
    for (const markup_span& s : read.spans()) {
        if (s.first < at || s.last <= s.first || s.last > read.text().size()) return "spans are not in order";
        if (s.look == 0 && s.ruby == 0) return "a plain span";
        if (s.look != 0 && s.look >= read.looks().size()) return "a span has no look";
        if (s.ruby != 0 && s.ruby != last_ruby && s.ruby != last_ruby + 1) return "rubies are not in order";
        if (s.ruby > read.rubies().size()) return "a span has no ruby";
        if (s.first == at && at != 0 && s.look == look && s.ruby == ruby) return "neighbours are alike";
        at = s.last;
        look = s.look;
        ruby = s.ruby;
        if (ruby != 0) last_ruby = ruby;
    }
    return "";
}

template <class A, class B>
bool equal(const A& a, const B& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

struct any_font {
    template <class Char>
    error operator()(const basic_markup_look<Char>&, text_style&) const noexcept
    {
        return {};
    }
};

template <class Char>
broken_law of_styles(const basic_markup<Char>& read)
{
    markup_styles styles;
    if (!styles.set(read, any_font{})) return "styles are refused";
    std::size_t styled = 0, looked = 0;
    for (const style_span& s : styles.spans()) {
        if (static_cast<std::size_t>(s.style.style) >= styles.paints().size()) return "a style has no paint";
        if (styles.solid_of(s.style.style) >= styles.solids().size()) return "a paint has no solid";
        styled += s.last - s.first;
    }
    for (const markup_span& s : read.spans()) looked += s.look != 0 ? s.last - s.first : 0;
    if (styled != looked) return "styles cover another text than looks";
    std::uint32_t at = 0, coloured = 0, marked = 0;
    for (const text_highlight& m : styles.marks()) {
        if (m.first < at || m.last <= m.first) return "backgrounds are not in order";
        const auto style = static_cast<std::size_t>(m.style);
        if (style >= styles.paints().size() || !styles.paints()[style].has(markup_tag::mark)) return "no background";
        at = m.last;
        marked += m.last - m.first;
    }
    for (const markup_span& s : read.spans())
        coloured += s.look != 0 && read.looks()[s.look].has(markup_tag::mark) ? s.last - s.first : 0;
    return marked == coloured ? "" : "backgrounds cover another text than their tags";
}

template <class Char>
broken_law of_source(const std::basic_string<Char>& source)
{
    basic_markup<Char> read, again;
    if (const auto done = read.read(source); !done) {
        const error e = done.error();
        if (e != error::bad_markup || e.option == nullptr || e.cluster > source.size()) return "an error without place";
        if (!read.text().empty() || !read.spans().empty()) return "a text in spite of an error";
        return "";
    }
    if (read.text() != stripped(source)) return "letters are lost, or added";
    if (broken_law broken = of_spans(read); !broken.empty()) return broken;
    if (broken_law broken = of_boxes(read); !broken.empty()) return broken;
    buffer<Char> out;
    if (!print_markup(read, out)) return "what has been read cannot be printed";
    const std::basic_string<Char> printed(out.data(), out.size());
    if (!again.read(printed)) return "what is printed cannot be read";
    if (again.text() != read.text() || !equal(again.spans(), read.spans()) || !equal(again.looks(), read.looks()) ||
        !equal(again.rubies(), read.rubies()) || !equal(again.boxes(), read.boxes()))
        return "what is printed is read as something else";
    return of_styles(read);
}

/// Takes out one unit of each mistake, which leaves a source that can be read.
template <class Char>
std::basic_string<Char> mended(std::basic_string<Char> source)
{
    basic_markup<Char> read;
    for (;;) {
        const auto done = read.read(source);
        if (done || done.error().cluster >= source.size()) return source;
        source.erase(done.error().cluster, 1);
    }
}

template <class Char>
broken_law of_source_and_mended(const std::basic_string<Char>& source)
{
    const broken_law broken = of_source(source);
    return broken.empty() ? of_source(mended(source)) : broken;
}

/// A place of a text in UTF-8 in the same text in UTF-16: all is ASCII but the characters of boxes, which have three
/// units and one.
inline std::uint32_t in_utf16(const basic_markup<char>& read, std::uint32_t at)
{
    const auto boxes = read.boxes();
    const auto before = std::count_if(boxes.begin(), boxes.end(), [&](const inline_box& b) { return b.unit < at; });
    return at - 2 * static_cast<std::uint32_t>(before);
}

/// The same ASCII in UTF-16 is read in the same way.
inline broken_law of_both(const std::string& source)
{
    if (std::any_of(source.begin(), source.end(), [](char c) { return static_cast<unsigned char>(c) > 127; }))
        return "";
    const std::u16string wide(source.begin(), source.end());
    basic_markup<char> narrow;
    basic_markup<char16_t> wider;
    const auto a = narrow.read(source), b = wider.read(wide);
    if (a.has_value() != b.has_value()) return "one encoding is refused";
    if (!a) {
        const error e = a.error(), f = b.error();
        return e.cluster == f.cluster && std::string_view{e.option} == f.option ? "" : "other mistakes in UTF-16";
    }
    std::vector<markup_span> expected(narrow.spans().begin(), narrow.spans().end());
    for (markup_span& s : expected) {
        s.first = in_utf16(narrow, s.first);
        s.last = in_utf16(narrow, s.last);
    }
    return equal(expected, wider.spans()) ? "" : "other spans in UTF-16";
}

}  // namespace markup_laws

inline broken_law markup(values in)
{
    using namespace markup_laws;
    if (in.flag()) return of_source_and_mended(read_source<char16_t>(in, 2000));
    const std::string source = read_source<char>(in, 2000);
    if (broken_law broken = of_source_and_mended(source); !broken.empty()) return broken;
    return of_both(source);
}

}  // namespace fuzz
