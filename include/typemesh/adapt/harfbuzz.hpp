// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/layout/line_break.hpp>
#include <typemesh/layout/reading_order.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/outline/font_options.hpp>
#include <typemesh/outline/outline_source.hpp>
#include <typemesh/outline/variation_key.hpp>

#include <hb-ot.h>
#include <hb.h>

#include <cstddef>
#include <cstring>
#include <limits>
#include <utility>

namespace typemesh {

/// A font through HarfBuzz (4.0 or later): shapes text of every script, and draws its outlines; FreeType is not needed.
///
///     auto font = harfbuzz_font::open("DejaVuSans.ttf");
///     if (!font) return puts(font.error().message());
///
/// Opens TrueType, OpenType (CFF, CFF2) and collections of them. Variations apply to outlines, advances and kerning
/// alike. What a damaged font cannot draw comes out blank: HarfBuzz does not tell it from a space.
///
/// Move-only. Used from one thread at a time; for another thread make a second one of the same font,
/// wrap(font.handle()), which shares all that is large.
class harfbuzz_font {
    static_assert(HB_VERSION_ATLEAST(4, 0, 0), "typemesh needs HarfBuzz 4.0 or later, for its outlines");

public:
    /// Opens a font file, which must not change while the font lives: HarfBuzz maps it into memory.
    ///
    /// Fails  error::unreadable_file, not_a_font, no_such_face (count = how many faces there are), no_outlines,
    ///        unknown_variation, bad_option (a variation is NaN or infinite), out_of_memory
    static result<harfbuzz_font> open(const char* path, const font_options& options = {}) noexcept
    {
        TYPEMESH_ASSERT(path != nullptr, "a font was opened without a path");
        hb_blob_t* blob = hb_blob_create_from_file_or_fail(path);
        if (blob == nullptr) return error::unreadable_file;
        return from_blob(blob, options);
    }

    /// Opens a font in memory. Nothing is copied: the bytes must outlive the font and whatever shares its handle().
    /// Fails as the other open() does, but for unreadable_file; error::too_large for 4 GiB and more.
    static result<harfbuzz_font> open(std::span<const std::byte> bytes, const font_options& options = {}) noexcept
    {
        if (bytes.size() > (std::numeric_limits<unsigned>::max)()) return error::too_large;
        const auto* data = static_cast<const char*>(static_cast<const void*>(bytes.data()));
        return from_blob(
            hb_blob_create(data, static_cast<unsigned>(bytes.size()), HB_MEMORY_MODE_READONLY, nullptr, nullptr),
            options);
    }

    /// Takes a font that the caller has set up, of any scale (also one with y down), with its variations and its font
    /// functions. Holds its own reference and changes nothing in it; where the caller changes it, shape() and
    /// outline() follow. A coarse scale rounds what HarfBuzz answers: 64 times the units per em, or 16.16 numbers,
    /// lose nothing.
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
        hb_buffer_destroy(buffer_);
        hb_font_destroy(font_);
    }

    /// HarfBuzz's own object, still owned by this one; hb_font_reference() keeps it longer.
    [[nodiscard]] hb_font_t* handle() const noexcept { return font_; }

    [[nodiscard]] double units_per_em() const noexcept { return units_per_em_; }
    [[nodiscard]] fill_rule fill() const noexcept { return fill_rule::non_zero; }

    /// How many glyphs the face has; their ids count from 0.
    [[nodiscard]] std::uint32_t glyph_count() const noexcept { return glyph_count_; }

    /// See variation_key.hpp. Of the font (by the checksum in its 'head' table, its number of glyphs and its face's
    /// number) and its axes; not of what else the caller may change in a font that he wrapped, such as its slant.
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

