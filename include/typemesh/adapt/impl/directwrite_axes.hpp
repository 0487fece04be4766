// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/impl/directwrite_com.hpp>
#include <typemesh/adapt/impl/directwrite_shaping.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/outline/font_options.hpp>

#include <dwrite.h>

#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The axes of a variable font. DirectWrite has them from Windows 10 1709 on. Microsoft's headers omit them if
/// _WIN32_WINNT or NTDDI_VERSION names an older Windows, so the functions used are declared here with the same memory
/// layout. A program for older systems may use them if they exist, and units that differ in those macros see the same
/// code.

/// A COM interface, followed by `count` functions that are not called here.
template <class Interface, int count>
struct followed_by : followed_by<Interface, count - 1> {
    using followed_by<Interface, count - 1>::unused;
    virtual void STDMETHODCALLTYPE unused(std::integral_constant<int, count>) noexcept = 0;
};
template <class Interface>
struct followed_by<Interface, 1> : Interface {
    virtual void STDMETHODCALLTYPE unused(std::integral_constant<int, 1>) noexcept = 0;
};

/// DWRITE_FONT_AXIS_VALUE
struct directwrite_axis_value {
    std::uint32_t tag;
    FLOAT value;
};
/// DWRITE_FONT_AXIS_RANGE
struct directwrite_axis_range {
    std::uint32_t tag;
    FLOAT low, high;
};

struct directwrite_resource;

/// IDWriteFontFace5. Between it and the first there are 12, 5, 14 and 4 functions.
struct directwrite_varied_face : followed_by<IDWriteFontFace, 12 + 5 + 14 + 4> {
    static constexpr GUID id = {0x98eff3a5, 0xb667, 0x479a, {0xb1, 0x45, 0xe2, 0xfa, 0x5b, 0x9f, 0xdc, 0x29}};

    virtual UINT32 STDMETHODCALLTYPE GetFontAxisValueCount() noexcept = 0;
    virtual HRESULT STDMETHODCALLTYPE GetFontAxisValues(directwrite_axis_value* values, UINT32 count) noexcept = 0;
    virtual BOOL STDMETHODCALLTYPE HasVariations() noexcept = 0;
    virtual HRESULT STDMETHODCALLTYPE GetFontResource(directwrite_resource** resource) noexcept = 0;
};

/// IDWriteFontResource
struct directwrite_resource : IUnknown {
    virtual HRESULT STDMETHODCALLTYPE GetFontFile(IDWriteFontFile** file) noexcept = 0;
    virtual UINT32 STDMETHODCALLTYPE GetFontFaceIndex() noexcept = 0;
    virtual UINT32 STDMETHODCALLTYPE GetFontAxisCount() noexcept = 0;
    virtual HRESULT STDMETHODCALLTYPE GetDefaultFontAxisValues(directwrite_axis_value* values,
                                                               UINT32 count) noexcept = 0;
    virtual HRESULT STDMETHODCALLTYPE GetFontAxisRanges(directwrite_axis_range* ranges, UINT32 count) noexcept = 0;
    virtual std::uint32_t STDMETHODCALLTYPE GetFontAxisAttributes(UINT32 axis) noexcept = 0;
    virtual HRESULT STDMETHODCALLTYPE GetAxisNames(UINT32 axis, IDWriteLocalizedStrings** names) noexcept = 0;
    virtual UINT32 STDMETHODCALLTYPE GetAxisValueNameCount(UINT32 axis) noexcept = 0;
    virtual HRESULT STDMETHODCALLTYPE GetAxisValueNames(UINT32 axis, UINT32 value, directwrite_axis_range* range,
                                                        IDWriteLocalizedStrings** names) noexcept = 0;
    virtual BOOL STDMETHODCALLTYPE HasVariations() noexcept = 0;
    virtual HRESULT STDMETHODCALLTYPE CreateFontFace(DWRITE_FONT_SIMULATIONS simulations,
                                                     const directwrite_axis_value* values, UINT32 count,
                                                     directwrite_varied_face** face) noexcept = 0;
};

/// The face with its axes; empty if it has none, or Windows does not support axes.
[[nodiscard]] inline com_ptr<directwrite_varied_face> varied(IDWriteFontFace* face) noexcept
{
    auto found = com_ptr<IDWriteFontFace>::share(face).as<directwrite_varied_face>(directwrite_varied_face::id);
    return found && found->HasVariations() != FALSE ? std::move(found) : com_ptr<directwrite_varied_face>{};
}

/// Replaces a face by one with these values on its axes, clamped to their ranges; the other axes keep their defaults.
///
/// Fails  error::bad_option (a value is NaN or infinite), unknown_variation (also if Windows does not support axes),
///        out_of_memory, font_library_failed
inline error vary(com_ptr<IDWriteFontFace>& face, std::span<const variation> wanted) noexcept
{
    constexpr std::uint32_t is_variable = 1;  // DWRITE_FONT_AXIS_ATTRIBUTES_VARIABLE
    if (wanted.empty()) return {};
    for (const variation& v : wanted)
        if (!is_finite(double{v.value})) return error::bad("variations");
    const auto fixed = varied(face.get());
    if (!fixed) return error::no_axis(wanted[0].tag);
    com_ptr<directwrite_resource> resource;
    if (error e = directwrite_error(fixed->GetFontResource(resource.put()))) return e;

    const UINT32 axes = resource->GetFontAxisCount();
    buffer<directwrite_axis_range> ranges;
    buffer<directwrite_axis_value> values;
    if (axes == 0) return error::no_axis(wanted[0].tag);
    if (ranges.append(axes) == nullptr) return error::out_of_memory;
    if (error e = directwrite_error(resource->GetFontAxisRanges(ranges.data(), axes))) return e;
    for (const variation& v : wanted) {
        UINT32 i = 0;
        const std::uint32_t tag = directwrite_tag(v.tag);
        while (i < axes && ranges[i].tag != tag) ++i;
        // DirectWrite adds the other axes only to describe the family.
        if (i == axes || (resource->GetFontAxisAttributes(i) & is_variable) == 0) return error::no_axis(v.tag);
        const float low = ranges[i].low, high = ranges[i].high;
        const float inside = v.value < low ? low : v.value > high ? high : v.value;
        if (!values.push_back({tag, inside})) return error::out_of_memory;
    }
    com_ptr<directwrite_varied_face> made;
    if (error e = directwrite_error(resource->CreateFontFace(DWRITE_FONT_SIMULATIONS_NONE, values.data(),
                                                             static_cast<UINT32>(values.size()), made.put())))
        return e;
    face = com_ptr<IDWriteFontFace>::share(made.get());
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
