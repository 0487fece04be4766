// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/text/font_list.hpp>

#include <cstdlib>
#include <memory>
#include <utility>

namespace typemesh_web {

/// A font with its bytes, which malloc() gave.
struct opened_font {
    struct give_back {
        void operator()(std::byte* bytes) const noexcept { std::free(bytes); }
    };

    std::unique_ptr<std::byte, give_back> bytes;  // ends after the font, which reads them
    typemesh::harfbuzz_font font;

    opened_font(std::byte* taken, typemesh::harfbuzz_font&& made) noexcept : bytes{taken}, font{std::move(made)} {}
};

/// Both the page and the meshers that use it hold a font.
using shared_font = std::shared_ptr<opened_font>;
using font_set = typemesh::font_list<typemesh::harfbuzz_font>;

}  // namespace typemesh_web
