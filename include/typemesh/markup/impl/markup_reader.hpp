// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/markup/markup_look.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The kind of value that a tag takes.
enum class markup_value_kind : std::uint8_t { none, number, colour, integer, words, language, lengths };

struct markup_tag_form {
    std::string_view name;
    markup_tag tag;
    markup_value_kind kind;
    std::int64_t low = 0, high = 0;  ///< of a number, in millionths
};

inline constexpr std::int64_t markup_unit = 1'000'000;  // numbers are whole multiples of 1 / markup_unit

/// Every name, in the order of markup_tag; other spellings come last.
inline constexpr markup_tag_form markup_tag_forms[] = {
    {"b", markup_tag::bold, markup_value_kind::none},
    {"i", markup_tag::italic, markup_value_kind::none},
    {"u", markup_tag::underline, markup_value_kind::none},
    {"s", markup_tag::strike, markup_value_kind::none},
    {"o", markup_tag::overline, markup_value_kind::none},
    {"sup", markup_tag::superscript, markup_value_kind::none},
    {"sub", markup_tag::subscript, markup_value_kind::none},
    {"size", markup_tag::size, markup_value_kind::number, 1, 1000 * markup_unit},
    {"rise", markup_tag::rise, markup_value_kind::number, -1000 * markup_unit, 1000 * markup_unit},
    {"spacing", markup_tag::spacing, markup_value_kind::number, -1000 * markup_unit, 1000 * markup_unit},
    {"depth", markup_tag::depth, markup_value_kind::number, 0, 1000 * markup_unit},
    {"bevel", markup_tag::bevel, markup_value_kind::number, 0, 1000 * markup_unit},
    {"colour", markup_tag::colour, markup_value_kind::colour},
    {"style", markup_tag::style, markup_value_kind::integer},
    {"font", markup_tag::font, markup_value_kind::words},
    {"lang", markup_tag::language, markup_value_kind::language},
    {"mark", markup_tag::mark, markup_value_kind::colour},
    {"ruby", markup_tag::ruby, markup_value_kind::words},
    {"box", markup_tag::box, markup_value_kind::lengths, -1000 * markup_unit, 1000 * markup_unit},
    {"color", markup_tag::colour, markup_value_kind::colour},
};

/// The eight characters of a name as one number; names are shorter.
template <class Char>
[[nodiscard]] constexpr std::uint64_t packed_name(std::basic_string_view<Char> name) noexcept
{
    std::uint64_t all = 0;
    for (const Char c : name) all = all << 8 | (static_cast<std::uint32_t>(c) & 0xFFu);
    return all;
}