    /// See shaper. Half an em to each side of a column where the font has no vertical metrics.
    [[nodiscard]] line_metrics metrics(direction d) const noexcept
    {
        const bool vertical = d == direction::top_to_bottom;
        hb_font_extents_t extents = {};
        hb_font_get_extents_for_direction(font_, vertical ? HB_DIRECTION_TTB : HB_DIRECTION_LTR, &extents);
        const double unit = vertical ? unit_size().x : unit_size().y;
        return {unit * extents.ascender, unit * extents.descender, unit * extents.line_gap};
    }

    /// See shaper. The text round text[first, last), up to the next line break, is read as context: a letter joins
    /// across it.
    ///
    /// The line is cut where the script changes and each piece shaped for its own script, unless options.script names
    /// one.
    ///
    /// direction::automatic takes the direction of the line's letters, else of options.script, else left-to-right. A
    /// direction that is asked for is obeyed where all letters of the line are read in one direction, even against
    /// that direction. A line with letters of both directions is error::mixed_direction (`cluster`: the first letter
    /// against the line's first); so is a right-to-left line with a number of several digits, which must be read the
    /// other way (`cluster`: its first digit). In columns everything goes down and nothing is mixed.
    ///
    /// Fails besides  error::bad_option: options.script is not four letters
    ///                error::bad_feature: a tag is not four printable ASCII characters
    ///                error::too_large: more than 2^28 units in a line; error::font_library_failed
    result<point> shape(text_view text, std::size_t first, std::size_t last, const shape_options& options,
                        glyph_run& run) noexcept
    {
        TYPEMESH_ASSERT(first <= last && last <= text.size(), "a shaper was given a place outside its text");
        if (last - first >= std::size_t{1} << 28) return error::too_large;

        const line_reading found = read_line(text, first, last);
        hb_script_t script = HB_SCRIPT_INVALID;
        if (!options.script.empty()) {
            script = hb_script_from_string(options.script.data(), options.script.size() == 4 ? 4 : 0);
            if (script == HB_SCRIPT_INVALID || script == HB_SCRIPT_UNKNOWN) return error::bad("script");
        }
        const auto direction = direction_of(found, options.direction, script);
        if (!direction) return direction.error();
        if (*direction == HB_DIRECTION_RTL) {
            const std::size_t number = find_number(text, first, last);
            if (number != line_reading::nowhere)
                return error{error::mixed_direction}.at(no_glyph, static_cast<cluster_id>(number));
        }
        if (error e = take_features(options.features)) return e;
        if (script == HB_SCRIPT_INVALID && found.only_ascii)
            script = found.to_the_right == line_reading::nowhere ? HB_SCRIPT_COMMON : HB_SCRIPT_LATIN;
        if (error e = cut_into_pieces(text, first, last, script)) return e;

        const hb_language_t language =
            options.language.empty()
                ? HB_LANGUAGE_INVALID
                : hb_language_from_string(options.language.data(), static_cast<int>(options.language.size()));
        point at;
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            const piece& p = pieces_[*direction == HB_DIRECTION_RTL ? pieces_.size() - 1 - k : k];
            fill_buffer(text, p, found.invalid.count != 0);
            hb_buffer_set_direction(buffer_, *direction);
            hb_buffer_set_script(buffer_, p.script);
            hb_buffer_set_language(buffer_, language);
            const auto shaped =
                hb_shape_full(font_, buffer_, features_.data(), static_cast<unsigned>(features_.size()), nullptr);
            if (!hb_buffer_allocation_successful(buffer_)) return error::out_of_memory;
            if (!shaped) return error::font_library_failed;
            if (error e = take_glyphs(at, run)) return e;
        }
        if (found.invalid.count != 0) {
            run.invalid_units += found.invalid.count;
            if (found.invalid.first < run.first_invalid_unit) run.first_invalid_unit = found.invalid.first;
        }
        return at;
    }

