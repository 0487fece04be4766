// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace text_to_mesh {

/// What a file is to hold, by the end of its name.
enum class file_kind { unknown, glb, obj, stl, ply, three_mf, png, svg, dxf };

/// "x.GLB" is a GLB: case does not count. A name that is nothing but an ending has none.
[[nodiscard]] inline file_kind kind_of(std::string_view path)
{
    std::string end{path.size() > 4 ? path.substr(path.size() - 4) : ""};
    for (char& c : end)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    constexpr std::pair<std::string_view, file_kind> known[] = {
        {".glb", file_kind::glb},      {".obj", file_kind::obj}, {".stl", file_kind::stl}, {".ply", file_kind::ply},
        {".3mf", file_kind::three_mf}, {".png", file_kind::png}, {".svg", file_kind::svg}, {".dxf", file_kind::dxf}};
    for (const auto& [name, kind] : known)
        if (end == name) return kind;
    return file_kind::unknown;
}

/// "stl" is what ".stl" stands for.
[[nodiscard]] inline file_kind kind_of_format(std::string_view format) { return kind_of("x." + std::string{format}); }

/// True where a mesh is a solid to the programs that read it: letters that run into each other are one.
[[nodiscard]] constexpr bool holds_solids(file_kind kind)
{
    return kind == file_kind::stl || kind == file_kind::three_mf;
}

/// True where a file has no mesh, but the curves of the outlines.
[[nodiscard]] constexpr bool holds_curves(file_kind kind) { return kind == file_kind::svg || kind == file_kind::dxf; }

/// True where every edge is to have two faces: what reads the others draws, and does not compute with solids.
[[nodiscard]] constexpr bool wants_two_faces(file_kind kind)
{
    return holds_solids(kind) || kind == file_kind::obj || kind == file_kind::ply;
}

/// True for the solids that slicers take.
[[nodiscard]] constexpr bool is_printed(file_kind kind) { return holds_solids(kind); }

/// True where the unit is a millimetre.
[[nodiscard]] constexpr bool has_millimetres(file_kind kind) { return is_printed(kind) || holds_curves(kind); }

/// True where parts may have colours of their own.
[[nodiscard]] constexpr bool holds_colours(file_kind kind)
{
    return kind != file_kind::stl && kind != file_kind::ply && kind != file_kind::dxf;
}

}  // namespace text_to_mesh
