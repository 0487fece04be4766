// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/impl/directwrite_axes.hpp>
#include <typemesh/adapt/impl/directwrite_com.hpp>
#include <typemesh/adapt/impl/directwrite_key.hpp>
#include <typemesh/adapt/impl/directwrite_outline.hpp>
#include <typemesh/adapt/impl/directwrite_shaping.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/outline/font_options.hpp>
#include <typemesh/outline/outline_source.hpp>

#include <dwrite.h>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// Selects a member of a family: weight (100 to 900), width, slant.
struct directwrite_style {
    DWRITE_FONT_WEIGHT weight = DWRITE_FONT_WEIGHT_NORMAL;
    DWRITE_FONT_STRETCH stretch = DWRITE_FONT_STRETCH_NORMAL;
    DWRITE_FONT_STYLE style = DWRITE_FONT_STYLE_NORMAL;
};

/// A font through DirectWrite (Windows 7 or later): shapes text of every script, and draws its outlines. Needs only
/// Windows; link dwrite.lib.
///
///     auto font = directwrite_font::open(L"C:\\Windows\\Fonts\\segoeui.ttf");      // a file
///     auto font = directwrite_font::open_family(L"Segoe UI");                      // an installed font
///     auto font = directwrite_font::open_selected(dc);                             // GDI's, from a device context
///     if (!font) return puts(font.error().message());
///
/// Its shaper is IDWriteTextAnalyzer, not IDWriteTextLayout. The analyser uses this face, so no other font can replace
/// a missing glyph, and the face needs no family name or collection. Script, language and features are passed
/// explicitly. Wine has the analyser too. For a whole IDWriteTextLayout see directwrite_text.
///
/// `fill()` returns the rule of the outline drawn last (DirectWrite reports it glyph by glyph); it is non_zero in all
/// known fonts. Outlines are requested at one unit per font unit and flipped to y up.
///
/// COM need not be initialised. Move-only. Used by one thread at a time; for another thread make a second object,
/// wrap(font.handle()).
class directwrite_font {
public:
    /// Opens a font file. Without a `factory` it uses the process's shared factory. Variations need Windows 10 1709 at
    /// run time, whatever Windows the program is compiled for; on older systems, no font has an axis.
    ///
    /// Fails  error::unreadable_file, not_a_font, no_such_face (count = the number of faces), no_outlines,
    ///        unknown_variation, bad_option (a variation is NaN or infinite), out_of_memory,
    ///        font_library_failed (count = the HRESULT)
    static result<directwrite_font> open(const wchar_t* path, const font_options& options = {},
                                         IDWriteFactory* factory = nullptr) noexcept
    {
        TYPEMESH_ASSERT(path != nullptr, "a font was opened without a path");
        auto held = factory_or_shared(factory);
        if (!held) return held.error();
        detail::com_ptr<IDWriteFontFile> file;
        if (error e = directwrite_error((*held)->CreateFontFileReference(path, nullptr, file.put()))) return e;

        BOOL supported = FALSE;
        DWRITE_FONT_FILE_TYPE file_type = DWRITE_FONT_FILE_TYPE_UNKNOWN;
        DWRITE_FONT_FACE_TYPE face_type = DWRITE_FONT_FACE_TYPE_UNKNOWN;
        UINT32 faces = 0;
        if (error e = directwrite_error(file->Analyze(&supported, &file_type, &face_type, &faces))) {
            // Wine reports a failure without the reason.
            const DWORD kind = GetFileAttributesW(path);
            const bool is_file = kind != INVALID_FILE_ATTRIBUTES && (kind & FILE_ATTRIBUTE_DIRECTORY) == 0;
            return is_file ? e : error{error::unreadable_file};
        }
        if (supported == FALSE || faces == 0) return error::not_a_font;
        if (options.face >= faces) return error{error::no_such_face, faces};
        detail::com_ptr<IDWriteFontFace> face;
        IDWriteFontFile* const files[] = {file.get()};
        if (error e = directwrite_error(
                (*held)->CreateFontFace(face_type, 1, files, options.face, DWRITE_FONT_SIMULATIONS_NONE, face.put())))
            return e;
        if (error e = detail::vary(face, options.variations)) return e;
        return finished(std::move(face), *held);
    }

