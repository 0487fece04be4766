// SPDX-License-Identifier: MIT
//
// FTGL. It draws by OpenGL's immediate calls and has no other output: those calls are defined here and collect vertices. With
// display lists it makes a letter once, and calls its list again: that is reuse, and while the lists are kept, placing.

#include "peer_program.hpp"

#include <FTGL/ftgl.h>
#include <GL/gl.h>

#include <map>
#include <memory>

namespace {

constexpr float em = 1024.0f;  // large enough that what FreeType rounds does not count

/// What a program would keep of the calls: positions, normals and texture coordinates of each vertex, triangles by index.
struct collected {
    struct vertex {
        float position[3], normal[3], uv[2];
    };
    std::vector<vertex> vertices;
    std::vector<std::uint32_t> corners;
};
collected drawn;
std::map<GLuint, collected> lists;
collected* target = &drawn;
GLuint lists_made = 0;
GLenum primitive = 0;
std::size_t first = 0;
collected::vertex current{};
float shift[3] = {};
bool only_placing = false;
struct called {
    GLuint list;
    float at[3];
};
std::vector<called> calls;

void corner(std::size_t a, std::size_t b, std::size_t c)
{
    for (const std::size_t i : {a, b, c}) target->corners.push_back(std::uint32_t(first + i));
}

}  // namespace

extern "C" {
void glBegin(GLenum mode) { primitive = mode, first = target->vertices.size(); }
void glEnd()
{
    const std::size_t n = target->vertices.size() - first;
    for (std::size_t i = 2; i < n; ++i) {
        if (primitive == GL_TRIANGLES && i % 3 == 2) corner(i - 2, i - 1, i);
        if (primitive == GL_TRIANGLE_FAN) corner(0, i - 1, i);
        if (primitive == GL_TRIANGLE_STRIP || primitive == GL_QUAD_STRIP)
            i % 2 == 0 ? corner(i - 2, i - 1, i) : corner(i - 1, i - 2, i);
    }
}
void glVertex3f(GLfloat x, GLfloat y, GLfloat z)
{
    current.position[0] = x + shift[0], current.position[1] = y + shift[1], current.position[2] = z + shift[2];
    target->vertices.push_back(current);
}
void glVertex2f(GLfloat x, GLfloat y) { glVertex3f(x, y, 0); }
void glNormal3f(GLfloat x, GLfloat y, GLfloat z)
{
    current.normal[0] = x, current.normal[1] = y, current.normal[2] = z;
}
void glNormal3d(GLdouble x, GLdouble y, GLdouble z) { glNormal3f(GLfloat(x), GLfloat(y), GLfloat(z)); }
void glNormal3dv(const GLdouble* n) { glNormal3d(n[0], n[1], n[2]); }
void glTexCoord2f(GLfloat u, GLfloat v) { current.uv[0] = u, current.uv[1] = v; }
void glTranslatef(GLfloat x, GLfloat y, GLfloat z) { shift[0] += x, shift[1] += y, shift[2] += z; }
GLuint glGenLists(GLsizei n) { return (lists_made += GLuint(n)) - GLuint(n) + 1; }
void glNewList(GLuint list, GLenum) { target = &(lists[list] = {}); }
void glEndList() { target = &drawn; }
void glDeleteLists(GLuint list, GLsizei n)
{
    for (; n-- > 0; ++list) lists.erase(list);
}
void glCallList(GLuint list)
{
    if (only_placing) return calls.push_back({list, {shift[0], shift[1], shift[2]}});
    const collected& from = lists[list];
    const auto base = std::uint32_t(drawn.vertices.size());
    for (collected::vertex v : from.vertices) {
        for (int i = 0; i < 3; ++i) v.position[i] += shift[i];
        drawn.vertices.push_back(v);
    }
    for (const std::uint32_t c : from.corners) drawn.corners.push_back(base + c);
}
void glPushAttrib(GLbitfield) {}
void glPopAttrib() {}
void glEnable(GLenum) {}
void glDisable(GLenum) {}
void glHint(GLenum, GLenum) {}
void glPolygonMode(GLenum, GLenum) {}
void glBlendFunc(GLenum, GLenum) {}
void glTexEnvi(GLenum, GLenum, GLint) {}
}

namespace {

std::shared_ptr<FTExtrudeFont> font_of(const std::string& file, bool lists_too)
{
    auto font = std::make_shared<FTExtrudeFont>(file.c_str());
    if (font->Error() != 0) return nullptr;
    font->Depth(float(peers::depth) * em);
    font->UseDisplayList(lists_too);
    font->FaceSize(unsigned(em));
    return font;
}

bool draw(FTFont& font, const std::string& text)
{
    drawn.vertices.clear(), drawn.corners.clear(), calls.clear();
    shift[0] = shift[1] = shift[2] = 0;
    font.Render(text.c_str());
    return !drawn.corners.empty() || !calls.empty();
}

peers::mesh made()
{
    peers::mesh m;
    for (const collected::vertex& v : drawn.vertices)
        for (const float x : v.position) m.points.push_back(x / em);
    m.corners = drawn.corners;
    return m;
}

std::vector<peers::way> open(const std::string& file)
{
    const auto plain = font_of(file, false), listed = font_of(file, true), kept = font_of(file, true);
    if (!plain || !listed || !kept) return {};
    const auto anew = [](const std::shared_ptr<FTExtrudeFont>& font) {
        return [font](const std::string& text) {
            font->FaceSize(unsigned(em));  // forgets its glyphs
            return draw(*font, text);
        };
    };
    return {
        {"5 steps a curve", "extruded", "cold", anew(plain), made},
        {"5 steps a curve", "extruded", "reuse", anew(listed), made},
        {"5 steps a curve",
         "extruded",
         "placed",
         [kept](const std::string& text) {
             only_placing = true;
             const bool drew = draw(*kept, text);
             only_placing = false;
             return drew;
         },
         {}},
    };
}

}  // namespace

int main(int argc, char** argv) { return peers::run(argc, argv, "FTGL", open); }
