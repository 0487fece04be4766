// SPDX-License-Identifier: MIT
//
// Windows only: text set by DirectWrite, in an installed font, wrapped, centred and underlined, as one mesh. Neither
// FreeType nor HarfBuzz is needed.
//
//     06_directwrite_word [TEXT [FAMILY]]

#include <typemesh/adapt/directwrite.hpp>
#include <typemesh/adapt/directwrite_text.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdio>
#include <cwchar>
#include <vector>

struct vertex {
    typemesh::vec3 position, normal;
};

template <>
struct typemesh::vertex_traits<vertex> {
    static constexpr auto wants = attribute::position | attribute::normal;
    vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.normal}; }
};

// The layout is an application's own: any IDWriteTextLayout will do. Release what is made here as your program does.
IDWriteTextLayout* make_layout(const wchar_t* text, const wchar_t* family)
{
    IDWriteFactory* factory = nullptr;
    IDWriteTextFormat* format = nullptr;
    IDWriteTextLayout* layout = nullptr;
    IUnknown* made = nullptr;
    if (FAILED(DWriteCreateFactory(DWRITE_FACTORY_TYPE_SHARED, __uuidof(IDWriteFactory), &made))) return nullptr;
    factory = static_cast<IDWriteFactory*>(made);
    const auto length = static_cast<UINT32>(std::wcslen(text));
    if (SUCCEEDED(factory->CreateTextFormat(family, nullptr, DWRITE_FONT_WEIGHT_NORMAL, DWRITE_FONT_STYLE_NORMAL,
                                            DWRITE_FONT_STRETCH_NORMAL, 32.0f, L"en-us", &format)) &&
        SUCCEEDED(format->SetTextAlignment(DWRITE_TEXT_ALIGNMENT_CENTER)) &&
        SUCCEEDED(factory->CreateTextLayout(text, length, format, 400.0f, 400.0f, &layout)))
        layout->SetUnderline(TRUE, {0, 5});
    if (format != nullptr) format->Release();
    factory->Release();
    return layout;
}

int wmain(int argc, wchar_t** argv)
{
    using namespace typemesh;
    IDWriteTextLayout* layout = make_layout(argc > 1 ? argv[1] : L"Hello world!", argc > 2 ? argv[2] : L"Segoe UI");
    if (layout == nullptr) return std::puts("DirectWrite made no layout: check the name of the family"), 1;

    directwrite_text text;
    const auto read = text.read(layout);
    layout->Release();
    char words[200];
    if (!read) return std::puts(describe(read.error(), words)), 1;

    auto mesher = text_mesher{text}.with(extruded<>{.depth = 0.3f});
    std::vector<vertex> vertices;
    std::vector<std::uint32_t> indices;
    auto made = mesher.build(text.run(), into(vertices, indices), {.frame = left_handed_y_up});
    if (!made) return std::puts(describe(made.error(), words)), 1;
    std::printf("%u glyphs in %u lines: %u vertices, %u triangles\n", made->glyphs,
                static_cast<unsigned>(text.run().lines.size()), static_cast<unsigned>(vertices.size()),
                static_cast<unsigned>(indices.size() / 3));
    return 0;
}
