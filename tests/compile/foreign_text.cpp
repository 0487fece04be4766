// SPDX-License-Identifier: MIT

// Must not compile, each line in the same words: text in UTF-32 and in wchar_t.

#include "../support/toy_font.hpp"

#include <typemesh/compat/d3dx_text.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

using namespace typemesh;

void write(text_mesher<>& mesher, d3dx_text<>& maker, glyph_workers<one_worker, test::toy_font>& team,
           std::vector<d3dx_vertex>& vertices, std::vector<std::uint32_t>& indices, const std::u32string& code_points,
           const std::wstring& wide)
{
    (void)mesher.plan(U"o");
    (void)mesher.plan(code_points);
    (void)mesher.plan(std::wstring_view{wide}, {.merge = true});
    (void)mesher.plan(wide, {}, team);
    (void)mesher.build(L"o", into(vertices, indices));
    (void)maker.plan(L"o");
}
