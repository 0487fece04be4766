// SPDX-License-Identifier: MIT
//
// OpenGL itself draws texts whose vertices and indices were written straight into mapped buffers.

#include "opengl_context.hpp"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include "engines/opengl.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "engines/recipe_laws.hpp"
#include "engines_run/glyph_coverage.hpp"

namespace {

using namespace typemesh;
namespace recipe = engines::opengl;

// --- a small renderer

constexpr const char* vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
uniform mat4 to_clip;
out vec3 surface_normal;
void main() { surface_normal = normal.xyz; gl_Position = to_clip * vec4(position, 1.0); }
)";

// The normal as a colour, and in alpha which side is seen: 1 the front, 0.5 the back, and 0 where nothing is. Beside it
// the triangle's number.
constexpr const char* fragment_shader = R"(#version 330 core
in vec3 surface_normal;
layout(location = 0) out vec4 colour;
layout(location = 1) out int triangle;
void main() {
    colour = vec4(normalize(surface_normal) * 0.5 + 0.5, gl_FrontFacing ? 1.0 : 0.5);
    triangle = gl_PrimitiveID;
}
)";

GLuint compiled(GLenum kind, const char* text)
{
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    REQUIRE(done == GL_TRUE);
    return shader;
}

struct pixel {
    unsigned char r, g, b, a;
    friend bool operator==(const pixel&, const pixel&) = default;
    [[nodiscard]] bool covered() const { return a != 0; }
    [[nodiscard]] bool from_behind() const { return a != 0 && a < 255; }
};
using picture = std::vector<pixel>;

using matrix = std::array<float, 16>;  // columns

matrix operator*(const matrix& a, const matrix& b)
{
    matrix c{};
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t k = 0; k < 4; ++k) c[column * 4 + row] += a[k * 4 + row] * b[column * 4 + k];
    return c;
}

enum class culling { none, backs, fronts };

/// A context, a shader and a picture to draw in.
class studio {
public:
    studio(int width, int height) : width_{width}, height_{height}
    {
        INFO(context_.failure());
        REQUIRE(context_.failure().empty());
        const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
        UNSCOPED_INFO("drawn by " << renderer);
        program_ = glCreateProgram();
        glAttachShader(program_, compiled(GL_VERTEX_SHADER, vertex_shader));
        glAttachShader(program_, compiled(GL_FRAGMENT_SHADER, fragment_shader));
        glLinkProgram(program_);
        glUseProgram(program_);
        GLuint frame = 0, images[3] = {};
        glGenFramebuffers(1, &frame);
        glBindFramebuffer(GL_FRAMEBUFFER, frame);
        glGenRenderbuffers(3, images);
        glBindRenderbuffer(GL_RENDERBUFFER, images[0]);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, images[0]);
        glBindRenderbuffer(GL_RENDERBUFFER, images[1]);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, images[1]);
        glBindRenderbuffer(GL_RENDERBUFFER, images[2]);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_R32I, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_RENDERBUFFER, images[2]);
        const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
        glDrawBuffers(2, both);
        REQUIRE(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
        glViewport(0, 0, width, height);
        glEnable(GL_DEPTH_TEST);
        REQUIRE(glGetError() == GL_NO_ERROR);
    }

    [[nodiscard]] picture draw(GLsizei index_count, const matrix& to_clip, culling cull) const
    {
        glClearColor(0, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        cull == culling::none ? glDisable(GL_CULL_FACE) : glEnable(GL_CULL_FACE);
        glCullFace(cull == culling::fronts ? GL_FRONT : GL_BACK);
        glUniformMatrix4fv(glGetUniformLocation(program_, "to_clip"), 1, GL_FALSE, to_clip.data());
        glDrawElements(GL_TRIANGLES, index_count, GL_UNSIGNED_INT, nullptr);
        picture p(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
        glReadBuffer(GL_COLOR_ATTACHMENT0);
        glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, p.data());
        REQUIRE(glGetError() == GL_NO_ERROR);
        return p;
    }

    /// The triangles of the last picture, by number.
    [[nodiscard]] std::vector<GLint> triangles() const
    {
        std::vector<GLint> t(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
        glReadBuffer(GL_COLOR_ATTACHMENT1);
        glReadPixels(0, 0, width_, height_, GL_RED_INTEGER, GL_INT, t.data());
        REQUIRE(glGetError() == GL_NO_ERROR);
        return t;
    }

    /// Into the folder TYPEMESH_KEEP_PICTURES, if it is named.
    void keep(const picture& p, const std::string& name) const
    {
        const char* folder = std::getenv("TYPEMESH_KEEP_PICTURES");
        std::FILE* file =
            folder == nullptr ? nullptr : std::fopen((std::string{folder} + "/" + name + ".ppm").c_str(), "wb");
        if (file == nullptr) return;
        std::fprintf(file, "P6\n%d %d\n255\n", width_, height_);
        for (int y = height_; y-- > 0;)
            for (int x = 0; x < width_; ++x)
                std::fwrite(
                    &p[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)], 1,
                    3, file);
        std::fclose(file);
    }

    /// OpenGL places corners on a grid of so many pixels.
    [[nodiscard]] double grid_step() const
    {
        GLint bits = 0;
        glGetIntegerv(GL_SUBPIXEL_BITS, &bits);
        return std::ldexp(1.0, -bits);
    }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

private:
    opengl_context context_;
    int width_, height_;
    GLuint program_ = 0;
};

