// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/impl/harfbuzz_metrics.hpp>
#include <typemesh/adapt/impl/harfbuzz_shaping.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/ligature_carets.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/outline/font_options.hpp>
#include <typemesh/outline/impl/variation_key.hpp>
#include <typemesh/outline/outline_source.hpp>

#include <hb-ot.h>
#include <hb.h>

#include <cstddef>
#include <cstring>
#include <limits>
#include <utility>

// HB_LEAN, and with it HB_TINY, imply HB_NO_DRAW unless a configuration header of the project says otherwise. This is
// visible only if HarfBuzz is built with the same macros as this file; otherwise the linker misses hb_draw_funcs_create
// and hb_font_draw_glyph.
#if defined(HB_NO_DRAW) || \
    ((defined(HB_TINY) || defined(HB_LEAN)) && !defined(HB_CONFIG_OVERRIDE_H) && !defined(HB_CONFIG_OVERRIDE_LAST_H))
#error \
    "typemesh: this HarfBuzz is configured without outlines (HB_TINY, HB_LEAN or HB_NO_DRAW): build it with \
a HB_CONFIG_OVERRIDE_H that has `#undef HB_NO_DRAW`, or use freetype_font."
#endif

namespace typemesh::inline TYPEMESH_ABI {

/// A font through HarfBuzz (4.0 or later): shapes text of every script, and draws its outlines; FreeType is not needed.
///
///     auto font = harfbuzz_font::open("DejaVuSans.ttf");
///     if (!font) return puts(font.error().message());
///
/// Opens TrueType, OpenType (CFF, CFF2) and collections of them. Variations apply to outlines, advances and kerning.
/// Damaged glyphs that HarfBuzz cannot draw are blank: HarfBuzz does not distinguish them from a space.
///
/// Move-only. Used by one thread at a time. For another thread, make a second object of this font, wrap(font.handle()),
/// which shares all large data.
class harfbuzz_font {
    static_assert(HB_VERSION_ATLEAST(4, 0, 0), "typemesh needs HarfBuzz 4.0 or later, for its outlines");

public:
    /// Opens a font file, which must not change while the font lives: HarfBuzz maps it into memory.
    ///
    /// Fails  error::unreadable_file, not_a_font, no_such_face (count = the number of faces), no_outlines,
    ///        unknown_variation, bad_option (a variation is NaN or infinite), out_of_memory
    static result<harfbuzz_font> open(const char* path, const font_options& options = {}) noexcept
    {
        TYPEMESH_ASSERT(path != nullptr, "a font was opened without a path");
        hb_blob_t* blob = hb_blob_create_from_file_or_fail(path);
        if (blob == nullptr) return error::unreadable_file;
        return from_blob(blob, options);
    }
    /// Opens a font file whose path is a std::string, or any other type with a c_str().
    template <class Path>
        requires requires(const Path& path) { static_cast<const char*>(path.c_str()); }
    static result<harfbuzz_font> open(const Path& path, const font_options& options = {}) noexcept
    {
        return open(static_cast<const char*>(path.c_str()), options);
    }

    /// Opens a font in memory. Nothing is copied: the bytes must outlive the font and all objects that share its
    /// handle(). Fails as the other open() does, except for unreadable_file; error::too_large for 4 GiB and more.
    static result<harfbuzz_font> open(std::span<const std::byte> bytes, const font_options& options = {}) noexcept
    {
        if (bytes.size() > (std::numeric_limits<unsigned>::max)()) return error::too_large;
        const auto* data = static_cast<const char*>(static_cast<const void*>(bytes.data()));
        return from_blob(
            hb_blob_create(data, static_cast<unsigned>(bytes.size()), HB_MEMORY_MODE_READONLY, nullptr, nullptr),
            options);
    }

    /// Wraps a font that the caller has set up, of any scale (also one with y down), with its variations and its font
    /// functions. This object holds a reference to the font and does not change the font. If the caller changes the
    /// font, shape() and outline() use the changed font. A coarse scale rounds HarfBuzz's results; a scale of 64 times
    /// the units per em, or of 16.16 numbers, loses nothing.
    ///
    /// Fails  error::bad_option: its scale is zero
    static result<harfbuzz_font> wrap(hb_font_t* font) noexcept
    {
        TYPEMESH_ASSERT(font != nullptr, "a null hb_font_t* was wrapped");
        int x = 0, y = 0;
        hb_font_get_scale(font, &x, &y);
        if (x == 0 || y == 0) return error::bad("scale");
        return finished(harfbuzz_font{hb_font_reference(font)});
    }

