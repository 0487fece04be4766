// SPDX-License-Identifier: MIT
#pragma once

// All faces of font files, variable ones at several places of their axes.

#include <typemesh/adapt/harfbuzz.hpp>

#include <hb-ot.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace test {

/// One face of a font file, at one place of its axes.
struct face_instance {
    std::string path;
    std::uint32_t face = 0;
    std::vector<typemesh::variation> variations;
    std::uint32_t glyph_count = 0;

    [[nodiscard]] std::string name() const
    {
        std::string s = std::filesystem::path{path}.filename().string();
        if (face != 0) s += " face " + std::to_string(face);
        for (const auto& v : variations)
            s += " " + std::string{v.tag} + "=" + std::to_string(static_cast<int>(v.value));
        return s;
    }
    [[nodiscard]] auto open() const
    {
        return typemesh::harfbuzz_font::open(path.c_str(), {.face = face, .variations = variations});
    }
};

/// All faces of a file that have outlines; variable ones at their default, at each axis' ends and at mixed corners.
inline std::vector<face_instance> instances_of(const std::string& path)
{
    std::vector<face_instance> all;
    hb_blob_t* blob = hb_blob_create_from_file_or_fail(path.c_str());
    if (blob == nullptr) return all;
    const std::uint32_t faces = hb_face_count(blob);
    for (std::uint32_t f = 0; f < faces; ++f) {
        face_instance plain{path, f, {}, 0};
        const auto font = plain.open();
        if (!font) continue;
        plain.glyph_count = font->glyph_count();
        all.push_back(plain);
        hb_face_t* face = hb_face_create(blob, f);
        hb_ot_var_axis_info_t axes[8];
        unsigned count = 8;
        hb_ot_var_get_axis_infos(face, 0, &count, axes);
        hb_face_destroy(face);
        const auto at = [&](auto&& value_of) {
            face_instance corner = plain;
            for (unsigned a = 0; a < count; ++a) {
                typemesh::variation v;
                for (int k = 0; k < 4; ++k) v.tag[k] = static_cast<char>(axes[a].tag >> (24 - 8 * k) & 0xFF);
                v.value = value_of(a);
                corner.variations.push_back(v);
            }
            all.push_back(corner);
        };
        for (unsigned a = 0; a < count; ++a) {
            at([&](unsigned b) { return a == b ? axes[b].min_value : axes[b].default_value; });
            at([&](unsigned b) { return a == b ? axes[b].max_value : axes[b].default_value; });
        }
        if (count > 1) {
            at([&](unsigned b) { return axes[b].min_value; });
            at([&](unsigned b) { return axes[b].max_value; });
            at([&](unsigned b) { return b % 2 == 0 ? axes[b].min_value : axes[b].max_value; });
            at([&](unsigned b) { return b % 2 == 0 ? axes[b].max_value : axes[b].min_value; });
        }
    }
    hb_blob_destroy(blob);
    return all;
}

}  // namespace test