// --- a mesh in mapped buffers

/// A buffer of the graphics card's, seen through a pointer while it is filled.
template <class T>
class mapped {
public:
    mapped(GLenum target, std::size_t count) : target_{target}
    {
        const auto bytes = static_cast<GLsizeiptr>(count * sizeof(T));
        GLuint name = 0;
        glGenBuffers(1, &name);
        glBindBuffer(target, name);
        glBufferData(target, bytes, nullptr, GL_STATIC_DRAW);
        void* const at = glMapBufferRange(target, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
        REQUIRE(at != nullptr);
        elements_ = {static_cast<T*>(at), count};
    }
    [[nodiscard]] std::span<T> elements() const { return elements_; }
    void close() { REQUIRE(glUnmapBuffer(target_) == GL_TRUE); }

private:
    GLenum target_;
    std::span<T> elements_;
};

/// The plan's mesh, bound and described, ready to be drawn.
template <class Plan>
void upload(const Plan& plan)
{
    GLuint layout = 0;
    glGenVertexArrays(1, &layout);
    glBindVertexArray(layout);
    mapped<recipe::vertex> vertices{GL_ARRAY_BUFFER, plan.size().vertices};
    mapped<std::uint32_t> indices{GL_ELEMENT_ARRAY_BUFFER, plan.size().indices()};
    REQUIRE(plan.write(into(vertices.elements(), indices.elements())));
    vertices.close();
    indices.close();
    recipe::describe(glVertexAttribPointer);
    for (GLuint i = 0; i < 4; ++i) glEnableVertexAttribArray(i);
    REQUIRE(glGetError() == GL_NO_ERROR);
}

template <class Plan>
recipes::seen read_back(const Plan& plan)
{
    std::vector<recipe::vertex> vertices(plan.size().vertices);
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(vertices.size() * sizeof(recipe::vertex)),
                       vertices.data());
    recipes::seen mesh = recipes::read<recipe::vertex>(vertices);
    mesh.index.resize(plan.size().indices());
    glGetBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(mesh.index.size() * 4), mesh.index.data());
    return mesh;
}

// --- cameras

/// Looks at the middle of a box from outside: `turn` about the upright, then `tilt` towards its top, in radians.
matrix perspective(const bounds3& box, float turn, float tilt, float aspect)
{
    const float x = (box.low.x + box.high.x) / 2, y = (box.low.y + box.high.y) / 2, z = (box.low.z + box.high.z) / 2;
    const float reach = std::hypot(box.high.x - x, box.high.y - y, box.high.z - z), away = reach * 2.2f;
    const float ct = std::cos(turn), st = std::sin(turn), cu = std::cos(tilt), su = std::sin(tilt);
    const matrix to_middle{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -x, -y, -z, 1};
    const matrix about_y{ct, 0, -st, 0, 0, 1, 0, 0, st, 0, ct, 0, 0, 0, 0, 1};
    const matrix about_x{1, 0, 0, 0, 0, cu, su, 0, 0, -su, cu, 0, 0, 0, -away, 1};
    const float near_z = away - reach * 1.1f, far_z = away + reach * 1.1f, zoom = 1.9f;
    const float scale_z = (far_z + near_z) / (near_z - far_z), shift_z = 2 * far_z * near_z / (near_z - far_z);
    const matrix lens{zoom, 0, 0, 0, 0, zoom * aspect, 0, 0, 0, 0, scale_z, -1, 0, 0, shift_z, 0};
    return lens * about_x * about_y * to_middle;
}