/// Finds a tag by its name. Most names have a slot that no other name takes.
inline constexpr struct markup_name_slots {
    std::uint64_t names[64] = {};
    const markup_tag_form* forms[64] = {};

    constexpr markup_name_slots() noexcept
    {
        for (const markup_tag_form& form : markup_tag_forms) {
            std::size_t at = slot_of(packed_name(form.name));
            while (names[at] != 0) at = (at + 1) % 64;
            names[at] = packed_name(form.name);
            forms[at] = &form;
        }
    }
    [[nodiscard]] static constexpr std::uint32_t slot_of(std::uint64_t name) noexcept
    {
        return static_cast<std::uint32_t>(name * 0x9E37'79B9'7F4A'7C15u >> 58);
    }
    /// Null if there is no such tag.
    [[nodiscard]] constexpr const markup_tag_form* find(std::uint64_t name) const noexcept
    {
        std::size_t at = slot_of(name);
        while (names[at] != name && names[at] != 0) at = (at + 1) % 64;
        return forms[at];
    }
} markup_names;

/// U+FFFC, which stands for a box.
template <class Char>
[[nodiscard]] constexpr std::basic_string_view<Char> object_character() noexcept
{
    if constexpr (sizeof(Char) == 1)
        return "\xEF\xBF\xBC";
    else
        return u"\uFFFC";
}

/// Whether a word could be a tag of BCP 47, by its characters.
template <class Char>
[[nodiscard]] bool is_language_tag(std::basic_string_view<Char> word) noexcept
{
    for (const Char c : word) {
        const auto u = static_cast<std::uint32_t>(c);
        const bool letter = (u >= 'a' && u <= 'z') || (u >= 'A' && u <= 'Z');
        if (!letter && !(u >= '0' && u <= '9') && u != '-') return false;
    }
    return true;
}

/// A tag that has been read, or the mistake in it.
template <class Char>
struct read_markup_tag {
    const markup_tag_form* form = nullptr;  ///< null: [/]
    bool closes = false;
    double number = 0.0;
    double lengths[3] = {};                   ///< of a box: width, ascent, descent
    std::uint32_t integer = 0;                ///< of a colour as well
    std::basic_string_view<Char> words = {};  ///< the value as it is written, without its quotation marks
    std::size_t end = 0;                      ///< behind the tag; of a mistake, where it is
    const char* mistake = nullptr;
};

/// Reads the tags of a source. It reads each unit once, and no unit behind the tag.
template <class Char>
class markup_reader {
public:
    using view = std::basic_string_view<Char>;

    explicit markup_reader(view source) noexcept : source_{source} {}

    /// The tag whose bracket is there. It belongs to the reader, until the next call.
    [[nodiscard]] const read_markup_tag<Char>& read(std::size_t bracket) noexcept
    {
        first_ = bracket;
        at_ = bracket + 1;
        out_.form = nullptr;
        out_.closes = false;
        out_.integer = 0;
        out_.mistake = nullptr;
        if (is('/')) {
            out_.closes = true;
            ++at_;
            if (is(']')) return ended();
        }
        if (!read_name()) return out_;
        const bool plain = out_.closes || out_.form->kind == markup_value_kind::none;
        if (is(']')) return plain ? ended() : wrong("a tag without its value", first_);
        if (plain) return wrong(out_.closes ? "a value in a closing tag" : "a value for a tag without values", first_);
        ++at_;  // behind the =
        const std::size_t place = at_;
        if (!read_words()) return out_;
        if (const char* mistake = take_value(); mistake != nullptr) return wrong(mistake, place);
        return ended();
    }

private:
    static constexpr std::size_t longest_name = 7;

    [[nodiscard]] bool is(char c) const noexcept
    {
        return at_ < source_.size() && source_[at_] == static_cast<Char>(c);
    }

    const read_markup_tag<Char>& ended() noexcept
    {
        out_.end = at_ + 1;
        return out_;
    }
    const read_markup_tag<Char>& wrong(const char* mistake, std::size_t place) noexcept
    {
        out_.mistake = mistake;
        out_.end = place;
        return out_;
    }

    /// The name up to = or ].
    [[nodiscard]] bool read_name() noexcept
    {
        std::uint64_t name = 0;
        const std::size_t begin = at_;
        const Char *first = source_.data() + begin, *const last = source_.data() + source_.size();
        for (; first != last; ++first) {
            const auto c = static_cast<std::uint32_t>(*first);
            if (c - 'a' > 'z' - 'a') break;
            name = name << 8 | c;
        }
        at_ = static_cast<std::size_t>(first - source_.data());
        if (at_ - begin > longest_name) return wrong("an unknown tag", first_), false;
        if (at_ == source_.size()) return wrong("a tag without its ]", first_), false;
        if (!is(']') && !is('=')) return wrong("an unknown tag", first_), false;
        out_.form = markup_names.find(name);
        return out_.form != nullptr || (wrong("an unknown tag", first_), false);
    }

    /// The value up to ], or between quotation marks of one kind. Afterwards at_ is the bracket.
    [[nodiscard]] bool read_words() noexcept
    {
        if (is('"') || is('\'')) {
            const std::size_t last = source_.find(source_[at_], at_ + 1);
            if (last == view::npos) return wrong("a value without its second quotation mark", at_), false;
            out_.words = source_.substr(at_ + 1, last - at_ - 1);
            at_ = last + 1;
            if (at_ == source_.size()) return wrong("a tag without its ]", first_), false;
            return is(']') || (wrong("something behind a quotation mark", at_), false);
        }
        const std::size_t last = source_.find(static_cast<Char>(']'), at_);
        if (last == view::npos) return wrong("a tag without its ]", first_), false;
        out_.words = source_.substr(at_, last - at_);
        at_ = last;
        return true;
    }

    /// Gives what is wrong, or null.
    [[nodiscard]] const char* take_value() noexcept
    {
        if (out_.words.empty()) return "an empty value";
        switch (out_.form->kind) {
        case markup_value_kind::number: return take_number(out_.words, out_.number);
        case markup_value_kind::lengths: return take_lengths();
        case markup_value_kind::colour: return take_colour();
        case markup_value_kind::integer: return take_integer();
        case markup_value_kind::language: return take_language();
        case markup_value_kind::words:
        case markup_value_kind::none: break;
        }
        return nullptr;
    }

    /// -12.5: at most six digits behind the point. The number is the nearest double, for a quotient of two exact ones.
    [[nodiscard]] const char* take_number(view words, double& number) noexcept
    {
        constexpr const char* refused = "a number out of range, or with more than six decimals";
        const bool negative = !words.empty() && words[0] == static_cast<Char>('-');
        std::int64_t whole = 0, unit = markup_unit;
        bool digits = false, behind = false;
        for (const Char c : words.substr(negative ? 1 : 0)) {
            if (c == static_cast<Char>('.') && !behind) {
                behind = true;
                digits = false;
                continue;
            }
            if (c < static_cast<Char>('0') || c > static_cast<Char>('9')) return "a value that is not a number";
            digits = true;
            const auto digit = static_cast<std::int64_t>(c - static_cast<Char>('0'));
            if (behind && (unit /= 10) == 0) return refused;
            whole = behind ? whole + digit * unit : whole * 10 + digit * markup_unit;
            if (whole > 1000 * markup_unit) return refused;
        }
        if (!digits) return "a value that is not a number";
        if (negative) whole = -whole;
        if (whole < out_.form->low || whole > out_.form->high) return refused;
        number = static_cast<double>(whole) / static_cast<double>(markup_unit);
        return nullptr;
    }

    /// 1.2,0.8 or 1.2,0.8,0.1: width, height above the baseline, depth below it.
    [[nodiscard]] const char* take_lengths() noexcept
    {
        constexpr const char* refused = "a box that is not like 1.2,0.8 or 1.2,0.8,0.2";
        view rest = out_.words;
        std::size_t count = 0;
        out_.lengths[2] = 0.0;
        for (bool more = true; more;) {
            const std::size_t comma = rest.find(static_cast<Char>(','));
            more = comma != view::npos;
            if (count == 3) return refused;
            if (const char* mistake = take_number(rest.substr(0, comma), out_.lengths[count++]); mistake != nullptr)
                return mistake;
            if (more) rest.remove_prefix(comma + 1);
        }
        if (count < 2 || out_.lengths[0] < 0.0 || out_.lengths[1] + out_.lengths[2] < 0.0) return refused;
        return nullptr;
    }

    [[nodiscard]] const char* take_colour() noexcept
    {
        constexpr const char* refused = "a colour that is not like #c33 or #cc3333";
        const std::size_t size = out_.words.size();
        if ((size != 4 && size != 7) || out_.words[0] != static_cast<Char>('#')) return refused;
        for (const Char c : out_.words.substr(1)) {
            const auto u = static_cast<std::uint32_t>(c), letter = (u | 0x20u) - 'a';
            const std::uint32_t digit = u - '0' < 10 ? u - '0' : letter < 6 ? letter + 10 : 16;
            if (digit == 16) return refused;
            out_.integer = out_.integer << 4 | digit;
            if (size == 4) out_.integer = out_.integer << 4 | digit;
        }
        return nullptr;
    }

    [[nodiscard]] const char* take_integer() noexcept
    {
        constexpr const char* refused = "a style that is not a whole number below 4294967295";
        std::uint64_t all = 0;
        for (const Char c : out_.words) {
            if (c < static_cast<Char>('0') || c > static_cast<Char>('9')) return refused;
            all = all * 10 + static_cast<std::uint64_t>(c - static_cast<Char>('0'));
            if (all >= (std::numeric_limits<std::uint32_t>::max)()) return refused;
        }
        out_.integer = static_cast<std::uint32_t>(all);
        return nullptr;
    }

    [[nodiscard]] const char* take_language() const noexcept
    {
        return is_language_tag(out_.words) ? nullptr : "a language that is not like ja or zh-Hant";
    }

    view source_;
    std::size_t first_ = 0, at_ = 0;
    read_markup_tag<Char> out_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
