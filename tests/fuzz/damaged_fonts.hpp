// SPDX-License-Identifier: MIT
#pragma once

#include "../support/font_path.hpp"
#include "values.hpp"

#include <typemesh/core/glyph_id.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fuzz {

/// Installed fonts, read once: TrueType, CFF, variable, coloured. From TYPEMESH_FONT_DIR, or Debian's folder.
inline const std::vector<std::vector<std::byte>>& whole_fonts()
{
    static const std::vector<std::vector<std::byte>> all = [] {
        std::vector<std::vector<std::byte>> read;
        for (const char* name :
             {"truetype/liberation/LiberationMono-Regular.ttf", "opentype/comic-neue/ComicNeue-Regular.otf",
              "truetype/lohit-devanagari/Lohit-Devanagari.ttf", "truetype/inter-vf/Inter-roman.var.ttf",
              "opentype/fonts-hosny-amiri/AmiriQuranColored.ttf"}) {
            std::ifstream in{font_path(name), std::ios::binary};
            const std::string bytes{std::istreambuf_iterator<char>{in}, {}};
            const auto* first = reinterpret_cast<const std::byte*>(bytes.data());
            if (!bytes.empty()) read.emplace_back(first, first + bytes.size());
        }
        return read;
    }();
    return all;
}

/// The places of things in a font's bytes. Even in a damaged font every answer is usable.
class font_places {
public:
    struct place {
        std::size_t at = 0, size = 0;
    };

    explicit font_places(std::span<const std::byte> font) noexcept : font_{font} {}

    [[nodiscard]] std::uint32_t glyph_count() const noexcept
    {
        return (std::max)(1u, static_cast<std::uint32_t>(number(table("maxp").at + 4, 2)));
    }
    [[nodiscard]] place directory() const noexcept { return {0, 12 + 16 * number(4, 2)}; }

    [[nodiscard]] place table(std::size_t which) const noexcept
    {
        const std::size_t tables = number(4, 2), entry = 12 + 16 * (tables == 0 ? 0 : which % tables);
        return {number(entry + 8, 4), number(entry + 12, 4)};
    }
    [[nodiscard]] place table(std::string_view tag) const noexcept
    {
        for (std::size_t k = 0; k < number(4, 2); ++k) {
            std::size_t same = 0;
            while (same < 4 && number(12 + 16 * k + same, 1) == static_cast<unsigned char>(tag[same])) ++same;
            if (same == 4) return table(k);
        }
        return {};
    }

    /// A glyph's points (glyf) or its charstring (CFF).
    [[nodiscard]] place outline_of(std::uint32_t id) const noexcept
    {
        const place glyf = table("glyf"), loca = table("loca"), cff = table("CFF ");
        if (glyf.size == 0) return cff.size == 0 ? place{} : in_index(char_strings(cff.at), id);
        const bool is_long = number(table("head").at + 50, 2) != 0;
        const auto offset = [&](std::size_t i) {
            return is_long ? number(loca.at + 4 * i, 4) : 2 * number(loca.at + 2 * i, 2);
        };
        return {glyf.at + offset(id), offset(id + 1) - offset(id)};
    }

private:
    [[nodiscard]] std::size_t number(std::size_t at, std::size_t bytes) const noexcept
    {
        std::size_t sum = 0;
        for (std::size_t i = at; i < at + bytes; ++i)
            sum = sum << 8 | (i < font_.size() ? std::to_integer<std::size_t>(font_[i]) : 0);
        return sum;
    }

    /// Object `which` of CFF's INDEX at a place; the place after it for `which` = count.
    [[nodiscard]] place in_index(std::size_t index, std::size_t which) const noexcept
    {
        const std::size_t count = number(index, 2), width = number(index + 2, 1);
        if (count == 0) return {index + 2, 0};
        const auto offset = [&](std::size_t i) { return number(index + 3 + i * width, width); };
        const std::size_t data = index + 2 + (count + 1) * width;
        if (which >= count) return {data + offset(count), 0};
        return {data + offset(which), offset(which + 1) - offset(which)};
    }
    [[nodiscard]] std::size_t after(std::size_t index) const noexcept { return in_index(index, 0x10000).at; }

    /// The place of CFF's charstrings: operator 17 of its Top DICT, with its usual operand of 3 or 5 bytes.
    [[nodiscard]] std::size_t char_strings(std::size_t cff) const noexcept
    {
        const place top = in_index(after(cff + number(cff + 2, 1)), 0);
        for (std::size_t i = top.at, operand = 0; i < top.at + (std::min)(top.size, std::size_t{1000});) {
            const std::size_t b = number(i, 1);
            if (b == 17) return cff + operand;
            if (b == 28) operand = number(i + 1, 2);
            if (b == 29) operand = number(i + 1, 4);
            std::size_t next = i + (b == 28 ? 3u : b == 29 ? 5u : b == 12 || b >= 247 ? 2u : 1u);
            if (b == 30)
                while (next < top.at + top.size && (number(next++, 1) & 0xF) != 0xF) {
                }
            i = next;
        }
        return cff;
    }

    std::span<const std::byte> font_;
};

/// A copy of a font with up to 15 damaged places: two bytes become an extreme number, or up to 64 become equal. Some
/// copies are cut short. And the glyphs whose outlines were changed, if any.
struct damaged_font {
    std::vector<std::byte> bytes;
    std::vector<typemesh::glyph_id> glyphs;

    damaged_font(values& in, std::span<const std::byte> whole) : bytes(whole.begin(), whole.end())
    {
        const font_places places{whole};
        const std::uint32_t how = in.byte(), count = places.glyph_count();
        if ((how & 16) != 0)
            for (std::uint32_t left = 1 + in.below(3); left > 0; --left) glyphs.push_back(in.bits(2) % count);
        for (std::uint32_t left = how & 15; left > 0; --left) {
            const std::uint32_t which = in.byte();
            if (which < 160 && !glyphs.empty())
                damage(in, places.outline_of(glyphs[which % glyphs.size()]), 2);
            else
                damage(in, which == 255 ? places.directory() : places.table(which), 3);
        }
        if ((how & 0xE0) == 0xE0) bytes.resize(in.bits(3) % bytes.size());
        bytes.shrink_to_fit();
    }

private:
    /// The first bytes, which count and point, are changed more often than the others.
    void damage(values& in, font_places::place where, unsigned offset_bytes)
    {
        constexpr std::uint32_t extremes[] = {0x0000, 0xFFFF, 0x7FFF, 0x8000};
        const std::uint32_t way = in.byte(), number = extremes[way & 3];
        const std::size_t size =
            (std::max)(std::size_t{1}, (way & 16) != 0 ? (std::min)(where.size, std::size_t{32}) : where.size);
        const std::size_t i = where.at + in.bits((way & 16) != 0 ? 1 : offset_bytes) % size;
        const std::size_t count = (way & 8) != 0 ? std::size_t{1} + in.below(64) : 1;
        if (i + count >= bytes.size()) return;
        if ((way & 4) != 0) {
            bytes[i] = static_cast<std::byte>(number >> 8);
            bytes[i + 1] = static_cast<std::byte>(number & 0xFF);
        } else {
            std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(i), count, static_cast<std::byte>(in.byte()));
        }
    }
};

}  // namespace fuzz