/// Looks along -z at a raster's pixels.
matrix orthographic(const coverage::raster& r, const bounds3& box)
{
    const auto sx = static_cast<float>(2.0 * r.scale / r.width), sy = static_cast<float>(2.0 * r.scale / r.height);
    const float left = static_cast<float>(-r.left) * sx - 1, bottom = static_cast<float>(-r.bottom) * sy - 1;
    const float depth = box.high.z - box.low.z + 1.0f;
    return {sx, 0, 0, 0, 0, sy, 0, 0, 0, 0, -1.0f / depth, 0, left, bottom, 0, 1};
}

/// How far a pixel's middle is from the nearest edge of a triangle in a picture, in pixels.
double to_an_edge(const recipes::seen& mesh, std::size_t triangle, const matrix& to_clip, const studio& s,
                  std::size_t pixel)
{
    double x[3], y[3];
    for (std::size_t k = 0; k < 3; ++k) {
        const vec3 p = mesh.position[mesh.index[3 * triangle + k]];
        double clip[4];
        for (std::size_t row = 0; row < 4; ++row)
            clip[row] = double{to_clip[row]} * p.x + double{to_clip[4 + row]} * p.y + double{to_clip[8 + row]} * p.z +
                        to_clip[12 + row];
        x[k] = (clip[0] / clip[3] + 1.0) * s.width() / 2 -
               static_cast<double>(pixel % static_cast<std::size_t>(s.width())) - 0.5;
        y[k] = (clip[1] / clip[3] + 1.0) * s.height() / 2 -
               static_cast<double>(pixel / static_cast<std::size_t>(s.width())) - 0.5;
    }
    double nearest = 1e9;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const double dx = x[next] - x[k], dy = y[next] - y[k], length = dx * dx + dy * dy;
        const double t = length > 0.0 ? std::clamp(-(x[k] * dx + y[k] * dy) / length, 0.0, 1.0) : 0.0;
        nearest = (std::min)(nearest, std::hypot(x[k] + t * dx, y[k] + t * dy));
    }
    return nearest;
}

// --- what is drawn

struct sample {
    const char *name, *font, *text;
    bool merge = false;
};
constexpr sample samples[] = {
    {"latin", "truetype/dejavu/DejaVuSans.ttf", "Hamburg @&g \xC3\x85\xC3\x9F"},
    {"italic", "truetype/liberation/LiberationSerif-Italic.ttf", "Quartz fjord"},
    {"cubic", "opentype/comic-neue/ComicNeue-Regular.otf", "Cubic & round"},
    {"arabic", "opentype/fonts-hosny-amiri/Amiri-Regular.ttf",
     "\xD8\xA7\xD9\x84\xD8\xB3\xD9\x84\xD8\xA7\xD9\x85 \xD8\xB9\xD9\x84\xD9\x8A\xD9\x83\xD9\x85"},
    {"arabic-merged", "opentype/fonts-hosny-amiri/Amiri-Regular.ttf",
     "\xD8\xA7\xD9\x84\xD8\xB3\xD9\x84\xD8\xA7\xD9\x85 \xD8\xB9\xD9\x84\xD9\x8A\xD9\x83\xD9\x85", true},
    {"hindi", "truetype/lohit-devanagari/Lohit-Devanagari.ttf",
     "\xE0\xA4\xA8\xE0\xA4\xAE\xE0\xA4\xB8\xE0\xA5\x8D\xE0\xA4\xA4\xE0\xA5\x87"},
    {"hebrew", "truetype/culmus/FrankRuehlCLM-Bold.ttf", "\xD7\xA9\xD7\x9C\xD7\x95\xD7\x9D"},
    {"chinese", "truetype/wqy/wqy-microhei.ttc", "\xE4\xBD\xA0\xE5\xA5\xBD\xE4\xB8\x96\xE7\x95\x8C"},
};

template <class Use>
void with_plan(const sample& s, Use use)
{
    auto font = harfbuzz_font::open(font_file(s.font).c_str());
    REQUIRE(font);
    text_mesher mesher{*font};
    text_options o = recipe::options();
    o.merge = s.merge;
    o.layout.align = alignment::left;  // as HarfBuzz places letters, in Hebrew and Arabic, too
    auto plan = mesher.plan(s.text, o);
    REQUIRE(plan);
    REQUIRE(plan->report().complete());
    use(*plan);
}

std::size_t count_if(const picture& p, bool (pixel::*is)() const)
{
    std::size_t n = 0;
    for (const pixel& x : p) n += (x.*is)() ? 1u : 0u;
    return n;
}

}  // namespace

