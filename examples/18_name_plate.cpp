// SPDX-License-Identifier: MIT
//
// A plate with a text, as STL files for a 3D printer: one file, or two for an inlay in two colours.
//
//     18_name_plate FONT TEXT standing|engraved|cut|inlay|stamp|stencil|sticker FILE.stl [MILLIMETRES_PER_EM]
//
// An inlay writes FILE.stl and FILE.stl.inlay.stl.

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/plate/name_plate.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace {

using namespace typemesh;

/// Writes a mesh as binary STL, whose numbers are little-endian, as on all common machines.
bool write_stl(const std::string& path, const std::vector<vec3>& vertices, const std::vector<std::uint32_t>& indices)
{
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) return false;
    const char header[80] = "typemesh";
    const auto triangles = static_cast<std::uint32_t>(indices.size() / 3);
    bool ok = std::fwrite(header, sizeof header, 1, file) == 1 && std::fwrite(&triangles, 4, 1, file) == 1;
    for (std::size_t i = 0; i < indices.size() && ok; i += 3) {
        const vec3 corners[4] = {{}, vertices[indices[i]], vertices[indices[i + 1]], vertices[indices[i + 2]]};
        const std::uint16_t attributes = 0;
        ok = std::fwrite(corners, sizeof corners, 1, file) == 1 && std::fwrite(&attributes, 2, 1, file) == 1;
    }
    return std::fclose(file) == 0 && ok;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc < 5) return std::puts("usage: 18_name_plate FONT TEXT STYLE FILE.stl [MILLIMETRES_PER_EM]"), 2;
    auto font = harfbuzz_font::open(argv[1]);
    if (!font) return std::puts(font.error().message()), 1;

    const std::string style = argv[3];
    plate_options how{.thickness = 0.15f, .depth = 0.08f};
    if (style == "engraved")
        how.style = plate_style::engraved;
    else if (style == "inlay")
        how.style = plate_style::inlay;
    else if (style == "cut" || style == "stencil")
        how.style = plate_style::cut;
    else if (style != "standing" && style != "stamp" && style != "sticker")
        return std::puts("This style is unknown."), 2;
    how.mirrored = style == "stamp";
    if (style == "stencil") how.bridge_width = 0.05f;
    how.fill_counters = style == "sticker";
    if (style == "sticker") how.ring_hole = 0.07f;

    const text_options text_in_mm{.size = argc > 5 ? std::strtof(argv[5], nullptr) : 20.0f};
    text_mesher mesher{*font, flat{}};
    const auto text = mesher.plan(argv[2], text_in_mm);
    if (!text) return std::puts(text.error().message()), 1;
    name_plate plate;
    error failed;
    if (style == "sticker") {
        text_mesher bolder{*font, embolden{.by = 0.1f}, flat{}};
        const auto outline = bolder.plan(argv[2], text_in_mm);
        if (!outline) return std::puts(outline.error().message()), 1;
        failed = plate.plan(*text, *outline, how, constrained_delaunay{}).error();
    } else {
        failed = plate.plan(*text, how, constrained_delaunay{}).error();
    }
    if (failed) return std::puts(failed.message()), 1;

    for (std::size_t k = 0; k < plate.solid_count(); ++k) {
        constexpr auto position = [](const surface_point<attribute::position>& p) noexcept { return p.position; };
        std::vector<vec3> vertices;
        std::vector<std::uint32_t> indices;
        const auto written = plate.write(k, into(vertices, indices, position));
        if (!written) return std::puts(written.error().message()), 1;
        const std::string path = k == 0 ? std::string{argv[4]} : std::string{argv[4]} + ".inlay.stl";
        if (!write_stl(path, vertices, indices)) return std::puts("The file could not be written."), 1;
        const double unit = plate.placement().at.unit_per_cell;
        std::printf("%s: %zu triangles, %.3f cubic mm\n", path.c_str(), indices.size() / 3,
                    unit * unit * plate.solid(k).volume());
    }
    if (how.bridge_width > 0.0f)
        std::printf("%u islands, %u bridges, %u loose\n", plate.stencil().islands, plate.stencil().bridges,
                    plate.stencil().loose);
    return plate.is_manifold() ? 0 : 1;
}
