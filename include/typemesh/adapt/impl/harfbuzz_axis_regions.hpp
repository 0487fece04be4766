// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>

#include <hb-ot.h>
#include <hb.h>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The bytes of one table of a face, big-endian. Reading past its end gives zeros.
class font_table {
public:
    font_table(hb_face_t* face, hb_tag_t tag) noexcept : blob_{hb_face_reference_table(face, tag)}
    {
        bytes_ = static_cast<const unsigned char*>(static_cast<const void*>(hb_blob_get_data(blob_, &size_)));
    }
    font_table(const font_table&) = delete;
    font_table& operator=(const font_table&) = delete;
    ~font_table() { hb_blob_destroy(blob_); }

    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] std::uint32_t u8(std::size_t at) const noexcept { return at < size_ ? bytes_[at] : 0u; }
    [[nodiscard]] std::uint32_t u16(std::size_t at) const noexcept { return u8(at) << 8 | u8(at + 1); }
    [[nodiscard]] std::uint32_t u32(std::size_t at) const noexcept { return u16(at) << 16 | u16(at + 2); }
    [[nodiscard]] std::int32_t f2dot14(std::size_t at) const noexcept
    {
        const auto bits = static_cast<std::int32_t>(u16(at));
        return bits < 0x8000 ? bits : bits - 0x10000;
    }

private:
    hb_blob_t* blob_;
    const unsigned char* bytes_ = nullptr;
    unsigned size_ = 0;
};

/// Reads where the regions of a variable font begin, peak and end on one axis, and where its glyphs are replaced.
/// OpenType 1.9: gvar; ItemVariationStore in CFF2, GDEF, HVAR, VVAR and MVAR; FeatureVariations in GSUB and GPOS.
/// Damaged tables give wrong positions, but nothing is read outside of them. Each coordinate is appended once.
///
/// The influence of a region on one axis rises from its start to its peak and falls to its end, both evenly; on the
/// other axes it is constant here. So a list of all starts, peaks and ends is complete. If a region ends at its own
/// peak, its influence ends there abruptly, and the next coordinate is listed, too.
class harfbuzz_axis_regions {
public:
    harfbuzz_axis_regions(hb_face_t* face, std::uint32_t axis, buffer<std::int32_t>& out) noexcept
        : face_{face}, axis_{axis}, out_{out}
    {
    }

    static constexpr std::size_t max_coordinates = 1024;       ///< of masters, or of changes; fonts have a few dozen
    static constexpr std::uint32_t max_conditions = 1u << 16;  ///< of all features; fonts have a few hundred

    /// Fails  error::not_a_font: more coordinates, or more regions than a sound table has room for
    ///        error::out_of_memory
    /// Cost   proportional to the sizes of the tables
    error read_masters() noexcept
    {
        read_gvar();
        read_cff2();
        for (const auto& [tag, at, wide] :
             {stored{HB_TAG('G', 'D', 'E', 'F'), 14, true}, stored{HB_TAG('H', 'V', 'A', 'R'), 4, true},
              stored{HB_TAG('V', 'V', 'A', 'R'), 4, true}, stored{HB_TAG('M', 'V', 'A', 'R'), 10, false}}) {
            const font_table table{face_, tag};
            if (tag == HB_TAG('G', 'D', 'E', 'F') && table.u16(2) < 3) continue;
            const std::uint32_t store = wide ? table.u32(at) : table.u16(at);
            if (store != 0) read_store(table, store);
        }
        return failed_;
    }

    /// Fails  error::not_a_font: more coordinates or conditions; error::out_of_memory
    error read_changes() noexcept
    {
        read_conditions(HB_TAG('G', 'S', 'U', 'B'));
        read_conditions(HB_TAG('G', 'P', 'O', 'S'));
        return failed_;
    }

private:
    struct stored {
        hb_tag_t tag;
        std::size_t at;
        bool wide;
    };

    void put(std::int32_t c) noexcept
    {
        if (c < -0x4000 || c > 0x4000) return;
        const auto bit = static_cast<std::uint32_t>(c + 0x4000);
        if ((seen_[bit / 32] >> bit % 32 & 1u) != 0) return;  // the same regions come again and again
        seen_[bit / 32] |= 1u << bit % 32;
        if (count_++ == max_coordinates)
            failed_ = error::not_a_font;
        else if (!out_.push_back(c))
            failed_ = error::out_of_memory;
    }
    void put(std::int32_t start, std::int32_t peak, std::int32_t end) noexcept
    {
        if (peak == 0) return;  // it has no influence on this axis
        put(start);
        put(peak);
        put(end);
        if (start == peak) put(start - 1);
        if (end == peak) put(end + 1);
    }
    void put_peak(std::int32_t peak) noexcept { put(peak < 0 ? peak : 0, peak, peak > 0 ? peak : 0); }