    harfbuzz_font(harfbuzz_font&& other) noexcept { swap(other); }
    harfbuzz_font& operator=(harfbuzz_font&& other) noexcept
    {
        swap(other);
        return *this;
    }
    ~harfbuzz_font()
    {
        hb_draw_funcs_destroy(draw_);
        hb_font_destroy(font_);
    }

    /// HarfBuzz's own object, still owned by this one; hb_font_reference() keeps it longer.
    [[nodiscard]] hb_font_t* handle() const noexcept { return font_; }

    [[nodiscard]] double units_per_em() const noexcept { return units_per_em_; }
    [[nodiscard]] fill_rule fill() const noexcept { return fill_rule::non_zero; }

    /// The number of glyphs in the face; their ids count from 0.
    [[nodiscard]] std::uint32_t glyph_count() const noexcept { return glyph_count_; }

    /// See outline_source. Covers the font (by the checksum in its 'head' table, its number of glyphs and its face
    /// index) and its axes, but not other changes to a wrapped font, such as its slant.
    [[nodiscard]] std::uint64_t variation_key() const noexcept
    {
        unsigned count = 0;
        const int* axes = hb_font_get_var_coords_normalized(font_, &count);
        std::uint64_t key = fingerprint_;
        for (unsigned i = 0; i < count; ++i) key = mixed_key(key, static_cast<std::uint32_t>(axes[i]));
        return key;
    }

    /// See outline_source. Curves keep their degree: quadratics from TrueType, cubics from CFF.
    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        assert_not_moved();
        if (id >= glyph_count_) return error{error::unknown_glyph}.at(id, no_cluster);
        draw_with(&calls_of<Sink>);
        const point unit = unit_size();
        pen<Sink> to{sink, unit.x, unit.y};
#if HB_VERSION_ATLEAST(7, 0, 0)
        hb_font_draw_glyph(font_, id, draw_, &to);
#else
        hb_font_get_glyph_shape(font_, id, draw_, &to);
#endif
        return {};
    }

    /// See shaper. If the font has no vertical metrics, columns extend half an em to each side.
    [[nodiscard]] line_metrics metrics(direction d) const noexcept
    {
        assert_not_moved();
        const bool vertical = d == direction::top_to_bottom;
        hb_font_extents_t extents = {};
        hb_font_get_extents_for_direction(font_, vertical ? HB_DIRECTION_TTB : HB_DIRECTION_LTR, &extents);
        const double unit = vertical ? unit_size().x : unit_size().y;
        return {unit * extents.ascender, unit * extents.descender, unit * extents.line_gap};
    }

    /// See face_metrics.hpp.
    [[nodiscard]] face_metrics suggested_metrics() const noexcept { return detail::read_face_metrics(font_); }

    /// See ligature_carets.hpp. The face's number is ignored, because there is only one face.
    error ligature_carets(std::uint32_t, glyph_id id, bool down, buffer<double>& carets) const noexcept
    {
        return detail::append_ligature_carets(font_, unit_size(), id, down, carets);
    }

    /// See shaper. The text around the item, up to the next line break, is used as context: letters join across its
    /// ends.
    ///
    /// Also fails with  error::bad_option: options.script is not four letters
    ///                  error::bad_feature: a tag is not four printable ASCII characters
    ///                  error::too_large: more than 2^28 units in an item; error::font_library_failed
    error shape(text_view text, const text_item& item, const shape_options& options,
                buffer<shaped_glyph>& glyphs) noexcept
    {
        assert_not_moved();
        TYPEMESH_ASSERT(item.first <= item.last && item.last <= text.size(),
                        "a shaper was given a range outside its text");
        return shaping_.shape(font_, unit_size(), text, item, options, glyphs);
    }

    /// See shaper. Cost: the shaping of the character
    [[nodiscard]] bool has_vertical_form(char32_t c) noexcept { return shaping_.has_vertical_form(font_, c); }
    /// See shaper: the middle of the font's ideographs, or, if the font does not specify it, halfway between ascender
    /// and descender.
    [[nodiscard]] double column_middle() const noexcept { return shaping_.column_middle(font_, unit_size()); }

private:
    void assert_not_moved() const noexcept
    {
        TYPEMESH_ASSERT(font_ != nullptr, "this font was moved: give the new font to its meshers with use()");
    }

