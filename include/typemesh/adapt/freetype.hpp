// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/plain_text.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/outline/font_options.hpp>
#include <typemesh/outline/impl/variation_key.hpp>
#include <typemesh/outline/outline_source.hpp>
#include <typemesh/unicode/utf.hpp>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_ADVANCES_H
#include FT_MULTIPLE_MASTERS_H
#include FT_OUTLINE_H
#include FT_SIZES_H
#include FT_TRUETYPE_TABLES_H

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// A font through FreeType (2.9 or later): outlines of every format that FreeType opens (TrueType, CFF, CFF2, Type 1,
/// ...), and a plain shaper for simple text: character map, advances and kerning.
///
///     auto font = freetype_font::open("NimbusSans-Regular.t1");
///     if (!font) return puts(font.error().message());
///
/// Without a given variation, a Type 1 Multiple Master font draws as FreeType opens it: with the default weights that
/// the font gives its masters (/WeightVector). FreeType's default design coordinates approximate these weights as
/// closely as axes can. As soon as one axis is set, all axes that are not named get these coordinates.
///
/// The shaper cannot set complex scripts and reports them (error::needs_shaping). It has no ligatures and no features
/// except "kern", and reads only the old 'kern' table. Modern fonts keep their kerning in GPOS, which HarfBuzz reads.
///
/// Move-only. The font and its FT_Library are used by one thread at a time.
class freetype_font {
public:
    /// Opens a font file. Without a `library`, the font makes its own; the caller's library must outlive the font.
    ///
    /// Fails  error::unreadable_file, not_a_font, no_such_face (count = the number of faces), no_outlines,
    ///        unknown_variation, bad_option (a variation is NaN or infinite), out_of_memory,
    ///        font_library_failed (count = FreeType's own number)
    static result<freetype_font> open(const char* path, const font_options& options = {},
                                      FT_Library library = nullptr) noexcept
    {
        TYPEMESH_ASSERT(path != nullptr, "a font was opened without a path");
        FT_Open_Args from = {};
        from.flags = FT_OPEN_PATHNAME;
        from.pathname = const_cast<char*>(path);  // FreeType only reads it
        return open_face(from, options, library);
    }
    /// Opens a font file whose path is a std::string, or any other type with a c_str().
    template <class Path>
        requires requires(const Path& path) { static_cast<const char*>(path.c_str()); }
    static result<freetype_font> open(const Path& path, const font_options& options = {},
                                      FT_Library library = nullptr) noexcept
    {
        return open(static_cast<const char*>(path.c_str()), options, library);
    }

    /// Opens a font in memory. Nothing is copied: the bytes must outlive the font. Fails as the other open() does,
    /// except for unreadable_file; error::too_large if there are more bytes than FreeType can count.
    static result<freetype_font> open(std::span<const std::byte> bytes, const font_options& options = {},
                                      FT_Library library = nullptr) noexcept
    {
        if (bytes.empty()) return error::not_a_font;
        if (bytes.size() > static_cast<std::size_t>((std::numeric_limits<FT_Long>::max)())) return error::too_large;
        FT_Open_Args from = {};
        from.flags = FT_OPEN_MEMORY;
        from.memory_base = static_cast<const FT_Byte*>(static_cast<const void*>(bytes.data()));
        from.memory_size = static_cast<FT_Long>(bytes.size());
        return open_face(from, options, library);
    }

    /// Wraps a face that the caller has opened, with its variations and its character map. The font holds a reference
    /// to the face; the face's library must outlive the font. The font's own size object is active only during calls.
    /// The caller's size, transform and character map do not change; the contents of the glyph slot do.
    ///
    /// Fails  error::no_outlines, out_of_memory, font_library_failed
    static result<freetype_font> wrap(FT_Face face) noexcept
    {
        TYPEMESH_ASSERT(face != nullptr, "a null FT_Face was wrapped");
        if (!FT_IS_SCALABLE(face)) return error::no_outlines;
        if (const FT_Error code = FT_Reference_Face(face)) return error_of(code);
        freetype_font made;
        made.face_ = face;
        const FT_Size callers = face->size;
        if (const FT_Error code = FT_New_Size(face, &made.own_size_)) return error_of(code);
        error e = made.finish(made.own_size_);
        if (callers != nullptr) FT_Activate_Size(callers);
        if (e) return e;
        return result<freetype_font>{std::move(made)};
    }

