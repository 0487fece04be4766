// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace peers {

/// A solid: triangles, counter-clockwise as seen from outside, the em 1 long, the pen's start at the origin, z along the depth.
struct mesh {
    std::vector<float> points;  ///< x, y, z each
    std::vector<std::uint32_t> corners;

    [[nodiscard]] std::size_t vertices() const { return points.size() / 3; }
    [[nodiscard]] std::size_t triangles() const { return corners.size() / 3; }
};

/// Meshes of single characters, as every peer writes them for the judge: a line with the peer's name, its setting and the
/// font's file, parted by tabs; then for each character, little-endian: code point, vertices, triangles (32 bits each), points
/// (floats), corners (32 bits each).
struct mesh_file {
    struct glyph {
        std::uint32_t character;
        peers::mesh mesh;
    };
    std::string peer, setting, font;
    std::vector<glyph> glyphs;

    [[nodiscard]] bool write(const std::string& path) const
    {
        std::FILE* out = std::fopen(path.c_str(), "wb");
        if (out == nullptr) return false;
        std::fprintf(out, "%s\t%s\t%s\n", peer.c_str(), setting.c_str(), font.c_str());
        for (const glyph& g : glyphs) {
            const std::uint32_t counts[] = {g.character, std::uint32_t(g.mesh.vertices()),
                                            std::uint32_t(g.mesh.triangles())};
            std::fwrite(counts, sizeof counts, 1, out);
            std::fwrite(g.mesh.points.data(), 4, g.mesh.points.size(), out);
            std::fwrite(g.mesh.corners.data(), 4, g.mesh.corners.size(), out);
        }
        return std::fclose(out) == 0;
    }

    [[nodiscard]] bool read(const std::string& path)
    {
        std::FILE* in = std::fopen(path.c_str(), "rb");
        if (in == nullptr) return false;
        std::string* words[] = {&peer, &setting, &font};
        for (std::string* word : words)
            for (int c = std::fgetc(in); c != EOF && c != '\t' && c != '\n'; c = std::fgetc(in)) *word += char(c);
        std::uint32_t counts[3];
        bool whole = true;
        while (whole && std::fread(counts, sizeof counts, 1, in) == 1) {
            glyph& g = glyphs.emplace_back();
            g.character = counts[0];
            g.mesh.points.resize(std::size_t{counts[1]} * 3);
            g.mesh.corners.resize(std::size_t{counts[2]} * 3);
            whole = std::fread(g.mesh.points.data(), 4, g.mesh.points.size(), in) == g.mesh.points.size() &&
                    std::fread(g.mesh.corners.data(), 4, g.mesh.corners.size(), in) == g.mesh.corners.size();
        }
        std::fclose(in);
        return whole && !peer.empty();
    }
};

}  // namespace peers
