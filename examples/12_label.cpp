// SPDX-License-Identifier: MIT
//
// A class of a program's own that holds font, mesher and mesh: its text changes, its memory stays.
//
//     12_label FONT TEXT...

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

namespace {

using namespace typemesh;

class label {
public:
    static result<label> open(const char* path)
    {
        auto font = harfbuzz_font::open(path);
        if (!font) return font.error();
        return label{std::make_unique<harfbuzz_font>(std::move(*font))};
    }

    /// Makes the mesh of this text. After an error the label keeps the mesh of the text before.
    result<text_report> show(text_view text)
    {
        constexpr auto position = [](const surface_point<attribute::position>& s) noexcept { return s.position; };
        return mesher_.build(text, into(vertices_, indices_, position));
    }
    [[nodiscard]] std::size_t triangles() const { return indices_.size() / 3; }

private:
    explicit label(std::unique_ptr<harfbuzz_font> font) : font_{std::move(font)}, mesher_{*font_} {}

    std::unique_ptr<harfbuzz_font> font_;  // the mesher refers to it: it lives longer, and stays where it is
    text_mesher<> mesher_;
    std::vector<vec3> vertices_;
    std::vector<std::uint32_t> indices_;
};

}  // namespace

int main(int argc, char** argv)
{
    if (argc < 3) return std::puts("usage: 12_label FONT TEXT..."), 2;
    auto opened = label::open(argv[1]);
    if (!opened) return std::puts(opened.error().message()), 1;
    label score = std::move(*opened);
    for (int i = 2; i < argc; ++i) {
        const auto shown = score.show(argv[i]);
        if (!shown) return std::puts(shown.error().message()), 1;
        std::printf("%s: %zu triangles, %u characters missing\n", argv[i], score.triangles(), shown->missing);
    }
}
