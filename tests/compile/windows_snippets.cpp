// SPDX-License-Identifier: MIT
//
// Every line of C++ in README.md and docs/ that needs Windows, and what they say within sentences: see
// readme_snippets.cpp. Nothing is run.

#include <typemesh/adapt/directwrite.hpp>
#include <typemesh/adapt/directwrite_text.hpp>
#include <typemesh/compat/d3dx_text.hpp>
#include <typemesh/typemesh.hpp>

#include <d3d9.h>
#if __has_include(<d3dx9.h>)  // mingw-w64 has it, and the old DirectX SDK
#include <d3dx9.h>
#endif

#include <cstdio>
#include <vector>

struct vertex { typemesh::vec3 position, normal; typemesh::vec2 uv; };

template <>
struct typemesh::vertex_traits<vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv;
    vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.normal, s.uv}; }
};

namespace readme {

int on_windows(IDWriteTextLayout* layout, std::vector<vertex>& vertices, std::vector<std::uint32_t>& indices)
{
typemesh::directwrite_text text;
if (auto read = text.read(layout); !read) return std::puts(read.error().message()), 1;
typemesh::text_mesher mesher{text};
auto made = mesher.build(text.run(), typemesh::into(vertices, indices), {.frame = typemesh::left_handed_y_up});
    return made ? 0 : 1;
}

}  // namespace readme

namespace windows {

int main(IDWriteTextLayout* layout, std::vector<vertex>& vertices, std::vector<std::uint32_t>& indices)
{
auto font = typemesh::directwrite_font::open(L"C:\\Windows\\Fonts\\segoeui.ttf");
if (!font) return std::puts(font.error().message()), 1;
typemesh::text_mesher mesher{*font};
auto word = mesher.build(u"Hello world!", typemesh::into(vertices, indices));
if (!word) return std::puts(word.error().message()), 1;

typemesh::directwrite_text text;                       // layout: your IDWriteTextLayout, with all that was set on it
if (auto read = text.read(layout); !read) return std::puts(read.error().message()), 1;
typemesh::text_mesher laid_out{text};
auto page = laid_out.build(text.run(), typemesh::into(vertices, indices));
if (!page) return std::puts(page.error().message()), 1;
    return 0;
}

}  // namespace windows

namespace from_d3dx {

#if __has_include(<d3dx9.h>)
void before(HDC dc, IDirect3DDevice9* device)
{
SelectObject(dc, CreateFontW(-64, 0, 0, 0, FW_NORMAL, FALSE, FALSE, FALSE, DEFAULT_CHARSET, 0, 0, 0, 0, L"Arial"));
GLYPHMETRICSFLOAT metrics[12];
ID3DXMesh* mesh = nullptr;
if (FAILED(D3DXCreateTextW(device, dc, L"Hello world!", 0.005f, 0.4f, &mesh, nullptr, metrics))) return;
mesh->DrawSubset(0);
}
#endif

typemesh::error after(HDC dc, IDirect3DDevice9* device)
{
auto font = typemesh::directwrite_font::open_selected(dc);
if (!font) return font.error();
typemesh::d3dx_text maker{*font};  // keep both: the memory that they need stays with them

auto plan = maker.plan(u"Hello world!", {.deviation = 0.005, .extrusion = 0.4});
if (!plan) return plan.error();
std::vector<typemesh::d3dx_vertex> vertices(plan->size().vertices);
std::vector<std::uint16_t> indices(plan->size().indices());
std::vector<typemesh::d3dx_glyph_metrics> metrics(plan->metrics_size());
if (auto written = plan->write(std::span{vertices}, std::span{indices}); !written) return written.error();
if (auto known = plan->metrics(metrics); !known) return known.error();
device->SetFVF(D3DFVF_XYZ | D3DFVF_NORMAL);
device->DrawIndexedPrimitiveUP(D3DPT_TRIANGLELIST, 0, UINT(vertices.size()), UINT(plan->size().triangles), indices.data(),
                               D3DFMT_INDEX16, vertices.data(), sizeof(typemesh::d3dx_vertex));
    return {};
}

bool described(HFONT font)
{
    LOGFONTW description;
    GetObjectW(font, sizeof(LOGFONTW), &description);
    const bool narrow = bool{typemesh::directwrite_font::open_family(L"Arial Narrow")};
    return bool{typemesh::directwrite_font::open_described(description)} && narrow;
}

bool in_sentences(typemesh::directwrite_font* font, const wchar_t* text, std::size_t length)
{
    typemesh::glyph_cache cache; typemesh::d3dx_text maker{*font, typemesh::cached_in{cache, 1}};
    maker.normals_policy().crease_degrees = 45.0f;
    auto plan = maker.plan(std::u16string_view{reinterpret_cast<const char16_t*>(text), length});
    return plan && plan->size().triangles != 0;
}

}  // namespace from_d3dx
