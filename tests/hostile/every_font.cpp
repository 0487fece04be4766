// SPDX-License-Identifier: MIT
//
// Every glyph of every font file of a folder, through HarfBuzz and through FreeType, with every kind of policy.
//
//     every_font FOLDER [GLYPHS]     GLYPHS: at most so many of each font; else all
//
// Prints what became of them; fails if any broke a law or took more than 20 s.
#include "glyph_trials.hpp"

#include <typemesh/adapt/freetype.hpp>
#include <typemesh/adapt/harfbuzz.hpp>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace {

std::vector<std::byte> bytes_of(const std::filesystem::path& file)
{
    std::ifstream in{file, std::ios::binary};
    const std::string read{std::istreambuf_iterator<char>{in}, {}};
    const auto* first = reinterpret_cast<const std::byte*>(read.data());
    return {first, first + read.size()};
}

void print(const hostile::trials& seen, std::size_t files)
{
    std::printf("files      %zu\nglyphs     %llu, of both libraries, of which %llu are blank\n", files,
                static_cast<unsigned long long>(seen.glyphs), static_cast<unsigned long long>(seen.blank));
    std::printf("meshes     %llu, with %llu triangles\n", static_cast<unsigned long long>(seen.meshes),
                static_cast<unsigned long long>(seen.triangles));
    for (const auto& [words, times] : seen.refusals)
        std::printf("refused    %7llu  %s\n", static_cast<unsigned long long>(times), words.c_str());
    std::printf("most time  %.3f s: %s\n", seen.seconds.value, seen.seconds.where.c_str());
    std::printf("most memory  %.1f MB: %s\n", seen.bytes.value / 1e6, seen.bytes.where.c_str());
    std::printf("most points  %.0f: %s\n", seen.points.value, seen.points.where.c_str());
    for (const auto& [words, times] : seen.broken)
        std::printf("BROKEN     %7llu  %s\n", static_cast<unsigned long long>(times), words.c_str());
}

}  // namespace

int main(int count, char** words)
{
    if (count < 2) return std::fputs("every_font FOLDER [GLYPHS]\n", stderr), 2;
    const auto most = count > 2 ? static_cast<std::uint32_t>(std::strtoul(words[2], nullptr, 10)) : 0u;
    std::set<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator{words[1]})
        if (entry.is_regular_file() && entry.path().extension() != ".md") files.insert(entry.path());
    hostile::trials seen;
    for (const auto& file : files) {
        const auto bytes = bytes_of(file);
        const std::string name = file.filename().string();
        hostile::try_glyphs<typemesh::harfbuzz_font>(bytes, name + " (HarfBuzz)", most, seen);
        hostile::try_glyphs<typemesh::freetype_font>(bytes, name + " (FreeType)", most, seen);
    }
    print(seen, files.size());
    return files.empty() || !seen.broken.empty() || seen.seconds.value > 20.0 ? 1 : 0;
}
