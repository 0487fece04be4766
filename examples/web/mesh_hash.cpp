// SPDX-License-Identifier: MIT

// The native counterpart of typemesh.wasm: prints the hash of a text's mesh, which is to be the same.
//
//     mesh_hash TEXT --font FILE [--font FILE...] [bevel.width=0.02 ...]        {"hash":"...","vertices":...}
//     mesh_hash TEXT --weight 800 --font FILE                                   of a variable font
//     mesh_hash TEXT --font FILE --time MILLISECONDS                            and how long a mesh takes

#include "mesh_checks.hpp"
#include "session.hpp"

#include <typemesh/unicode/utf.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

using namespace typemesh_web;

namespace {

int refuse(const std::string& why)
{
    std::fprintf(stderr, "mesh_hash: %s\n", why.c_str());
    return 1;
}

std::string open(const char* path, double weight, std::vector<shared_font>& fonts)
{
    std::ifstream file{path, std::ios::binary};
    const std::string content{std::istreambuf_iterator<char>{file}, {}};
    if (content.empty()) return std::string{path} + " cannot be read.";
    auto* bytes = static_cast<std::byte*>(std::malloc(content.size()));
    if (bytes == nullptr) return "There is no memory for a font.";
    std::copy_n(reinterpret_cast<const std::byte*>(content.data()), content.size(), bytes);
    const typemesh::variation heavier[] = {{"wght", static_cast<float>(weight)}};
    const auto variations = std::span{heavier}.first(weight > 0.0 ? 1 : 0);
    auto font = typemesh::harfbuzz_font::open(std::span<const std::byte>{bytes, content.size()},
                                              {.face = 0, .variations = variations});
    if (!font) return std::free(bytes), std::string{path} + ": " + font.error().message();
    fonts.push_back(std::make_shared<opened_font>(bytes, std::move(*font)));
    return {};
}

/// A text as JavaScript has it.
std::u16string utf16(const std::string& text)
{
    std::u16string all;
    for (std::size_t i = 0; i < text.size();) {
        const auto read = typemesh::decode(typemesh::text_view{text}, i);
        const char32_t c = read.value;
        if (c >= 0x10000) all += static_cast<char16_t>(0xD7C0 + (c >> 10));
        all += static_cast<char16_t>(c >= 0x10000 ? 0xDC00 + (c & 0x3FF) : c);
        i = read.next;
    }
    return all;
}

/// The least microseconds of a mesh within the time given.
double time_of(session& made, const std::u16string& text, double milliseconds)
{
    using clock = std::chrono::steady_clock;
    double least = 1e30;
    const auto begun = clock::now();
    do {
        const auto before = clock::now();
        if (!made.make(text, false)) return 0.0;
        least = std::min(least, std::chrono::duration<double, std::micro>(clock::now() - before).count());
    } while (std::chrono::duration<double, std::milli>(clock::now() - begun).count() < milliseconds);
    return least;
}

}  // namespace

int main(int argc, char** argv)
{
    std::string text;
    std::vector<shared_font> fonts;
    settings how;
    double milliseconds = 0.0, weight = 0.0;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--font" && i + 1 < argc) {
            if (std::string why = open(argv[++i], weight, fonts); !why.empty()) return refuse(why);
        } else if (word == "--weight" && i + 1 < argc) {
            weight = std::atof(argv[++i]);
        } else if (word == "--time" && i + 1 < argc) {
            milliseconds = std::atof(argv[++i]);
        } else if (i == 1) {
            text = word;
        } else if (!set_by_name(how, word)) {
            return refuse("There is no such option or value: " + std::string{word});
        }
    }
    if (fonts.empty()) return refuse("usage: mesh_hash TEXT --font FILE [--time MILLISECONDS] [OPTION=VALUE...]");
    session made{std::move(fonts)};
    made.set(how);
    if (const char* why = made.refused()) return refuse(why);
    const std::u16string units = utf16(text);
    if (const auto done = made.make(units, false); !done) {
        const char* why = made.explained(done.error());
        return refuse(why != nullptr ? why : done.error().message());
    }
    std::printf("{\"hash\":\"%016llx\",\"vertices\":%zu,\"triangles\":%zu,\"openEdges\":%u",
                static_cast<unsigned long long>(hash_of(made.arrays())), made.arrays().vertices(),
                made.arrays().triangles(), open_edges(made.arrays()));
    if (milliseconds > 0.0) std::printf(",\"microseconds\":%.2f", time_of(made, units, milliseconds));
    std::puts("}");
}
