// SPDX-License-Identifier: MIT
#pragma once

#include "support/catch.hpp"
#include "support/font_path.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

/// A Debian package of fonts, and the folder where it puts them, under the folder of all fonts.
struct font_package {
    const char* name;
    const char* folder;
    bool required = true;                 ///< the tests' set-up installs it
    std::vector<std::string> files = {};  ///< only these, if the folder is shared with other packages
};

/// workload/smoke-fonts.tsv, with folders.
inline std::vector<font_package> smoke_fonts()
{
    return {
        {"fonts-dejavu-core", "truetype/dejavu"},
        {"fonts-liberation", "truetype/liberation"},
        {"fonts-wine", "../wine/fonts"},
        {"fonts-comic-neue", "opentype/comic-neue"},
        {"fonts-hosny-amiri", "opentype/fonts-hosny-amiri"},
        {"fonts-sil-awami-nastaliq", "truetype/awami"},
        {"fonts-lohit-deva", "truetype/lohit-devanagari"},
        {"fonts-tlwg-purisa-otf", "opentype/tlwg"},
        {"culmus", "truetype/culmus"},
        {"fonts-wqy-microhei", "truetype/wqy"},
        {"fonts-sawarabi-mincho", "truetype/sawarabi-mincho"},
        {"fonts-inter-variable", "truetype/inter-vf"},
        {"fonts-symbola", "truetype/ancient-scripts"},
        {"fonts-cegui",
         "truetype",
         true,
         {"FetteClassicUNZFraktur.ttf", "FutharkAdapted.ttf", "GreatVibes-Regular.ttf", "IMFePIrm29P.ttf",
          "Klingon-pIqaD-HaSta.ttf", "RichStyle.ttf", "Tnua-Libre.ttf"}},
        {"fonts-mplus", "opentype/mplus", false},
    };
}

/// The full path of an installed font, such as "truetype/dejavu/DejaVuSans.ttf"; the test fails if it is missing.
inline std::string font_file(const std::string& name)
{
    const auto path = font_path(name);
    if (!std::filesystem::exists(path)) {
        std::string package = "of its package";
        for (const font_package& p : smoke_fonts())
            if (name.rfind(p.folder, 0) == 0 && p.files.empty()) package = p.name;
        FAIL("The font " << path.string() << " is missing: install the Debian package " << package
                         << ", or set TYPEMESH_FONT_DIR.");
    }
    return path.string();
}

/// Whether an optional font is installed, which the tests' set-up does not install everywhere; warns if it is not.
inline bool has_font(const std::string& name)
{
    if (std::filesystem::exists(font_path(name))) return true;
    WARN("left out: the font " << font_path(name).string() << " is not installed");
    return false;
}

/// All font files of a package, sorted; empty if it is not installed and not required.
inline std::vector<std::string> font_files(const font_package& package)
{
    std::vector<std::string> found;
    const auto folder = font_folder() / package.folder;
    for (const std::string& file : package.files)
        if (std::filesystem::exists(folder / file)) found.push_back((folder / file).string());
    if (package.files.empty() && std::filesystem::is_directory(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            const auto kind = entry.path().extension();
            if (kind == ".ttf" || kind == ".otf" || kind == ".ttc") found.push_back(entry.path().string());
        }
    if (found.empty() && package.required)
        FAIL("No font in " << folder.string() << ": install the Debian package " << package.name
                           << ", or set TYPEMESH_FONT_DIR.");
    std::sort(found.begin(), found.end());
    return found;
}

/// A file's bytes.
inline std::vector<std::byte> bytes_of(const std::string& path)
{
    std::ifstream in{path, std::ios::binary};
    const std::vector<char> read{std::istreambuf_iterator<char>{in}, {}};
    std::vector<std::byte> bytes(read.size());
    std::transform(read.begin(), read.end(), bytes.begin(), [](char c) { return static_cast<std::byte>(c); });
    return bytes;
}