TEST_CASE("what OpenGL holds after its buffers are unmapped is the recipe's mesh", "[engines]")
{
    const studio s{16, 16};
    recipes::bench b;
    auto plan = b.mesher.plan(recipes::word, recipe::options());
    REQUIRE(plan);
    upload(*plan);
    recipes::engine is = recipes::opengl;
    is.off_direction = 0.0025;
    is.off_uv = 1e-3;
    obeys(read_back(*plan), *plan, is);
}

// Corners lie on OpenGL's own grid. Where an edge passes a pixel's middle nearer than a step of it, which of the two faces
// that share the edge lies in front is not decided: about one pixel in 30,000 of these pictures.
TEST_CASE("from outside no back face is seen, and culling them changes no pixel", "[engines]")
{
    const studio s{960, 480};
    for (const sample& text : samples) {
        with_plan(text, [&](const auto& plan) {
            upload(plan);
            const auto count = static_cast<GLsizei>(plan.size().indices());
            const recipes::seen mesh = read_back(plan);
            int view = 0;
            for (const float turn : {0.0f, 0.35f, 1.1f, 2.0f, 3.14159f, 4.0f, 5.6f}) {
                for (const float tilt : {-0.9f, 0.05f, 0.6f}) {
                    INFO(text.name << " turned by " << turn << ", tilted by " << tilt);
                    const matrix camera = perspective(plan.bounds(), turn, tilt, 2.0f);
                    const picture fronts = s.draw(count, camera, culling::backs),
                                  backs = s.draw(count, camera, culling::fronts),
                                  all = s.draw(count, camera, culling::none);
                    const std::vector<GLint> drawn = s.triangles();
                    CHECK(count_if(fronts, &pixel::covered) > 2000);
                    CHECK(count_if(fronts, &pixel::from_behind) == 0);
                    CHECK(count_if(backs, &pixel::from_behind) == count_if(backs, &pixel::covered));
                    std::size_t from_behind = 0, changed = 0, one_sided = 0;
                    for (std::size_t i = 0; i < all.size(); ++i) {
                        if (!all[i].from_behind())
                            changed += all[i] == fronts[i] ? 0u : 1u;
                        else if (to_an_edge(mesh, static_cast<std::size_t>(drawn[i]), camera, s, i) > s.grid_step())
                            ++from_behind;
                        one_sided += fronts[i].covered() == backs[i].covered() ? 0u : 1u;
                    }
                    CHECK(from_behind == 0);
                    CHECK(changed == 0);
                    CHECK(one_sided == 0);  // closed: a line of sight that enters also leaves
                    if (++view == 5) s.keep(all, std::string{"opengl-"} + text.name);
                }
            }
        });
    }
}

TEST_CASE("OpenGL covers the pixels inside the font's outlines, and no others", "[engines]")
{
    const studio s{1200, 240};
    for (const sample& text : samples) {
        INFO(text.name);
        with_plan(text, [&](const auto& plan) {
            upload(plan);
            const bounds3 box = plan.bounds();
            const coverage::raster r{s.width(), s.height(), double{box.low.x} - 0.0513, double{box.low.y} - 0.0517,
                                     100.0};
            REQUIRE((double{box.high.x} - r.left) * r.scale < s.width());
            REQUIRE((double{box.high.y} - r.bottom) * r.scale < s.height());
            const picture drawn =
                s.draw(static_cast<GLsizei>(plan.size().indices()), orthographic(r, box), culling::backs);
            const double margin = quality::high + 0.02 / r.scale;  // and what rounds to parts of a pixel
            const auto wanted = coverage::cover(coverage::outlines(font_file(text.font).c_str(), text.text), r, margin);
            std::size_t inside = 0, unsure = 0, wrong = 0, turned = 0;
            for (std::size_t i = 0; i < drawn.size(); ++i) {
                if (wanted[i] == coverage::seen::near_a_curve) {
                    ++unsure;
                    continue;
                }
                inside += wanted[i] == coverage::seen::inside ? 1u : 0u;
                wrong += drawn[i].covered() == (wanted[i] == coverage::seen::inside) ? 0u : 1u;
                const auto off = [](unsigned char is, int should) { return std::abs(int{is} - should) > 2; };
                if (drawn[i].covered())  // the front faces the viewer
                    turned += off(drawn[i].r, 128) || off(drawn[i].g, 128) || off(drawn[i].b, 255) ? 1u : 0u;
            }
            CHECK(inside > 2000);
            CHECK(unsure < inside);
            CHECK(wrong == 0);
            CHECK(turned == 0);
        });
    }
}
