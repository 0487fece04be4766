// SPDX-License-Identifier: MIT
#include "../text_source.hpp"
#include "svg_drawing.hpp"

namespace text_to_mesh {

#ifdef TEXT_TO_MESH_PUGIXML

std::string read_svg(const std::string& path, const svg_options& how, svg_drawing& out)
{
    std::string text;
    if (std::string trouble = read_file(path, text, ""); !trouble.empty()) return trouble;
    const std::string trouble = read_svg_text(text, how, out);
    return trouble.empty() ? trouble : (path == "-" ? "standard input" : path) + trouble;
}

#else

std::string read_svg(const std::string&, const svg_options&, svg_drawing&)
{
    return "SVG is not built in: this program was built without pugixml, which reads XML.";
}

#endif

}  // namespace text_to_mesh