private:
    /// A stretch of a line in one script.
    struct piece {
        std::size_t first;
        std::size_t last;
        hb_script_t script;
    };

    /// HarfBuzz's callbacks for one type of sink; those in use are known by the table's address.
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
        double x_unit, y_unit;  // font units to one of HarfBuzz's

        static pen& from(void* data) noexcept { return *static_cast<pen*>(data); }
        [[nodiscard]] point place(float x, float y) const noexcept { return {x_unit * double{x}, y_unit * double{y}}; }

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

    /// By what fonts are told apart: any two files, and the faces of one.
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

    explicit harfbuzz_font(hb_font_t* owned) noexcept
        : font_{owned}, buffer_{hb_buffer_create()}, draw_{hb_draw_funcs_create()}
    {
        hb_face_t* face = hb_font_get_face(font_);
        units_per_em_ = hb_face_get_upem(face);
        glyph_count_ = hb_face_get_glyph_count(face);
        fingerprint_ = fingerprint_of(face);
    }

    void swap(harfbuzz_font& other) noexcept
    {
        std::swap(font_, other.font_);
        std::swap(buffer_, other.buffer_);
        std::swap(draw_, other.draw_);
        std::swap(calls_, other.calls_);
        std::swap(units_per_em_, other.units_per_em_);
        std::swap(glyph_count_, other.glyph_count_);
        std::swap(fingerprint_, other.fingerprint_);
        features_.swap(other.features_);
        pieces_.swap(other.pieces_);
    }

    static result<harfbuzz_font> finished(harfbuzz_font font) noexcept
    {
        // HarfBuzz answers a failed allocation with objects that cannot be changed.
        if (!hb_buffer_allocation_successful(font.buffer_) || hb_draw_funcs_is_immutable(font.draw_))
            return error::out_of_memory;
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
        // One of HarfBuzz's integers is 1/64 unit, so that varied advances and kerning keep their fractions.
        const int scale = static_cast<int>(hb_face_get_upem(face)) * 64;
        hb_font_set_scale(font, scale, scale);
        if (error e = made.vary(options.variations)) return e;
        hb_font_make_immutable(font);
        return finished(std::move(made));
    }

    /// A table of the face while it is looked at; empty where there is none.
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

    /// Fonts of bitmaps may carry a 'glyf' table for the sake of form, with nothing but .notdef in it.
    static bool has_outlines(hb_face_t* face) noexcept
    {
        if (table{face, "CFF "}.size() != 0 || table{face, "CFF2"}.size() != 0) return true;
        if (table{face, "glyf"}.size() == 0) return false;
        if (table{face, "EBLC"}.size() == 0 && table{face, "CBLC"}.size() == 0 && table{face, "bloc"}.size() == 0)
            return true;

        const table head{face, "head"}, places{face, "loca"};
        const unsigned bytes = head[51] == 0 ? 2 : 4;  // head.indexToLocFormat: of each glyph's place, and the end's
        for (unsigned i = bytes; i + 2 * bytes <= places.size(); i += bytes)
            if (!places.same(i, i + bytes, bytes)) return true;
        return false;
    }

    error vary(std::span<const variation> wanted) noexcept
    {
        if (wanted.empty()) return {};
        buffer<hb_variation_t> values;
        for (const variation& v : wanted) {
            if (!is_finite(double{v.value})) return error::bad("variations");
            const hb_variation_t value{hb_tag_from_string(v.tag, 4), v.value};
            hb_ot_var_axis_info_t axis;
            if (!hb_ot_var_find_axis_info(hb_font_get_face(font_), value.tag, &axis)) return error::unknown_variation;
            if (!values.push_back(value)) return error::out_of_memory;
        }
        hb_font_set_variations(font_, values.data(), static_cast<unsigned>(values.size()));
        return {};
    }

    /// The font units that one of HarfBuzz's makes.
    [[nodiscard]] point unit_size() const noexcept
    {
        int x = 0, y = 0;
        hb_font_get_scale(font_, &x, &y);
        return {units_per_em_ / x, units_per_em_ / y};
    }

    /// Callbacks are set anew only where the type of the sink changes: one indirect call a segment, and no allocation.
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

    static result<hb_direction_t> direction_of(const line_reading& found, direction wanted, hb_script_t script) noexcept
    {
        if (wanted == direction::top_to_bottom) return HB_DIRECTION_TTB;
        const std::size_t right = found.to_the_right, left = found.to_the_left;
        if (right != line_reading::nowhere && left != line_reading::nowhere)
            return error{error::mixed_direction}.at(no_glyph, static_cast<cluster_id>(right < left ? left : right));
        if (wanted == direction::left_to_right) return HB_DIRECTION_LTR;
        if (wanted == direction::right_to_left || left != line_reading::nowhere) return HB_DIRECTION_RTL;
        if (right != line_reading::nowhere || script == HB_SCRIPT_INVALID) return HB_DIRECTION_LTR;
        return hb_script_get_horizontal_direction(script) == HB_DIRECTION_RTL ? HB_DIRECTION_RTL : HB_DIRECTION_LTR;
    }

    error take_features(std::span<const feature> wanted) noexcept
    {
        features_.clear();
        for (const feature& f : wanted) {
            for (int i = 0; i < 4; ++i)
                if (f.tag[i] < 0x20 || f.tag[i] > 0x7E) return error::bad_feature;
            const hb_feature_t whole{hb_tag_from_string(f.tag, 4), f.value, HB_FEATURE_GLOBAL_START,
                                     HB_FEATURE_GLOBAL_END};
            if (!features_.push_back(whole)) return error::out_of_memory;
        }
        return {};
    }

    static hb_script_t script_of(hb_unicode_funcs_t* unicode, char32_t c) noexcept
    {
        if (c < 0x80) return (c | 0x20) >= 'a' && (c | 0x20) <= 'z' ? HB_SCRIPT_LATIN : HB_SCRIPT_COMMON;
        if (c >= 0x4E00 && c <= 0x9FFF) return HB_SCRIPT_HAN;
        return hb_unicode_script(unicode, c);
    }

    /// Han and the kana are written as one.
    static bool belong_together(hb_script_t a, hb_script_t b) noexcept
    {
        const auto east_asian = [](hb_script_t s) noexcept {
            return s == HB_SCRIPT_HAN || s == HB_SCRIPT_HIRAGANA || s == HB_SCRIPT_KATAKANA || s == HB_SCRIPT_BOPOMOFO;
        };
        return a == b || (east_asian(a) && east_asian(b));
    }

    /// Cuts where the script changes. Characters of no script of their own (spaces, digits, marks) stay with what
    /// precedes them.
    error cut_into_pieces(text_view text, std::size_t first, std::size_t last, hb_script_t given) noexcept
    {
        pieces_.clear();
        piece open{first, last, given};
        hb_unicode_funcs_t* unicode = hb_unicode_funcs_get_default();
        for (std::size_t i = first; i < last && given == HB_SCRIPT_INVALID;) {
            const code_point c = decode(text, i, last);
            const hb_script_t script = script_of(unicode, c.value);
            if (script != HB_SCRIPT_COMMON && script != HB_SCRIPT_INHERITED && script != HB_SCRIPT_UNKNOWN) {
                if (open.script == HB_SCRIPT_INVALID)
                    open.script = script;
                else if (!belong_together(script, open.script)) {
                    if (!pieces_.push_back({open.first, i, open.script})) return error::out_of_memory;
                    open = {i, last, script};
                }
            }
            i = c.next;
        }
        if (open.script == HB_SCRIPT_INVALID) open.script = HB_SCRIPT_COMMON;
        return pieces_.push_back(open) ? error{} : error{error::out_of_memory};
    }

    /// Hands a piece and its context to HarfBuzz. Valid text goes in as it is; else code point by code point, for
    /// HarfBuzz would read another number of U+FFFD from broken UTF-8 than decode() does.
    void fill_buffer(text_view text, const piece& p, bool decoded) noexcept
    {
        constexpr std::size_t context = 32;  // units; HarfBuzz looks at five characters
        std::size_t begin = p.first, end = p.last;
        while (begin > 0 && p.first - begin < context && !breaks_line(text.unit(begin - 1))) --begin;
        while (end < text.size() && end - p.last < context && line_break_at(text, end) == 0) ++end;

        hb_buffer_clear_contents(buffer_);
        hb_buffer_set_content_type(buffer_, HB_BUFFER_CONTENT_TYPE_UNICODE);
        hb_buffer_set_flags(buffer_, static_cast<hb_buffer_flags_t>((begin == p.first ? HB_BUFFER_FLAG_BOT : 0) |
                                                                    (end == p.last ? HB_BUFFER_FLAG_EOT : 0)));
        first_unit_ = begin;
        if (!decoded) return add(text, begin, end, p.first, p.last);
        add(text, begin, p.first, p.first, p.first);
        for (std::size_t i = p.first; i < p.last;) {
            const code_point c = decode(text, i, p.last);
            hb_buffer_add(buffer_, c.value, static_cast<unsigned>(i - begin));
            i = c.next;
        }
        add(text, p.last, end, p.last, p.last);
    }

    /// Adds text[first, last), with text[begin, end) around it as context.
    void add(text_view text, std::size_t begin, std::size_t end, std::size_t first, std::size_t last) noexcept
    {
        const auto size = static_cast<int>(end - begin), length = static_cast<int>(last - first);
        const auto offset = static_cast<unsigned>(first - begin);
        if (text.encoding() == encoding::utf8)
            return hb_buffer_add_utf8(buffer_, text.utf8() + begin, size, offset, length);
        const void* units = text.utf16() + begin;
        hb_buffer_add_utf16(buffer_, static_cast<const std::uint16_t*>(units), size, offset, length);
    }

    static bool breaks_line(std::uint32_t unit) noexcept { return unit >= 0x0A && unit <= 0x0D; }

    /// Appends what HarfBuzz has shaped, from `at` on, and moves `at`.
    error take_glyphs(point& at, glyph_run& run) const noexcept
    {
        unsigned count = 0;
        const hb_glyph_info_t* info = hb_buffer_get_glyph_infos(buffer_, &count);
        const hb_glyph_position_t* position = hb_buffer_get_glyph_positions(buffer_, nullptr);
        placed_glyph* out = run.glyphs.append(count);
        if (out == nullptr) return count == 0 ? error{} : error{error::out_of_memory};
        const point unit = unit_size();
        for (unsigned i = 0; i < count; ++i) {
            const auto cluster = static_cast<cluster_id>(first_unit_ + info[i].cluster);
            const bool missing = info[i].codepoint == 0;
            out[i] = {info[i].codepoint,
                      cluster,
                      {at.x + unit.x * position[i].x_offset, at.y + unit.y * position[i].y_offset},
                      missing};
            at = {at.x + unit.x * position[i].x_advance, at.y + unit.y * position[i].y_advance};
            if (missing) {
                ++run.missing;
                if (cluster < run.first_missing) run.first_missing = cluster;
            }
        }
        return {};
    }

    hb_font_t* font_ = nullptr;
    hb_buffer_t* buffer_ = nullptr;
    hb_draw_funcs_t* draw_ = nullptr;
    const draw_calls* calls_ = nullptr;
    double units_per_em_ = 1000.0;
    std::uint32_t glyph_count_ = 0;
    std::uint64_t fingerprint_ = 0;
    std::size_t first_unit_ = 0;  // what HarfBuzz's clusters count from
    buffer<hb_feature_t> features_;
    buffer<piece> pieces_;
};

static_assert(outline_source<harfbuzz_font> && shaper<harfbuzz_font>);

}  // namespace typemesh