    /// Opens the member of a family that best matches a style, from the installed fonts or from a collection of the
    /// caller. DirectWrite simulates a weight or slant that the family lacks.
    ///
    /// Fails  error::no_such_family, no_outlines, out_of_memory, font_library_failed (count = the HRESULT)
    static result<directwrite_font> open_family(const wchar_t* family, const directwrite_style& style = {},
                                                IDWriteFontCollection* collection = nullptr,
                                                IDWriteFactory* factory = nullptr) noexcept
    {
        TYPEMESH_ASSERT(family != nullptr, "a font was opened without the name of its family");
        auto held = factory_or_shared(factory);
        if (!held) return held.error();
        auto fonts = detail::com_ptr<IDWriteFontCollection>::share(collection);
        if (!fonts)
            if (error e = directwrite_error((*held)->GetSystemFontCollection(fonts.put(), FALSE))) return e;

        UINT32 index = 0;
        BOOL exists = FALSE;
        if (error e = directwrite_error(fonts->FindFamilyName(family, &index, &exists))) return e;
        if (exists == FALSE) return error::no_such_family;
        detail::com_ptr<IDWriteFontFamily> members;
        detail::com_ptr<IDWriteFont> member;
        detail::com_ptr<IDWriteFontFace> face;
        if (error e = directwrite_error(fonts->GetFontFamily(index, members.put()))) return e;
        if (error e = directwrite_error(
                members->GetFirstMatchingFont(style.weight, style.stretch, style.style, member.put())))
            return e;
        if (error e = directwrite_error(member->CreateFontFace(face.put()))) return e;
        return finished(std::move(face), *held);
    }

    /// Opens the font that GDI's name, weight and slant select. GDI gives each width and many weights a family of its
    /// own ("Arial Narrow", "Segoe UI Semibold"), which open_family() often does not know. The size, rotation and lines
    /// of a LOGFONT are ignored. GetObjectW(font, sizeof(LOGFONTW), &description) returns the LOGFONT of an HFONT.
    ///
    /// Fails  error::no_such_family (GDI itself then uses another font, which open_selected() opens), no_outlines,
    ///        out_of_memory, font_library_failed (count = the HRESULT)
    static result<directwrite_font> open_described(const LOGFONTW& description,
                                                   IDWriteFactory* factory = nullptr) noexcept
    {
        auto held = factory_or_shared(factory);
        if (!held) return held.error();
        detail::com_ptr<IDWriteGdiInterop> gdi;
        detail::com_ptr<IDWriteFont> member;
        detail::com_ptr<IDWriteFontFace> face;
        if (error e = directwrite_error((*held)->GetGdiInterop(gdi.put()))) return e;
        if (error e = directwrite_error(gdi->CreateFontFromLOGFONT(&description, member.put()))) return e;
        if (error e = directwrite_error(member->CreateFontFace(face.put()))) return e;
        return finished(std::move(face), *held);
    }

    /// Opens the font that GDI draws with: the font selected into a device context, or GDI's replacement for it. The
    /// context is not kept; it may be a memory context, CreateCompatibleDC(nullptr).
    ///
    /// Fails  error::no_such_family (DirectWrite does not have the font: GDI's own bitmap and stroke fonts),
    ///        no_outlines, out_of_memory, font_library_failed (count = the HRESULT)
    static result<directwrite_font> open_selected(HDC context, IDWriteFactory* factory = nullptr) noexcept
    {
        TYPEMESH_ASSERT(context != nullptr, "a font was opened from a null HDC");
        auto held = factory_or_shared(factory);
        if (!held) return held.error();
        detail::com_ptr<IDWriteGdiInterop> gdi;
        detail::com_ptr<IDWriteFontFace> face;
        if (error e = directwrite_error((*held)->GetGdiInterop(gdi.put()))) return e;
        if (error e = directwrite_error(gdi->CreateFontFaceFromHdc(context, face.put()))) return e;
        return finished(std::move(face), *held);
    }

    /// Wraps a face of the caller, with its variations and simulations. The font holds its own reference to the face.
    ///
    /// Fails  error::not_a_font (without glyphs or units), no_outlines, out_of_memory, font_library_failed
    static result<directwrite_font> wrap(IDWriteFontFace* face, IDWriteFactory* factory = nullptr) noexcept
    {
        TYPEMESH_ASSERT(face != nullptr, "a null IDWriteFontFace* was wrapped");
        auto held = factory_or_shared(factory);
        if (!held) return held.error();
        return finished(detail::com_ptr<IDWriteFontFace>::share(face), *held);
    }

    /// DirectWrite's own object, still owned by this one; AddRef() keeps it longer.
    [[nodiscard]] IDWriteFontFace* handle() const noexcept { return face_.get(); }

    [[nodiscard]] double units_per_em() const noexcept { return units_per_em_; }
    [[nodiscard]] fill_rule fill() const noexcept { return rule_; }

    /// The number of glyphs in the face; their ids count from 0.
    [[nodiscard]] std::uint32_t glyph_count() const noexcept { return glyph_count_; }

