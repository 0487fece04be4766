// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/paragraph/laid_text.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

[[nodiscard]] constexpr bool is_kana(char32_t c) noexcept
{
    return (c >= 0x3041 && c <= 0x3096) || (c >= 0x309D && c <= 0x309F) || (c >= 0x30A1 && c <= 0x30FA) ||
           (c >= 0x30FC && c <= 0x30FF) || (c >= 0x31F0 && c <= 0x31FF) || (c >= 0xFF66 && c <= 0xFF9D);
}
[[nodiscard]] inline bool kana_at(text_view text, std::uint32_t unit) noexcept
{
    return unit < text.size() && is_kana(decode(text, unit).value);
}
[[nodiscard]] inline bool kana_before(text_view text, std::uint32_t unit) noexcept
{
    const std::uint32_t most = text.encoding() == encoding::utf16 ? 2 : 4;
    for (std::uint32_t back = most < unit ? most : unit; back > 0; --back)
        if (const code_point c = decode(text, unit - back); c.next == unit) return is_kana(c.value);
    return false;
}

/// The first box of a text that has a ruby. Lengths are in font units, along the line.
struct ruby_base {
    text_range text = {};
    std::uint32_t line = 0;
    std::uint32_t parts = 0;  ///< the number of its boxes
    double from = 0.0, to = 0.0;
    bool kana_before = false, kana_behind = false;  ///< whether the ruby may reach over the neighbour in its line

    /// The part of an excess that is before the text, if `before` and `behind` are free: half of it if possible.
    [[nodiscard]] double reach_before(double excess, double before, double behind) const noexcept
    {
        double reach = 0.5 * excess;
        if (before + behind < excess) {
            if (begins_line && kana_behind) return 0.0;
            return ends_line && kana_before ? excess : reach;
        }
        if (reach > before) reach = before;
        return excess - reach > behind ? excess - behind : reach;
    }
    bool begins_line = false, ends_line = false;
};

/// Finds it, without white space at its ends, and without the letter spacing and the gap behind its last cluster. It
/// has no parts if nothing of it is visible.
[[nodiscard]] inline ruby_base find_ruby_base(const laid_text& laid, text_range text) noexcept
{
    ruby_base found;
    const shaped_text& shaped = laid.shaped();
    if (laid.lines().empty() || text.first >= text.last) return found;
    if (const text_room* room = shaped.insets.room_at(text.first); room != nullptr) text = {room->first, room->last};
    found.text = text;
    const auto is_own = [&](std::uint32_t k) noexcept {
        const text_cluster& c = shaped.cluster(k);
        return text.holds(c.first) && !has(c.flags, cluster_flags::foreign);
    };
    for (std::size_t n = laid.line_of(text.first); n < laid.lines().size() && laid.lines()[n].first < text.last; ++n) {
        const laid_line& line = laid.lines()[n];
        bool goes_on = false;  // from the slice to the left
        for (const line_slice& s : laid.slices_of(line)) {
            const bool back = s.level % 2 != 0;
            double low = 0.0, high = 0.0, behind = 0.0;
            bool any = false;
            laid.each_cluster(s, [&](std::uint32_t k, double pen, double width) noexcept {
                const text_cluster& c = shaped.cluster(k);
                if (!is_own(k) || has(c.flags, cluster_flags::unshown)) return;
                const double a = back ? pen - width : pen, b = back ? pen : pen + width;
                low = !any || a < low ? a : low;
                high = !any || b > high ? b : high;
                behind = width - (c.advance - shaped.spacing_of(c));
                any = true;
            });
            if (!any) {
                goes_on = false;
                continue;
            }
            (back ? low : high) += back ? behind : 0.0 - behind;
            const bool joined = goes_on && is_own(back ? s.last - 1 : s.first);
            if (!joined && found.parts++ == 0) {
                found.line = static_cast<std::uint32_t>(n);
                found.from = low;
            }
            if (found.parts == 1 && found.line == n) found.to = high;
            goes_on = is_own(back ? s.first : s.last - 1);
        }
    }
    if (found.parts == 0) return found;
    const laid_line& line = laid.lines()[found.line];
    const auto is_free = [&](std::uint32_t unit) noexcept { return shaped.insets.room_at(unit) == nullptr; };
    found.begins_line = text.first <= line.first;
    found.ends_line = text.last >= line.last;
    found.kana_before = !found.begins_line && kana_before(shaped.text(), text.first) && is_free(text.first - 1);
    found.kana_behind = !found.ends_line && kana_at(shaped.text(), text.last) && is_free(text.last);
    return found;
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
