// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "windows/fake_varied_face.hpp"

#include <typemesh/adapt/directwrite.hpp>

#include <limits>
#include <vector>

using namespace typemesh;

namespace {

/// A variable font with the axes wght (100 to 900), wdth (50 to 200) and one that DirectWrite adds (slnt, not variable).
class fake_resource final : public test::counted<IDWriteFontResource> {
public:
    std::vector<DWRITE_FONT_AXIS_RANGE> ranges = {{DWRITE_FONT_AXIS_TAG_WEIGHT, 100.0f, 900.0f},
                                                  {DWRITE_FONT_AXIS_TAG_WIDTH, 50.0f, 200.0f},
                                                  {DWRITE_FONT_AXIS_TAG_SLANT, 0.0f, 0.0f}};
    test::fake_varied_face made;  // its axes are those that it was made with
    HRESULT answer = S_OK;

    UINT32 STDMETHODCALLTYPE GetFontAxisCount() noexcept override { return static_cast<UINT32>(ranges.size()); }
    // mingw-w64 10 declares what is written as const.
    HRESULT STDMETHODCALLTYPE GetFontAxisRanges(const DWRITE_FONT_AXIS_RANGE* to, UINT32 count) noexcept override
    {
        for (UINT32 i = 0; i < count; ++i) const_cast<DWRITE_FONT_AXIS_RANGE*>(to)[i] = ranges[i];
        return answer;
    }
    DWRITE_FONT_AXIS_ATTRIBUTES STDMETHODCALLTYPE GetFontAxisAttributes(UINT32 axis) noexcept override
    {
        return axis < 2 ? DWRITE_FONT_AXIS_ATTRIBUTES_VARIABLE : DWRITE_FONT_AXIS_ATTRIBUTES_NONE;
    }
    HRESULT STDMETHODCALLTYPE CreateFontFace(DWRITE_FONT_SIMULATIONS, const DWRITE_FONT_AXIS_VALUE* values,
                                             UINT32 count, IDWriteFontFace5** face) noexcept override
    {
        made.axes.assign(values, values + count);
        made.AddRef();
        *face = &made;
        return S_OK;
    }
    TYPEMESH_TEST_UNUSED(GetFontFile, IDWriteFontFile**);
    UINT32 STDMETHODCALLTYPE GetFontFaceIndex() noexcept override { return 0; }
    TYPEMESH_TEST_UNUSED(GetDefaultFontAxisValues, const DWRITE_FONT_AXIS_VALUE*, UINT32);
    TYPEMESH_TEST_UNUSED(GetAxisNames, UINT32, IDWriteLocalizedStrings**);
    UINT32 STDMETHODCALLTYPE GetAxisValueNameCount(UINT32) noexcept override { return 0; }
    TYPEMESH_TEST_UNUSED(GetAxisValueNames, UINT32, UINT32, DWRITE_FONT_AXIS_RANGE*, IDWriteLocalizedStrings**);
    WINBOOL STDMETHODCALLTYPE HasVariations() noexcept override { return TRUE; }
    TYPEMESH_TEST_UNUSED(CreateFontFaceReference, DWRITE_FONT_SIMULATIONS, const DWRITE_FONT_AXIS_VALUE*, UINT32,
                         IDWriteFontFaceReference1**);
};

struct variable_font {
    fake_resource resource;
    test::fake_varied_face face;
    detail::com_ptr<IDWriteFontFace> held;

    variable_font()
    {
        face.resource = &resource;
        held = detail::com_ptr<IDWriteFontFace>::share(&face);
    }
    error vary(std::vector<variation> wanted) { return detail::vary(held, wanted); }
};

}  // namespace

TEST_CASE("our interfaces of axes equal the ones in dwrite_3.h", "[windows]")
{
    CHECK(IsEqualGUID(detail::directwrite_varied_face::id, __uuidof(IDWriteFontFace5)));
    CHECK(sizeof(detail::directwrite_axis_value) == sizeof(DWRITE_FONT_AXIS_VALUE));
    CHECK(sizeof(detail::directwrite_axis_range) == sizeof(DWRITE_FONT_AXIS_RANGE));

    // By number in the table of functions, which is the whole of a COM interface in memory.
    test::fake_varied_face face;
    face.axes = {{DWRITE_FONT_AXIS_TAG_WEIGHT, 321.0f}};
    const auto found = detail::varied(&face);
    REQUIRE(found);
    CHECK(found->GetFontAxisValueCount() == 1);
    detail::directwrite_axis_value value = {};
    CHECK(SUCCEEDED(found->GetFontAxisValues(&value, 1)));
    CHECK(value.tag == std::uint32_t{DWRITE_FONT_AXIS_TAG_WEIGHT});
    CHECK(value.value == 321.0f);
    face.varies = FALSE;
    CHECK_FALSE(detail::varied(&face));
    test::fake_face fixed;
    CHECK_FALSE(detail::varied(&fixed));
    CHECK(fixed.references == 1);
}

TEST_CASE("a variable face is varied along its axes, within their ranges", "[windows]")
{
    variable_font font;
    CHECK_FALSE(font.vary({{"wdth", 75.0f}, {"wght", 1000.0f}}));
    CHECK(font.held.get() == &font.resource.made);
    const auto& axes = font.resource.made.axes;
    REQUIRE(axes.size() == 2);
    CHECK(axes[0].axisTag == DWRITE_FONT_AXIS_TAG_WIDTH);
    CHECK(axes[0].value == 75.0f);
    CHECK(axes[1].axisTag == DWRITE_FONT_AXIS_TAG_WEIGHT);
    CHECK(axes[1].value == 900.0f);
    CHECK(font.face.references == 1);
    CHECK(font.resource.references == 1);
    CHECK(font.resource.made.references == 2);
}

TEST_CASE("a face that cannot be varied stays as it is", "[windows]")
{
    variable_font font;
    CHECK_FALSE(font.vary({}));
    CHECK(font.vary({{"opsz", 12.0f}}) == error::unknown_variation);
    CHECK(font.vary({{"slnt", 0.0f}}) == error::unknown_variation);
    CHECK(font.vary({{"wght", std::numeric_limits<float>::infinity()}}) == error::bad_option);
    font.resource.answer = E_OUTOFMEMORY;
    CHECK(font.vary({{"wght", 700.0f}}) == error::out_of_memory);
    font.resource.ranges.clear();
    CHECK(font.vary({{"wght", 700.0f}}) == error::unknown_variation);
    CHECK(font.held.get() == &font.face);
    CHECK(font.face.references == 2);
    CHECK(font.resource.references == 1);
    CHECK(font.resource.made.references == 1);
}
