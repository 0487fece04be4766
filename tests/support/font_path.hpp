// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

/// The folder of fonts: TYPEMESH_FONT_DIR, or Debian's.
inline std::filesystem::path font_folder()
{
    const char* given = std::getenv("TYPEMESH_FONT_DIR");
    return given != nullptr ? given : "/usr/share/fonts";
}

/// The path of a font such as "truetype/dejavu/DejaVuSans.ttf", by its name in Debian 12 or by its present name; the former
/// if the font is missing.
inline std::filesystem::path font_path(const std::string& name)
{
    static constexpr std::pair<const char*, const char*> renamed[] = {
        // Debian 12, Debian 13; font_file.sh reads these lines
        {"truetype/inter-vf/Inter.var.ttf", "truetype/inter-vf/InterVariable.ttf"},
        {"truetype/inter-vf/Inter-roman.var.ttf", "truetype/inter-vf/InterVariable.ttf"},
        {"truetype/inter-vf/Inter-italic.var.ttf", "truetype/inter-vf/InterVariable-Italic.ttf"},
        {"truetype/culmus/FrankRuehlCLM-Medium.ttf", "truetype/culmus/FrankRuehlCLM-Medium.otf"},
    };
    const auto path = font_folder() / name;
    if (!std::filesystem::exists(path))
        for (const auto& [before, now] : renamed)
            if (name == before && std::filesystem::exists(font_folder() / now)) return font_folder() / now;
    return path;
}
