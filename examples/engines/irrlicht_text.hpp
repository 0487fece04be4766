// SPDX-License-Identifier: MIT
#pragma once

// typemesh for a program that is not compiled as C++20. Irrlicht 1.8's own header cannot be (its irrXML.h writes a
// constructor as `xmlChar<T>()`, which C++20 no longer allows), and typemesh needs C++20. So each has a source file of
// its own, and this header stands between them: it includes neither and is plain C++11.
//
//     your sources            C++98 to C++17   irrlicht.h, engines/irrlicht.hpp, which includes this header
//     irrlicht_text.cpp       C++20            typemesh, and this header
//
// Every engine with an older standard is served like this; only text_vertex is Irrlicht's.

#include <cstddef>
#include <cstdint>
#include <memory>

namespace engines {
namespace irrlicht {

/// The bytes of irr::video::S3DVertex; engines/irrlicht.hpp asserts it.
struct text_vertex {
    float position[3];
    float normal[3];
    std::uint32_t colour;  ///< 0xAARRGGBB
    float uv[2];
};

/// A font, and texts of it as meshes: left-handed, y up, to be read from -z, front faces clockwise, v downwards, an em
/// is 1. What can fail returns a sentence, or nullptr if all is well.
class text {
public:
    text();
    ~text();
    text(const text&) = delete;
    text& operator=(const text&) = delete;

    const char* open(const char* font_file);

    /// Plans a text; vertices() and indices() are exact then.
    const char* plan(const char* utf8);
    std::size_t vertices() const;
    std::size_t indices() const;

    /// Writes what was planned last, each element once: vertices() of one, indices() of the other. 16 bits number
    /// 65,535 vertices.
    const char* write(text_vertex* to_vertices, std::uint16_t* to_indices, std::uint32_t colour) const;
    const char* write(text_vertex* to_vertices, std::uint32_t* to_indices, std::uint32_t colour) const;

private:
    struct made;
    std::unique_ptr<made> made_;
};

}  // namespace irrlicht
}  // namespace engines