    freetype_font(freetype_font&& other) noexcept { swap(other); }
    freetype_font& operator=(freetype_font&& other) noexcept
    {
        swap(other);
        return *this;
    }
    ~freetype_font()
    {
        if (own_size_ != nullptr) FT_Done_Size(own_size_);
        if (face_ != nullptr) FT_Done_Face(face_);
        if (own_library_ != nullptr) FT_Done_FreeType(own_library_);
    }

    /// FreeType's own object, still owned by this one.
    [[nodiscard]] FT_Face handle() const noexcept { return face_; }

    [[nodiscard]] double units_per_em() const noexcept { return face_->units_per_EM; }
    [[nodiscard]] fill_rule fill() const noexcept { return fill_rule::non_zero; }

    /// The number of glyphs in the face; their ids count from 0.
    [[nodiscard]] std::uint32_t glyph_count() const noexcept { return static_cast<std::uint32_t>(face_->num_glyphs); }

    /// See outline_source. Covers the font (by the checksum in its 'head' table, its number of glyphs and its face
    /// index) and its axes.
    [[nodiscard]] std::uint64_t variation_key() const noexcept
    {
        auto key = static_cast<std::uint64_t>(face_->face_index);
        if (const auto* head = static_cast<const TT_Header*>(FT_Get_Sfnt_Table(face_, FT_SFNT_HEAD)))
            key = mixed_key(key, static_cast<std::uint64_t>(head->CheckSum_Adjust) & 0xFFFF'FFFFu);
        key = mixed_key(key, glyph_count());
        FT_Fixed axes[64] = {};
        if (!FT_HAS_MULTIPLE_MASTERS(face_) || FT_Get_Var_Blend_Coordinates(face_, 64, axes)) return key;
        for (const FT_Fixed axis : axes) key = mixed_key(key, static_cast<std::uint64_t>(axis));
#if FREETYPE_MAJOR * 100 + FREETYPE_MINOR >= 210
        FT_Fixed weights[16] = {};  // Type 1 fonts open with master weights that axes may be unable to produce
        FT_UInt masters = 16;
        if (FT_Get_MM_WeightVector(face_, &masters, weights)) return key;
        for (const FT_Fixed weight : weights) key = mixed_key(key, static_cast<std::uint64_t>(weight));
#endif
        return key;
    }

    /// See outline_source. Curves keep their degree: quadratics from TrueType, cubics from CFF and Type 1. Outlines are
    /// never hinted.
    ///
    /// Glyphs are loaded at a size where FreeType's 26.6 fixed point is 1/64 unit, because FT_LOAD_NO_SCALE would round
    /// varied and transformed (composite) points to whole units. FreeType (2.12) itself still rounds in two cases where
    /// HarfBuzz does not: CFF outlines with fractions and the positions of a varied glyph's components are rounded down
    /// to whole units.
    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        if (id >= glyph_count()) return error{error::unknown_glyph}.at(id, no_cluster);
        const active_size ours{face_, size_};
        constexpr FT_Int32 flags = FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP | FT_LOAD_IGNORE_TRANSFORM;
        if (const FT_Error code = FT_Load_Glyph(face_, id, flags)) {
            const error e = error_of(code);
            return (e == error::out_of_memory ? e : error{error::unknown_glyph}).at(id, no_cluster);
        }
        const FT_GlyphSlot slot = face_->glyph;
        if (slot->format != FT_GLYPH_FORMAT_OUTLINE) return error{error::unknown_glyph}.at(id, no_cluster);
        pen<Sink> to{sink};
        if (FT_Outline_Decompose(&slot->outline, &calls_of<Sink>, &to))
            return error{error::unknown_glyph}.at(id, no_cluster);
        if (to.open) sink.close();
        return {};
    }

    /// See shaper. Columns extend half an em to each side.
    [[nodiscard]] line_metrics metrics(direction d) const noexcept
    {
        if (d == direction::top_to_bottom) return {units_per_em() / 2, -units_per_em() / 2, 0.0};
        const double ascender = face_->ascender, descender = face_->descender;
        return {ascender, descender, face_->height - (ascender - descender)};
    }

