// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/text/text_letter.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The order in which letters have their turn. For words or lines, give the number of the word or line.
enum class letter_order : std::uint8_t {
    forward,  ///< in reading order, whatever the direction of the script
    reverse,
    from_centre,  ///< from the middle of the text to both ends
    to_centre,    ///< from both ends to the middle
};

/// When a letter's turn comes: 0 for the first one, 1 for the last one. Letters at equal distances from the middle have
/// their turn together. 0 if there is only one.
[[nodiscard]] constexpr double turn_of(letter_order order, std::uint32_t index, std::uint32_t count) noexcept
{
    if (count < 2 || index >= count) return 0.0;
    const double last = static_cast<double>(count - 1), at = static_cast<double>(index);
    const double off = 2.0 * at < last ? last - 2.0 * at : 2.0 * at - last;  // from the middle: 0 or 1 up to `last`
    const double least = count % 2 == 0 ? 1.0 : 0.0;
    const double outwards = last > least ? (off - least) / (last - least) : 0.0;
    switch (order) {
    case letter_order::forward: return at / last;
    case letter_order::reverse: return (last - at) / last;
    case letter_order::from_centre: return outwards;
    case letter_order::to_centre: break;
    }
    return last > least ? 1.0 - outwards : 0.0;
}

/// How far a letter's own motion has come, from 0 to 1, if letters start one after another.
///
///     turn     from turn_of()
///     time     of the whole: at 0 the first letter starts, and at 1 the last one arrives
///     share    the part of the whole time that each letter takes, above 0 up to 1; at 1 all move at once
[[nodiscard]] constexpr double progress_of(double turn, double time, double share = 0.5) noexcept
{
    const double own = (time - turn * (1.0 - share)) / share;
    return own > 0.0 ? (own < 1.0 ? own : 1.0) : 0.0;
}

/// The map that hides a letter: all its triangles shrink to one point, its pivot.
[[nodiscard]] constexpr affine3 hidden_at(vec3 pivot) noexcept { return {{}, {}, {}, pivot}; }

/// Shows a part of the text and moves nothing: shown letters are written bit for bit as without a motion.
///
///     reveal{.share = t}                                  a growing part of the text, spaces included
///     reveal{.graphemes = 5}                              the first five graphemes, in reading order
///     reveal{.share = t, .order = letter_order::reverse}
///
/// A letter of several graphemes (ligatures, joined scripts) is shown once all of them are. An underline is shown once
/// all letters above it are.
struct reveal {
    static constexpr std::uint32_t by_share = 0xFFFF'FFFFu;

    double share = 1.0;                  ///< from 0 to 1; of all graphemes of the text, rounded down
    std::uint32_t graphemes = by_share;  ///< their number, instead of a share
    letter_order order = letter_order::forward;

    [[nodiscard]] affine3 operator()(const letter_place& l) const noexcept
    {
        const double all = static_cast<double>(l.graphemes);
        double count = static_cast<double>(graphemes);
        if (graphemes == by_share) count = share > 0.0 ? std::floor(all * (share < 1.0 ? share : 1.0)) : 0.0;
        const double first = static_cast<double>(l.letter.grapheme);
        const double last = static_cast<double>(l.letter.grapheme_end);
        return shows(first, last, all, count) ? affine3{} : hidden_at(l.letter.pivot);
    }

private:
    [[nodiscard]] bool shows(double first, double last, double all, double count) const noexcept
    {
        switch (order) {
        case letter_order::forward: return last <= count;
        case letter_order::reverse: return all - first <= count;
        case letter_order::from_centre: return 2.0 * first >= all - count && 2.0 * last <= all + count;
        case letter_order::to_centre: break;
        }
        return count >= all || 2.0 * last <= count || 2.0 * (all - first) <= count;
    }
};

/// Letters go up and down like a wave that runs along the text. Bars stay.
struct letter_wave {
    float height = 0.1f;   ///< of a crest above the baseline, in the output's unit
    double letters = 8.0;  ///< the length of the wave; not 0
    double time = 0.0;     ///< in periods

    [[nodiscard]] affine3 operator()(const letter_place& l) const noexcept
    {
        if (l.is_bar()) return {};
        const double periods = static_cast<double>(l.index) / letters - time;
        const auto up = static_cast<float>(as_double(height) * std::sin(6.283185307179586 * periods));
        return shifted(l.frame(0.0f, up, 0.0f));
    }
};

/// Letters fly apart, each in a direction of its own and turning, as a seed decides; at amount 0 nothing moves. Equal
/// seeds give equal motions. Bars move, too.
struct letter_scatter {
    std::uint32_t seed = 1;
    float distance = 1.0f;  ///< the greatest one, in the output's unit
    double turns = 0.5;     ///< the greatest turn about the pivot, in whole turns
    double amount = 1.0;    ///< from 0, nothing, to 1, everything

    [[nodiscard]] affine3 operator()(const letter_place& l) const noexcept
    {
        std::uint32_t state = seed * 0x9E37'79B1u + (l.is_bar() ? 0x8000'0000u + l.letter.line : l.index);
        const auto next = [&state]() noexcept {  // from -1 to 1; from C. Wellons, "Prospecting for hash functions"
            state += 0x6C07'8965u;
            std::uint32_t x = state;
            x = (x ^ (x >> 16)) * 0x7FEB'352Du;
            x = (x ^ (x >> 15)) * 0x846C'A68Bu;
            return static_cast<double>(x ^ (x >> 16)) / 2147483647.5 - 1.0;
        };
        double x = next(), y = next(), z = next();
        const double length = std::sqrt(x * x + y * y + z * z);
        const double distant = as_double(distance) * amount * (next() + 1.0) / (length > 1.0 ? 2.0 * length : 2.0);
        const double angle = 6.283185307179586 * turns * amount * next();
        affine3 map = turned(l.frame(0.0f, 0.0f, 1.0f), angle);
        if (!(angle > 0.0) && !(angle < 0.0)) map = {};
        x *= distant;
        y *= distant;
        z *= distant;
        map.origin = l.frame(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
        return map.about(l.letter.pivot);
    }
};

static_assert(letter_motion<reveal> && letter_motion<letter_wave> && letter_motion<letter_scatter>);

}  // namespace typemesh::inline TYPEMESH_ABI