    /// See outline_source. Covers the font (by the checksum in its 'head' table, its number of glyphs and its face
    /// index), its simulations and its axes. If DirectWrite does not report the axis values of a variable font, the key
    /// is unique to this directwrite_font.
    [[nodiscard]] std::uint64_t variation_key() const noexcept { return key_; }

    /// See outline_source. DirectWrite returns TrueType's quadratics as cubics. A cubic becomes a quadratic again if
    /// rounding alone (1/25 unit, Wine's) distinguishes the two. CFF's cubics stay cubics.
    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        if (id >= glyph_count_) return error{error::unknown_glyph}.at(id, no_cluster);
        return detail::draw_glyph(face_.get(), units_per_em_, 1.0, lowers_, false, id, sink, rule_);
    }

    /// See shaper. Columns extend half an em to each side.
    [[nodiscard]] line_metrics metrics(direction d) const noexcept
    {
        if (d == direction::top_to_bottom) return {units_per_em_ / 2, -units_per_em_ / 2, 0.0};
        DWRITE_FONT_METRICS m = {};
        face_->GetMetrics(&m);
        const double ascent = m.ascent, descent = m.descent;
        return {ascent, -descent, static_cast<double>(m.lineGap)};
    }

    /// See shaper. The text around the item is no context, because DirectWrite shapes a text without its surroundings.
    /// Arabic letters therefore do not join across the ends of an item: where a style changes, or where a line ends
    /// inside a word. DirectWrite finds the scripts in the item by itself, unless options.script names one.
    ///
    /// Upright items have the font's vertical forms ("vert") and vertical metrics.
    ///
    /// Also fails with  error::bad_option: options.script is unknown to DirectWrite, or options.language is longer than
    ///                  Windows allows
    ///                  error::bad_feature: a tag is not four printable ASCII characters
    ///                  error::too_large: 2^28 or more units in an item; error::font_library_failed (count = HRESULT)
    error shape(text_view text, const text_item& item, const shape_options& options,
                buffer<shaped_glyph>& glyphs) noexcept
    {
        TYPEMESH_ASSERT(item.first <= item.last && item.last <= text.size(),
                        "a shaper was given a range outside its text");
        return shaping_.shape(face_.get(), units_per_em_, text, item, options, glyphs);
    }

    /// See shaper. Cost: the shaping of the character
    [[nodiscard]] bool has_vertical_form(char32_t c) noexcept
    {
        return shaping_.has_vertical_form(face_.get(), units_per_em_, c);
    }

private:
    directwrite_font() noexcept = default;

    static result<detail::com_ptr<IDWriteFactory>> factory_or_shared(IDWriteFactory* callers) noexcept
    {
        if (callers != nullptr) return detail::com_ptr<IDWriteFactory>::share(callers);
        detail::com_ptr<IDWriteFactory> made;
        IUnknown* unknown = nullptr;
        if (error e =
                directwrite_error(DWriteCreateFactory(DWRITE_FACTORY_TYPE_SHARED, __uuidof(IDWriteFactory), &unknown)))
            return e;
        *made.put() = static_cast<IDWriteFactory*>(unknown);
        return result<detail::com_ptr<IDWriteFactory>>{std::move(made)};
    }

    static result<directwrite_font> finished(detail::com_ptr<IDWriteFontFace> face,
                                             const detail::com_ptr<IDWriteFactory>& factory) noexcept
    {
        directwrite_font made;
        if (error e = made.shaping_.open(factory.get())) return e;
        DWRITE_FONT_METRICS m = {};
        face->GetMetrics(&m);
        made.units_per_em_ = m.designUnitsPerEm;
        made.glyph_count_ = face->GetGlyphCount();
        if (made.glyph_count_ == 0 || m.designUnitsPerEm == 0) return error::not_a_font;
        made.lowers_ = detail::has_table(face.get(), "glyf");
        if (!made.lowers_ && face->GetType() != DWRITE_FONT_FACE_TYPE_TYPE1 && !detail::has_table(face.get(), "CFF ") &&
            !detail::has_table(face.get(), "CFF2"))
            return error::no_outlines;
        detail::directwrite_key key;
        key.mix_state(face.get());
        made.key_ = key.value(face.get(), detail::directwrite_key::now());
        made.face_ = std::move(face);
        return result<directwrite_font>{std::move(made)};
    }

    detail::com_ptr<IDWriteFontFace> face_;
    detail::directwrite_shaping shaping_;
    double units_per_em_ = 1000.0;
    std::uint64_t key_ = 0;
    std::uint32_t glyph_count_ = 0;
    fill_rule rule_ = fill_rule::non_zero;
    bool lowers_ = false;
};

static_assert(outline_source<directwrite_font> && shaper<directwrite_font>);

}  // namespace typemesh::inline TYPEMESH_ABI
