// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/unicode/impl/script_table.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace typemesh::inline TYPEMESH_ABI {

/// The number of a script, made from its four letters in ISO 15924. The first letter is in the highest byte:
/// script_tag("Latn").
[[nodiscard]] constexpr std::uint32_t script_tag(const char (&letters)[5]) noexcept
{
    std::uint32_t tag = 0;
    for (std::size_t i = 0; i < 4; ++i) tag = tag << 8 | static_cast<unsigned char>(letters[i]);
    return tag;
}

/// Whether text of two scripts is set like text of one script. This is true for equal scripts, and for Han, the kana
/// and Bopomofo: these change within words, share their punctuation and are kerned with each other.
[[nodiscard]] constexpr bool set_as_one(std::uint32_t a, std::uint32_t b) noexcept
{
    const auto east_asian = [](std::uint32_t s) noexcept {
        return s == script_tag("Hani") || s == script_tag("Hira") || s == script_tag("Kana") || s == script_tag("Bopo");
    };
    return a == b || (east_asian(a) && east_asian(b));
}

/// Whether letters of a script touch along a line: Arabic and the other joined scripts, and Devanagari, Bengali and
/// others whose letters hang from one line.
[[nodiscard]] constexpr bool joins_letters(std::uint32_t script) noexcept
{
    for (const std::uint32_t joined :
         {script_tag("Arab"), script_tag("Aran"), script_tag("Syrc"), script_tag("Nkoo"), script_tag("Mand"),
          script_tag("Mong"), script_tag("Phag"), script_tag("Adlm"), script_tag("Rohg"), script_tag("Mani"),
          script_tag("Phlp"), script_tag("Sogd"), script_tag("Chrs"), script_tag("Ougr"), script_tag("Deva"),
          script_tag("Beng"), script_tag("Guru"), script_tag("Modi"), script_tag("Tirh"), script_tag("Nand")})
        if (script == joined) return true;
    return false;
}

/// The scripts in which a character may occur: Script_Extensions. The universal set means all scripts.
class script_set {
    static constexpr std::size_t scripts = sizeof detail::script_tags / sizeof detail::script_tags[0];
    static constexpr std::size_t words = (scripts + 63) / 64;
    static constexpr std::size_t latin = [] {
        std::size_t i = 0;
        while (detail::script_tags[i] != script_tag("Latn")) ++i;
        return i;
    }();

public:
    constexpr script_set() noexcept = default;

    /// The set of one code point. It is universal for Common, Inherited and Unknown code points, including private
    /// ones.
    ///
    /// Cost   O(log(ranges)): eleven reads of a table of 9 kB, none for ASCII
    [[nodiscard]] static script_set of(char32_t c) noexcept { return numbered(range_of(c).number); }

    /// Consecutive characters with the same set, and the number of this set. Number 0 is the universal set.
    struct range {
        char32_t first;
        char32_t last;
        std::size_t number;
    };
    /// The range that contains c.
    [[nodiscard]] static range range_of(char32_t c) noexcept
    {
        using detail::script_ranges;
        if (c < 0x80) {
            const bool letter = (c | 0x20) >= U'a' && (c | 0x20) <= U'z';
            return {c, c, letter ? latin : 0};
        }
        if (c > 0x10FFFF) return {c, c, 0};
        const auto begins_behind = [c](std::size_t i) noexcept { return script_ranges[i] >> 9 > c; };
        constexpr std::size_t ranges = sizeof script_ranges / sizeof script_ranges[0];
        const std::size_t next = first_where(1, ranges, begins_behind);
        const std::size_t number = script_ranges[next - 1] & 0x1FF;
        return {script_ranges[next - 1] >> 9, next == ranges ? 0x10FFFF : (script_ranges[next] >> 9) - 1,
                number < 3 ? 0 : number};
    }

    /// The set with this number.
    [[nodiscard]] static script_set numbered(std::size_t number) noexcept
    {
        using namespace detail;
        script_set set;
        if (number == 0) return set;
        if (number < scripts) {
            set.keep_only(number);
            return set;
        }
        const std::size_t k = number - scripts;
        set.keep_only(script_members[script_starts[k]]);
        for (std::size_t i = script_starts[k]; i < script_starts[k + 1]; ++i)
            set.bits_[script_members[i] / 64] |= std::uint64_t{1} << script_members[i] % 64;
        return set;
    }

    /// Whether it is the universal set, which excludes no script.
    [[nodiscard]] constexpr bool universal() const noexcept { return preferred_ == 0; }

    /// The script to use if nothing decides between several; 'Zyyy' for the universal set.
    [[nodiscard]] constexpr std::uint32_t tag() const noexcept { return detail::script_tags[preferred_]; }

    /// Keeps the scripts that are in both sets. If no script is in both, returns false and changes nothing.
    constexpr bool intersect(const script_set& other) noexcept
    {
        if (other.universal()) return true;
        if (universal()) {
            *this = other;
            return true;
        }
        script_set both;
        std::size_t lowest = 0;
        for (std::size_t w = words; w-- > 0;) {
            both.bits_[w] = bits_[w] & other.bits_[w];
            if (both.bits_[w] != 0) lowest = w * 64 + static_cast<std::size_t>(std::countr_zero(both.bits_[w]));
        }
        if (lowest == 0) return false;
        both.preferred_ = both.holds(preferred_)         ? preferred_
                          : both.holds(other.preferred_) ? other.preferred_
                                                         : static_cast<std::uint8_t>(lowest);
        *this = both;
        return true;
    }

private:
    constexpr void keep_only(std::size_t number) noexcept
    {
        *this = {};
        bits_[number / 64] = std::uint64_t{1} << number % 64;
        preferred_ = static_cast<std::uint8_t>(number);
    }
    [[nodiscard]] constexpr bool holds(std::size_t number) const noexcept
    {
        return (bits_[number / 64] >> number % 64 & 1) != 0;
    }

    std::uint64_t bits_[words] = {};
    std::uint8_t preferred_ = 0;  // 0: universal
};

}  // namespace typemesh::inline TYPEMESH_ABI