    /// HarfBuzz's callbacks for one type of sink. The address of this struct identifies the callbacks in use.
    struct draw_calls {
        hb_draw_move_to_func_t move;
        hb_draw_line_to_func_t line;
        hb_draw_quadratic_to_func_t quadratic;
        hb_draw_cubic_to_func_t cubic;
        hb_draw_close_path_func_t close;
    };

    template <class Sink>
    struct pen {
        Sink& sink;
        double x_unit, y_unit;  // font units per HarfBuzz unit

        static pen& from(void* data) noexcept { return *static_cast<pen*>(data); }
        [[nodiscard]] point place(float x, float y) const noexcept
        {
            return {x_unit * as_double(x), y_unit * as_double(y)};
        }

        static void move(hb_draw_funcs_t*, void* data, hb_draw_state_t*, float x, float y, void*) noexcept
        {
            from(data).sink.move(from(data).place(x, y));
        }
        static void line(hb_draw_funcs_t*, void* data, hb_draw_state_t*, float x, float y, void*) noexcept
        {
            from(data).sink.line(from(data).place(x, y));
        }
        static void quadratic(hb_draw_funcs_t*, void* data, hb_draw_state_t*, float cx, float cy, float x, float y,
                              void*) noexcept
        {
            from(data).sink.quadratic(from(data).place(cx, cy), from(data).place(x, y));
        }
        static void cubic(hb_draw_funcs_t*, void* data, hb_draw_state_t*, float ax, float ay, float bx, float by,
                          float x, float y, void*) noexcept
        {
            from(data).sink.cubic(from(data).place(ax, ay), from(data).place(bx, by), from(data).place(x, y));
        }
        static void close(hb_draw_funcs_t*, void* data, hb_draw_state_t*, void*) noexcept { from(data).sink.close(); }
    };

    template <class Sink>
    static constexpr draw_calls calls_of{&pen<Sink>::move, &pen<Sink>::line, &pen<Sink>::quadratic, &pen<Sink>::cubic,
                                         &pen<Sink>::close};

    /// Distinguishes fonts: any two files, and the faces of one file.
    static std::uint64_t fingerprint_of(hb_face_t* face) noexcept
    {
        std::uint64_t key = mixed_key(hb_face_get_index(face), hb_face_get_glyph_count(face));
        hb_blob_t* head = hb_face_reference_table(face, HB_TAG('h', 'e', 'a', 'd'));
        unsigned size = 0;
        const char* bytes = hb_blob_get_data(head, &size);
        for (unsigned i = 8; i < 12 && i < size; ++i)  // checkSumAdjustment, over the whole file
            key = mixed_key(key, static_cast<unsigned char>(bytes[i]));
        hb_blob_destroy(head);
        return key;
    }

    explicit harfbuzz_font(hb_font_t* owned) noexcept : font_{owned}, draw_{hb_draw_funcs_create()}
    {
        hb_face_t* face = hb_font_get_face(font_);
        units_per_em_ = hb_face_get_upem(face);
        glyph_count_ = hb_face_get_glyph_count(face);
        fingerprint_ = fingerprint_of(face);
    }

    void swap(harfbuzz_font& other) noexcept
    {
        std::swap(font_, other.font_);
        std::swap(draw_, other.draw_);
        std::swap(calls_, other.calls_);
        std::swap(shaping_, other.shaping_);
        std::swap(units_per_em_, other.units_per_em_);
        std::swap(glyph_count_, other.glyph_count_);
        std::swap(fingerprint_, other.fingerprint_);
    }

    static result<harfbuzz_font> finished(harfbuzz_font font) noexcept
    {
        if (error e = font.shaping_.open()) return e;
        // After a failed allocation HarfBuzz returns objects that cannot be changed.
        if (hb_draw_funcs_is_immutable(font.draw_)) return error::out_of_memory;
        return result<harfbuzz_font>{std::move(font)};
    }

    static result<harfbuzz_font> from_blob(hb_blob_t* blob, const font_options& options) noexcept
    {
        const unsigned faces = hb_face_count(blob);
        if (faces == 0 || options.face >= faces) {
            hb_blob_destroy(blob);
            return faces == 0 ? error{error::not_a_font} : error{error::no_such_face, faces};
        }
        hb_face_t* face = hb_face_create(blob, options.face);
        hb_blob_destroy(blob);  // the face has its own reference
        hb_font_t* font = hb_font_create(face);
        hb_face_destroy(face);
        harfbuzz_font made{font};

        if (made.glyph_count_ == 0) return error::not_a_font;
        if (!has_outlines(face)) return error::no_outlines;
        // A unit of HarfBuzz's integers is 1/64 font unit, so that varied advances and kerning keep their fractions.
        const int scale = static_cast<int>(hb_face_get_upem(face)) * 64;
        hb_font_set_scale(font, scale, scale);
        if (error e = made.vary(options.variations)) return e;
        hb_font_make_immutable(font);
        return finished(std::move(made));
    }