    void read_gvar() noexcept
    {
        const font_table t{face_, HB_TAG('g', 'v', 'a', 'r')};
        const std::uint32_t axes = t.u16(4), shared = t.u16(6), glyphs = t.u16(12);
        const bool wide = (t.u16(14) & 1u) != 0;
        if (axis_ >= axes) return;
        for (std::uint32_t i = 0; i < shared; ++i)
            put_peak(t.f2dot14(std::size_t{t.u32(8)} + 2 * (std::size_t{i} * axes + axis_)));
        const auto place = [&](std::size_t i) noexcept {
            return std::size_t{t.u32(16)} + (wide ? t.u32(20 + 4 * i) : std::size_t{2} * t.u16(20 + 2 * i));
        };
        std::size_t tuples_left = t.size() / 4;  // each has at least four bytes
        for (std::uint32_t g = 0; g < glyphs && !failed_; ++g) {
            const std::size_t begin = place(g), end = place(std::size_t{g} + 1);
            const std::size_t count = begin < end ? t.u16(begin) & 0x0FFFu : 0u;
            if (count > tuples_left)
                failed_ = error::not_a_font;
            else
                read_tuples(t, begin, count, axes);
            tuples_left -= failed_ ? 0 : count;
        }
    }

    /// The regions of one glyph that are not shared with others.
    void read_tuples(const font_table& t, std::size_t begin, std::size_t count, std::size_t axes) noexcept
    {
        std::size_t at = begin + 4;
        for (std::size_t left = count; left > 0 && !failed_; --left) {
            const std::uint32_t index = t.u16(at + 2);
            at += 4;
            const bool own = (index & 0x8000u) != 0, between = (index & 0x4000u) != 0;
            const std::size_t shared = t.u32(8) + 2 * axes * (index & 0x0FFFu);
            const std::int32_t peak = t.f2dot14((own ? at : shared) + 2 * axis_);
            if (own) at += 2 * axes;
            if (!between) {
                if (own) put_peak(peak);
                continue;
            }
            put(t.f2dot14(at + 2 * axis_), peak, t.f2dot14(at + 2 * (axes + axis_)));
            at += 4 * axes;
        }
    }

    /// An ItemVariationStore.
    void read_store(const font_table& t, std::size_t store) noexcept
    {
        const std::size_t list = store + t.u32(store + 2);
        const std::size_t axes = t.u16(list), regions = t.u16(list + 2);
        if (axis_ >= axes) return;
        for (std::size_t r = 0; r < regions && !failed_; ++r) {
            const std::size_t at = list + 4 + 6 * (r * axes + axis_);
            put(t.f2dot14(at), t.f2dot14(at + 2), t.f2dot14(at + 4));
        }
    }

    /// The store of CFF2, which its top DICT names with operator 24.
    void read_cff2() noexcept
    {
        const font_table t{face_, HB_TAG('C', 'F', 'F', '2')};
        std::size_t at = t.u8(2);
        const std::size_t end = at + t.u16(3);
        for (std::uint32_t operand = 0; at < end && at < t.size();) {
            const std::uint32_t b = t.u8(at);
            if (b == 28) {
                operand = t.u16(at + 1);
                at += 3;
            } else if (b == 29) {
                operand = t.u32(at + 1);
                at += 5;
            } else if (b == 30) {  // a real number, which ends with a nibble of ones
                for (++at; at < end && (t.u8(at) & 0x0Fu) != 0x0Fu; ++at) continue;
                ++at;
            } else if (b >= 32) {
                operand = b < 247 ? b - 139 : ((b - 247) % 4 << 8) + t.u8(at + 1) + 108;
                at += b < 247 ? 1 : 2;
            } else {
                if (b == 24) read_store(t, std::size_t{operand} + 2);  // after its length
                at += b == 12 ? 2 : 1;
            }
        }
    }

    /// The conditions of FeatureVariations on this axis.
    void read_conditions(hb_tag_t tag) noexcept
    {
        const font_table t{face_, tag};
        if (t.u16(2) == 0) return;  // version 1.0 has none
        const std::size_t variations = t.u32(10);
        if (variations == 0) return;
        const std::size_t records = t.u32(variations + 4);
        for (std::size_t i = 0; i < records && variations + 8 + 8 * i < t.size() && !failed_; ++i) {
            const std::size_t set = variations + t.u32(variations + 8 + 8 * i);
            const std::size_t conditions = t.u16(set);
            for (std::size_t k = 0; k < conditions && !failed_; ++k) {
                if (conditions_left_-- == 0) {
                    failed_ = error::not_a_font;
                    return;
                }
                const std::size_t at = set + t.u32(set + 2 + 4 * k);
                if (t.u16(at) != 1 || t.u16(at + 2) != axis_) continue;
                put(t.f2dot14(at + 4));
                put(t.f2dot14(at + 6) + 1);
            }
        }
    }

    hb_face_t* face_;
    std::uint32_t axis_;
    buffer<std::int32_t>& out_;
    error failed_;
    std::uint32_t seen_[0x8001 / 32 + 1] = {};  // a bit for each coordinate
    std::size_t count_ = 0;
    std::uint32_t conditions_left_ = max_conditions;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
