// SPDX-License-Identifier: MIT
//
// OpenGL draws the triangles of flat_curved with the shader of docs/curves.md, or with the fragment shader in the file that
// TYPEMESH_CURVES_SHADER names. "[scenes]" writes what is drawn, and the right pixels, into the folder TYPEMESH_CURVES_SCENES.

#include <EGL/egl.h>
#include <EGL/eglext.h>
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/extrude/flat_curved.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "engines_run/glyph_coverage.hpp"
#include "support/catch.hpp"
#include "support/font_file.hpp"

namespace {

using namespace typemesh;

struct curved_vertex {
    vec3 position, curve;
};

}  // namespace

template <>
struct typemesh::vertex_traits<curved_vertex> {
    static constexpr auto wants = attribute::position | attribute::curve;
    curved_vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.curve}; }
};

namespace {

/// An OpenGL 3.3 context without a display, current while it lives.
class surfaceless {
public:
    surfaceless() : display_{eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)}
    {
        EGLint major = 0, minor = 0;
        REQUIRE(eglInitialize(display_, &major, &minor));
        REQUIRE(eglBindAPI(EGL_OPENGL_API));
        const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        REQUIRE(eglChooseConfig(display_, wanted, &config, 1, &count));
        const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
        REQUIRE(context_ != EGL_NO_CONTEXT);
        REQUIRE(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_));
    }
    ~surfaceless()
    {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        eglTerminate(display_);
    }
    surfaceless(const surfaceless&) = delete;
    surfaceless& operator=(const surfaceless&) = delete;

private:
    EGLDisplay display_;
    EGLContext context_ = nullptr;
};

std::string content_of(const std::string& name)
{
    std::ifstream file{name};
    REQUIRE(file);
    std::stringstream whole;
    whole << file.rdbuf();
    return whole.str();
}

/// The page's shader, or another one that the environment names.
std::string fragment_shader()
{
    if (const char* other = std::getenv("TYPEMESH_CURVES_SHADER")) return content_of(other);
    const char* const tests = std::getenv("TYPEMESH_TEST_DATA");
    REQUIRE(tests != nullptr);
    const std::string text = content_of(std::string{tests} + "/../docs/curves.md"), begin = "```glsl\n";
    const auto from = text.find(begin);
    REQUIRE(from != std::string::npos);
    return text.substr(from + begin.size(), text.find("```\n", from + begin.size()) - from - begin.size());
}

constexpr const char* vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 at_curve;
uniform vec4 view;
out vec3 curve;
void main() { curve = at_curve; gl_Position = vec4((position.xy - view.xy) * view.zw - 1.0, 0.0, 1.0); }
)";

class renderer {
public:
    renderer()
    {
        program_ = glCreateProgram();
        attach(GL_VERTEX_SHADER, vertex_shader);
        attach(GL_FRAGMENT_SHADER, fragment_shader());
        glLinkProgram(program_);
        GLint done = 0;
        glGetProgramiv(program_, GL_LINK_STATUS, &done);
        REQUIRE(done == GL_TRUE);
        glUseProgram(program_);
        GLuint names[4];
        glGenTextures(1, &names[0]);
        glBindTexture(GL_TEXTURE_2D, names[0]);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glGenFramebuffers(1, &names[1]);
        glBindFramebuffer(GL_FRAMEBUFFER, names[1]);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, names[0], 0);
        REQUIRE(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
        glViewport(0, 0, side, side);
        glGenVertexArrays(1, &names[2]);
        glBindVertexArray(names[2]);
    }

    static constexpr int side = 256;

    /// The alpha of each pixel, the lowest row first. Triangles add up, so that one drawn twice would show.
    std::vector<std::uint8_t> draw(std::span<const curved_vertex> vertices, std::span<const std::uint32_t> indices,
                                   const coverage::raster& r)
    {
        GLuint names[2];
        glGenBuffers(2, names);
        glBindBuffer(GL_ARRAY_BUFFER, names[0]);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size_bytes()), vertices.data(), GL_STATIC_DRAW);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[1]);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size_bytes()), indices.data(),
                     GL_STATIC_DRAW);
        for (GLuint i = 0; i < 2; ++i) {
            const std::size_t offset = i == 0 ? offsetof(curved_vertex, position) : offsetof(curved_vertex, curve);
            glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(curved_vertex), reinterpret_cast<void*>(offset));
            glEnableVertexAttribArray(i);
        }
        const auto scale = static_cast<float>(2.0 * r.scale / side);
        glUniform4f(glGetUniformLocation(program_, "view"), static_cast<float>(r.left), static_cast<float>(r.bottom),
                    scale, scale);
        const GLint colour = glGetUniformLocation(program_, "colour");
        // Translated shaders call it by HLSL's name for all that stands outside.
        glUniform4f(colour >= 0 ? colour : glGetUniformLocation(program_, "_Global[0]"), 1, 1, 1, 1);
        glClearColor(0, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT);
        glEnable(GL_CULL_FACE);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, nullptr);
        std::vector<std::uint8_t> all(std::size_t{4} * side * side), alpha;
        glReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, all.data());
        REQUIRE(glGetError() == GL_NO_ERROR);
        glDeleteBuffers(2, names);
        for (std::size_t i = 3; i < all.size(); i += 4) alpha.push_back(all[i]);
        return alpha;
    }

private:
    void attach(GLenum kind, const std::string& text) const
    {
        const GLuint shader = glCreateShader(kind);
        const char* const lines = text.c_str();
        glShaderSource(shader, 1, &lines, nullptr);
        glCompileShader(shader);
        GLint done = 0;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
        REQUIRE(done == GL_TRUE);
        glAttachShader(program_, shader);
    }

    GLuint program_ = 0;
};