    /// See shaper. Only for text of plain characters (plain_text.hpp) that is read to the right. Language, script,
    /// ligatures and features are ignored, except that {"kern", 0} turns kerning off; the last "kern" in the list
    /// counts. Default-ignorable characters have no glyph.
    ///
    /// Also fails with  error::needs_shaping: a character of a complex script (`cluster`), or another direction
    error shape(text_view text, const text_item& item, const shape_options& options,
                buffer<shaped_glyph>& glyphs) noexcept
    {
        TYPEMESH_ASSERT(item.first <= item.last && item.last <= text.size(),
                        "a shaper was given a range outside its text");
        if (item.to_the_left() || item.orientation != glyph_orientation::horizontal)
            return error{error::needs_shaping}.at(no_glyph, item.first);
        bool kerning = FT_HAS_KERNING(face_);
        for (const feature& f : options.features)
            if (f.tag[0] == 'k' && f.tag[1] == 'e' && f.tag[2] == 'r' && f.tag[3] == 'n')
                kerning = FT_HAS_KERNING(face_) && f.value != 0;

        FT_UInt before = 0;
        for (std::size_t i = item.first; i < item.last;) {
            const code_point c = decode(text, i, item.last);
            const auto cluster = static_cast<cluster_id>(i);
            i = c.next;
            if (is_complex(c.value)) return error{error::needs_shaping}.at(no_glyph, cluster);
            if (is_default_ignorable(c.value)) continue;

            const FT_UInt id = FT_Get_Char_Index(face_, c.value);
            FT_Vector kern = {};
            if (kerning && before != 0 && id != 0 && FT_Get_Kerning(face_, before, id, FT_KERNING_UNSCALED, &kern) == 0)
                glyphs.back().advance += static_cast<double>(kern.x);
            FT_Fixed advance = 0;
            if (FT_Get_Advance(face_, id, FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING | FT_LOAD_IGNORE_TRANSFORM, &advance) !=
                0)
                advance = 0;
            const glyph_flags flags = (id == 0 ? glyph_flags::missing : glyph_flags::none) |
                                      (kerning && before != 0 ? glyph_flags::unsafe_to_break : glyph_flags::none);
            if (!glyphs.push_back({id, cluster, static_cast<double>(advance), {}, 0, flags}))
                return error::out_of_memory;
            before = id;
        }
        return {};
    }

private:
    /// Makes the font's size the face's active size during this object's lifetime.
    class active_size {
    public:
        active_size(FT_Face face, FT_Size ours) noexcept : callers_{face->size}
        {
            if (callers_ == ours)
                callers_ = nullptr;
            else
                FT_Activate_Size(ours);
        }
        active_size(const active_size&) = delete;
        active_size& operator=(const active_size&) = delete;
        ~active_size()
        {
            if (callers_ != nullptr) FT_Activate_Size(callers_);
        }

    private:
        FT_Size callers_;
    };

    /// One bit more than 26.6, so that TrueType's implied points half-way between two others are exact.
    static constexpr int more_bits = 1;

    template <class Sink>
    struct pen {
        Sink& sink;
        bool open = false;

        static pen& from(void* data) noexcept { return *static_cast<pen*>(data); }
        static point place(const FT_Vector* v) noexcept
        {
            constexpr double unit = 1.0 / (64 << more_bits);
            return {unit * static_cast<double>(v->x), unit * static_cast<double>(v->y)};
        }

        static int move(const FT_Vector* p, void* data) noexcept
        {
            if (from(data).open) from(data).sink.close();
            from(data).open = true;
            from(data).sink.move(place(p));
            return 0;
        }
        static int line(const FT_Vector* p, void* data) noexcept
        {
            from(data).sink.line(place(p));
            return 0;
        }
        static int quadratic(const FT_Vector* control, const FT_Vector* p, void* data) noexcept
        {
            from(data).sink.quadratic(place(control), place(p));
            return 0;
        }
        static int cubic(const FT_Vector* control1, const FT_Vector* control2, const FT_Vector* p, void* data) noexcept
        {
            from(data).sink.cubic(place(control1), place(control2), place(p));
            return 0;
        }
    };

    template <class Sink>
    static constexpr FT_Outline_Funcs calls_of{&pen<Sink>::move,  &pen<Sink>::line, &pen<Sink>::quadratic,
                                               &pen<Sink>::cubic, more_bits,        0};

    freetype_font() noexcept = default;

    void swap(freetype_font& other) noexcept
    {
        std::swap(own_library_, other.own_library_);
        std::swap(own_size_, other.own_size_);
        std::swap(face_, other.face_);
        std::swap(size_, other.size_);
    }

    static error error_of(FT_Error code) noexcept
    {
        const int base = FT_ERROR_BASE(code);
        if (base == FT_Err_Out_Of_Memory) return error::out_of_memory;
        if (base == FT_Err_Cannot_Open_Resource || base == FT_Err_Cannot_Open_Stream) return error::unreadable_file;
        // Invalid requests and handles; every other code means that the data is damaged or unknown.
        const bool request = base == FT_Err_Invalid_Argument || base == FT_Err_Unimplemented_Feature ||
                             base == FT_Err_Missing_Module ||
                             (base >= FT_Err_Invalid_Handle && base < FT_Err_Out_Of_Memory);
        return request ? error{error::font_library_failed, static_cast<std::uint64_t>(base)} : error{error::not_a_font};
    }

