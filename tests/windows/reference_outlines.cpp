// SPDX-License-Identifier: MIT
//
// Draws glyphs of every smoke font, and of every font of the workload, with HarfBuzz and with FreeType, for
// tests/windows to compare with.
//
//     typemesh_reference_outlines FOLDER

#include "windows/reference.hpp"

#include <typemesh/adapt/freetype.hpp>
#include <typemesh/adapt/harfbuzz.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

constexpr std::uint32_t glyphs_of_a_face = 200;

point at(const FT_Vector* v) { return {static_cast<double>(v->x) / 64, static_cast<double>(v->y) / 64}; }

/// The outline in the face's glyph slot, in 26.6.
void record_slot(FT_Face face, outline& out)
{
    FT_Outline_Funcs calls = {};
    calls.move_to = [](const FT_Vector* p, void* to) {
        static_cast<outline_recorder*>(to)->move(at(p));
        return 0;
    };
    calls.line_to = [](const FT_Vector* p, void* to) {
        static_cast<outline_recorder*>(to)->line(at(p));
        return 0;
    };
    calls.conic_to = [](const FT_Vector* c, const FT_Vector* p, void* to) {
        static_cast<outline_recorder*>(to)->quadratic(at(c), at(p));
        return 0;
    };
    calls.cubic_to = [](const FT_Vector* a, const FT_Vector* b, const FT_Vector* p, void* to) {
        static_cast<outline_recorder*>(to)->cubic(at(a), at(b), at(p));
        return 0;
    };
    outline_recorder recorder{out};
    FT_Outline_Decompose(&face->glyph->outline, &calls, &recorder);
    (void)recorder.finish();
}

bool draw(const std::string& path, std::uint32_t number, const std::string& file)
{
    auto harfbuzz = harfbuzz_font::open(path.c_str(), {number, {}});
    auto freetype = freetype_font::open(path.c_str(), {number, {}});
    if (!harfbuzz || !freetype) return false;
    test::reference_face face;
    face.path = path;
    face.face = number;
    face.units_per_em = static_cast<std::uint32_t>(harfbuzz->units_per_em());
    face.glyph_count = harfbuzz->glyph_count();
    const std::uint32_t step = (std::max)(1u, face.glyph_count / glyphs_of_a_face);
    outline a, b, c;
    for (glyph_id id = 0; id < face.glyph_count; id += step) {
        if (!record(*harfbuzz, id, a) || !record(*freetype, id, b)) continue;
        if (FT_Load_Glyph(freetype->handle(), id, FT_LOAD_NO_BITMAP) != 0) continue;
        record_slot(freetype->handle(), c);
        face.glyphs.push_back({id, test::contours_of(a), test::contours_of(b), test::contours_of(c)});
    }
    test::reference_file::write(file, face);
    return true;
}

}  // namespace

int main(int argc, char** argv)
{
    namespace fs = std::filesystem;
    if (argc != 2) return std::puts("usage: typemesh_reference_outlines FOLDER"), 2;
    const char* folders[] = {"truetype/dejavu",
                             "truetype/liberation",
                             "../wine/fonts",
                             "opentype/comic-neue",
                             "opentype/fonts-hosny-amiri",
                             "truetype/awami",
                             "truetype/lohit-devanagari",
                             "opentype/tlwg",
                             "truetype/culmus",
                             "truetype/wqy",
                             "truetype/sawarabi-mincho",
                             "truetype/inter-vf",
                             "truetype/ancient-scripts",
                             "opentype/mplus"};
    std::vector<fs::path> fonts;
    for (const char* folder : folders) {
        const fs::path whole = fs::path{"/usr/share/fonts"} / folder;
        if (!fs::is_directory(whole)) continue;
        for (const auto& entry : fs::directory_iterator{whole})
            if (const auto kind = entry.path().extension(); kind == ".ttf" || kind == ".otf" || kind == ".ttc")
                fonts.push_back(fs::canonical(entry.path()));
    }
    std::sort(fonts.begin(), fonts.end());
    unsigned count = 0;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator{argv[1]})
        if (entry.path().extension() == ".outlines") fs::remove(entry.path(), ignored);
    for (const fs::path& path : fonts)
        for (std::uint32_t face = 0; face < 64; ++face) {
            char name[32];
            std::snprintf(name, sizeof name, "%04u.outlines", count);
            if (!draw(path.string(), face, (fs::path{argv[1]} / name).string())) break;
            ++count;
        }
    std::printf("%u faces drawn for comparison\n", count);
    return count == 0 ? 1 : 0;
}