/// Into the folder TYPEMESH_KEEP_PICTURES, if it is named.
void keep(const std::vector<std::uint8_t>& alpha, const std::string& name)
{
    const char* folder = std::getenv("TYPEMESH_KEEP_PICTURES");
    if (folder == nullptr) return;
    std::ofstream file{std::string{folder} + "/" + name + ".pgm", std::ios::binary};
    file << "P5\n" << renderer::side << " " << renderer::side << "\n255\n";
    for (int y = renderer::side; y-- > 0;)
        file.write(reinterpret_cast<const char*>(&alpha[static_cast<std::size_t>(y) * renderer::side]), renderer::side);
}

struct sample {
    const char *name, *font, *text;
};
constexpr sample samples[] = {
    {"latin", "truetype/dejavu/DejaVuSans.ttf", "@&g\xC3\x9F"},
    {"italic", "truetype/liberation/LiberationSerif-Italic.ttf", "Quartz"},
    {"cubic", "opentype/comic-neue/ComicNeue-Regular.otf", "Cubic &"},
    {"overlaps", "truetype/inter-vf/Inter-roman.var.ttf", "\xC3\x86\xE2\x82\xACQ&"},
    {"hindi", "truetype/lohit-devanagari/Lohit-Devanagari.ttf", "\xE0\xA4\xA8\xE0\xA4\xAE\xE0\xA4\xB8"},
    {"chinese", "truetype/wqy/wqy-microhei.ttc", "\xE4\xBD\xA0\xE5\xA5\xBD"},
};

/// A text at a scale, and what its pixels should be.
struct scene {
    std::string name;
    std::span<const curved_vertex> vertices;
    std::span<const std::uint32_t> indices;
    coverage::raster r;
    std::vector<coverage::seen> truth;
};

template <class Take>
void for_each_scene(Take&& take)
{
    for (const sample& s : samples) {
        auto font = harfbuzz_font::open(font_file(s.font).c_str());
        REQUIRE(font);
        text_mesher mesher{*font, flat_curved{}};
        std::vector<curved_vertex> vertices;
        std::vector<std::uint32_t> indices;
        REQUIRE(mesher.build(s.text, into(vertices, indices), {.tolerance = 1e-6}));
        const auto outlines = coverage::outlines(font_file(s.font).c_str(), s.text);
        for (const double scale : {60.0, 250.0, 4000.0, 60000.0}) {
            // At large scales, around a place on an outline.
            coverage::raster r{renderer::side, renderer::side, -0.1, -0.4, scale};
            if (scale > 300.0) {
                const auto& segment = outlines[0].segments[outlines[0].segments.size() / 3];
                r.left = segment.x0 - 0.5 * renderer::side / scale;
                r.bottom = segment.y0 - 0.5 * renderer::side / scale;
            }
            // The oracle has 64 chords for each curve: up to 1/16000 em beside it.
            const double margin = 0.1 / scale + (scale > 300.0 ? 1.0 / 16000 : 0.0);
            take(scene{std::string{s.name} + "-" + std::to_string(static_cast<int>(scale)), vertices, indices, r,
                       coverage::cover(outlines, r, margin)});
        }
    }
}

}  // namespace

TEST_CASE("OpenGL draws curved triangles with the page's shader: every pixel is as the outlines say, at every zoom",
          "[engines]")
{
    const surfaceless context;
    renderer draws;
    std::size_t inside = 0, outside = 0, soft = 0;
    for_each_scene([&](const scene& s) {
        const auto alpha = draws.draw(s.vertices, s.indices, s.r);
        keep(alpha, s.name);
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < s.truth.size(); ++i) {
            if (s.truth[i] == coverage::seen::near_a_curve) continue;
            const bool is_inside = s.truth[i] == coverage::seen::inside;
            wrong += is_inside ? alpha[i] < 128 : alpha[i] > 128;
            soft += alpha[i] != 0 && alpha[i] != 255;
            (is_inside ? inside : outside) += 1;
        }
        INFO(s.name << " pixels per em");
        CHECK(wrong == 0);
    });
    CAPTURE(inside, outside, soft);
    CHECK(inside > 100000);
    CHECK(outside > 100000);
    CHECK(soft > 1000);
}

// For renderers that are no program of C++: a file for each scene. All numbers have four bytes.
//
//     the counts of vertices and indices; left, bottom, units to the right and up per pixel of a picture 2 wide and high
//     position and curve of each vertex; the indices; a byte for each pixel, the lowest row first: 0 either, 1 in, 2 out
TEST_CASE("the scenes for other renderers", "[.scenes]")
{
    const char* folder = std::getenv("TYPEMESH_CURVES_SCENES");
    REQUIRE(folder != nullptr);
    for_each_scene([&](const scene& s) {
        std::ofstream file{std::string{folder} + "/" + s.name, std::ios::binary};
        const auto put = [&file](const auto* first, std::size_t bytes) {
            file.write(reinterpret_cast<const char*>(first), static_cast<std::streamsize>(bytes));
        };
        const std::uint32_t counts[] = {static_cast<std::uint32_t>(s.vertices.size()),
                                        static_cast<std::uint32_t>(s.indices.size())};
        const auto scale = static_cast<float>(2.0 * s.r.scale / renderer::side);
        const float view[] = {static_cast<float>(s.r.left), static_cast<float>(s.r.bottom), scale, scale};
        put(counts, sizeof counts);
        put(view, sizeof view);
        put(s.vertices.data(), s.vertices.size_bytes());
        put(s.indices.data(), s.indices.size_bytes());
        for (const coverage::seen one : s.truth)
            file.put(one == coverage::seen::near_a_curve ? '\0' : one == coverage::seen::inside ? '\1' : '\2');
        REQUIRE(file.flush());
    });
}