    static result<freetype_font> open_face(const FT_Open_Args& from, const font_options& options,
                                           FT_Library library) noexcept
    {
        freetype_font made;
        if (library == nullptr) {
            if (const FT_Error code = FT_Init_FreeType(&made.own_library_)) return error_of(code);
            library = made.own_library_;
        }
        if (const FT_Error code =
                FT_Open_Face(library, &from, static_cast<FT_Long>(options.face & 0xFFFFu), &made.face_)) {
            made.face_ = nullptr;
            const error e = error_of(code);
            if (options.face == 0 || e == error::unreadable_file || e == error::out_of_memory) return e;
            // The face index may be the error: with index -1 FreeType counts the faces.
            FT_Face counted = nullptr;
            if (FT_Open_Face(library, &from, -1, &counted)) return e;
            const auto faces = static_cast<std::uint64_t>(counted->num_faces);
            FT_Done_Face(counted);
            return options.face >= faces ? error{error::no_such_face, faces} : e;
        }
        // The upper half of FreeType's face index names an instance, which was not requested.
        if (options.face != 0 && options.face >= static_cast<std::uint64_t>(made.face_->num_faces))
            return error{error::no_such_face, static_cast<std::uint64_t>(made.face_->num_faces)};
        if (!FT_IS_SCALABLE(made.face_)) return error::no_outlines;
        if (error e = made.vary(options.variations)) return e;
        if (error e = made.finish(made.face_->size)) return e;
        return result<freetype_font>{std::move(made)};
    }

    error vary(std::span<const variation> wanted) noexcept
    {
        if (wanted.empty()) return {};
        for (const variation& v : wanted)
            if (!is_finite(as_double(v.value))) return error::bad("variations");
        FT_MM_Var* axes = nullptr;
        if (!FT_HAS_MULTIPLE_MASTERS(face_) || FT_Get_MM_Var(face_, &axes)) return error::no_axis(wanted[0].tag);

        error trouble;
        buffer<FT_Fixed> at;
        FT_Fixed* values = at.append(axes->num_axis);
        if (values == nullptr) trouble = error::out_of_memory;
        for (FT_UInt i = 0; i < axes->num_axis && !trouble; ++i) values[i] = axes->axis[i].def;
        for (const variation& v : wanted) {
            if (trouble) break;
            FT_UInt i = 0;
            while (i < axes->num_axis && axes->axis[i].tag != tag_of(v.tag)) ++i;
            if (i == axes->num_axis)
                trouble = error::no_axis(v.tag);
            else
                values[i] = bounded(as_double(v.value), axes->axis[i].minimum, axes->axis[i].maximum);
        }
        if (!trouble)
            if (const FT_Error code = FT_Set_Var_Design_Coordinates(face_, axes->num_axis, values))
                trouble = error_of(code);
        FT_Done_MM_Var(face_->glyph->library, axes);
        return trouble;
    }

    static FT_ULong tag_of(const char (&tag)[5]) noexcept
    {
        FT_ULong made = 0;
        bool ended = false;
        for (int i = 0; i < 4; ++i) {
            ended = ended || tag[i] == '\0';
            made = made << 8 | (ended ? FT_ULong{' '} : static_cast<unsigned char>(tag[i]));
        }
        return made;
    }

    /// An axis's value in 16.16, clamped to its range.
    static FT_Fixed bounded(double value, FT_Fixed lowest, FT_Fixed highest) noexcept
    {
        const double fixed = std::floor(value * 65536.0 + 0.5);
        if (fixed <= static_cast<double>(lowest)) return lowest;
        return fixed >= static_cast<double>(highest) ? highest : static_cast<FT_Fixed>(fixed);
    }

    /// Sets `size` so that one font unit is one pixel.
    error finish(FT_Size size) noexcept
    {
        if (face_->num_glyphs <= 0 || face_->units_per_EM == 0) return error::not_a_font;
        size_ = size;
        if (const FT_Error code = FT_Activate_Size(size_)) return error_of(code);
        if (const FT_Error code = FT_Set_Pixel_Sizes(face_, 0, face_->units_per_EM)) return error_of(code);
        return {};
    }

    FT_Library own_library_ = nullptr;
    FT_Size own_size_ = nullptr;
    FT_Face face_ = nullptr;
    FT_Size size_ = nullptr;
};

static_assert(outline_source<freetype_font> && shaper<freetype_font>);

}  // namespace typemesh::inline TYPEMESH_ABI