    /// A table of the face, held while it is read; empty if there is none.
    class table {
    public:
        table(hb_face_t* face, const char (&tag)[5]) noexcept
            : blob_{hb_face_reference_table(face, hb_tag_from_string(tag, 4))}
        {
            data_ = static_cast<const unsigned char*>(static_cast<const void*>(hb_blob_get_data(blob_, &size_)));
        }
        table(const table&) = delete;
        table& operator=(const table&) = delete;
        ~table() { hb_blob_destroy(blob_); }

        [[nodiscard]] unsigned size() const noexcept { return size_; }
        [[nodiscard]] bool same(unsigned a, unsigned b, unsigned bytes) const noexcept
        {
            return b + bytes <= size_ && std::memcmp(data_ + a, data_ + b, bytes) == 0;
        }
        [[nodiscard]] unsigned char operator[](unsigned i) const noexcept { return i < size_ ? data_[i] : 0; }

    private:
        hb_blob_t* blob_;
        const unsigned char* data_ = nullptr;
        unsigned size_ = 0;
    };

    /// Bitmap fonts may have a 'glyf' table as a formality, which contains only .notdef.
    static bool has_outlines(hb_face_t* face) noexcept
    {
        if (table{face, "CFF "}.size() != 0 || table{face, "CFF2"}.size() != 0) return true;
        if (table{face, "glyf"}.size() == 0) return false;
        if (table{face, "EBLC"}.size() == 0 && table{face, "CBLC"}.size() == 0 && table{face, "bloc"}.size() == 0)
            return true;

        const table head{face, "head"}, places{face, "loca"};
        const unsigned bytes = head[51] == 0 ? 2 : 4;  // per offset in 'loca', by head.indexToLocFormat
        for (unsigned i = bytes; i + 2 * bytes <= places.size(); i += bytes)
            if (!places.same(i, i + bytes, bytes)) return true;
        return false;
    }

    error vary(std::span<const variation> wanted) noexcept
    {
        if (wanted.empty()) return {};
        buffer<hb_variation_t> values;
        for (const variation& v : wanted) {
            if (!is_finite(as_double(v.value))) return error::bad("variations");
            const hb_variation_t value{hb_tag_from_string(v.tag, 4), v.value};
            hb_ot_var_axis_info_t axis;
            if (!hb_ot_var_find_axis_info(hb_font_get_face(font_), value.tag, &axis)) return error::no_axis(v.tag);
            if (!values.push_back(value)) return error::out_of_memory;
        }
        hb_font_set_variations(font_, values.data(), static_cast<unsigned>(values.size()));
        return {};
    }

    /// Font units per HarfBuzz unit.
    [[nodiscard]] point unit_size() const noexcept
    {
        int x = 0, y = 0;
        hb_font_get_scale(font_, &x, &y);
        return {units_per_em_ / x, units_per_em_ / y};
    }

    /// Sets callbacks only when the type of sink changes: one indirect call per segment, and no allocation.
    void draw_with(const draw_calls* calls) noexcept
    {
        if (calls == calls_) return;
        hb_draw_funcs_set_move_to_func(draw_, calls->move, nullptr, nullptr);
        hb_draw_funcs_set_line_to_func(draw_, calls->line, nullptr, nullptr);
        hb_draw_funcs_set_quadratic_to_func(draw_, calls->quadratic, nullptr, nullptr);
        hb_draw_funcs_set_cubic_to_func(draw_, calls->cubic, nullptr, nullptr);
        hb_draw_funcs_set_close_path_func(draw_, calls->close, nullptr, nullptr);
        calls_ = calls;
    }

    hb_font_t* font_ = nullptr;
    hb_draw_funcs_t* draw_ = nullptr;
    const draw_calls* calls_ = nullptr;
    double units_per_em_ = 1000.0;
    std::uint32_t glyph_count_ = 0;
    std::uint64_t fingerprint_ = 0;
    detail::harfbuzz_shaping shaping_;
};

static_assert(outline_source<harfbuzz_font> && shaper<harfbuzz_font>);
static_assert(has_ligature_carets<harfbuzz_font>);

}  // namespace typemesh::inline TYPEMESH_ABI
