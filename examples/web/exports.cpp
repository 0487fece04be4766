// SPDX-License-Identifier: MIT

// What typemesh.js calls. Pointers are numbers there. Texts are UTF-16; what is returned lives until the next call, unless
// it says otherwise.

#include "mesh_checks.hpp"
#include "session.hpp"

#include <hb-ot.h>

#include <algorithm>
#include <array>
#include <string>

#define TYPEMESH_WEB_EXPORT extern "C" __attribute__((used, visibility("default")))

using namespace typemesh_web;

namespace {

/// Why the last call has failed.
struct failure {
    const char* message = "";
    std::uint32_t at = typemesh::no_cluster;
};

struct web_variation {
    std::uint32_t tag;
    float value;
};

struct web_axis {
    std::uint32_t tag;
    float minimum, usual, maximum;
    const char* name;
};

struct web_font {
    shared_font font;
    std::string family, style;
    std::vector<std::string> axis_names;
    std::vector<web_axis> axes;
};

/// As JavaScript reads it, number by number.
struct font_facts {
    std::uint32_t units_per_em, glyph_count, face_count;
    const char *family, *style;
    const web_axis* axes;
    std::uint32_t axis_count;
};

/// Likewise. Floats lie where JavaScript reads them as such.
struct web_mesh {
    const float *position, *normal, *uv;
    const std::uint32_t* index;
    std::uint32_t vertices, triangles;
    const web_part* parts;
    std::uint32_t part_count;
    const web_letter* letters;
    std::uint32_t letter_count;
    const std::uint32_t* instances;
    const float* translations;
    std::uint32_t instance_count;
    float bounds[6];
    std::uint32_t glyphs, lines, contour_points;
    std::uint32_t missing, first_missing, refused, narrowed, invalid_units, unbroken;
    const char* first_refusal;
    float plan_microseconds;
    const std::uint32_t* letter_of;
    const float* letter_rows;
    std::uint32_t letter_row_count;
    const std::uint32_t* tints;
    std::uint32_t tint_count;
    float advance;
};

struct web_mesher {
    session made;
    settings next;
    std::vector<float> segments;
    web_mesh result{};
    char words[256] = "";

    explicit web_mesher(std::vector<shared_font> fonts) : made{std::move(fonts)} {}
};

failure last;
char sentence[256];

std::uint32_t fail(const typemesh::error& e)
{
    last = {typemesh::describe(e.at(typemesh::no_glyph, typemesh::no_cluster), sentence), e.cluster};
    return 1;
}

std::uint32_t fail(const char* why)
{
    last = {why, typemesh::no_cluster};
    return 1;
}

/// What the mesher says of it, or else the library.
std::uint32_t fail(web_mesher& m, const typemesh::error& e)
{
    const char* const why = m.made.explained(e);
    if (why == nullptr) return fail(e);
    last = {why, e.cluster};
    return 1;
}

std::string name_of(hb_face_t* face, hb_ot_name_id_t id)
{
    char text[256];
    unsigned size = sizeof text;
    hb_ot_name_get_utf8(face, id, hb_language_from_string("en", 2), &size, text);
    return text;
}

void read_axes(hb_face_t* face, web_font& to)
{
    std::array<hb_ot_var_axis_info_t, 64> axes{};
    unsigned count = axes.size();
    hb_ot_var_get_axis_infos(face, 0, &count, axes.data());
    for (unsigned i = 0; i < count; ++i) to.axis_names.push_back(name_of(face, axes[i].name_id));
    for (unsigned i = 0; i < count; ++i)
        to.axes.push_back(
            {axes[i].tag, axes[i].min_value, axes[i].default_value, axes[i].max_value, to.axis_names[i].c_str()});
}

}  // namespace

TYPEMESH_WEB_EXPORT const failure* web_failure() { return &last; }

TYPEMESH_WEB_EXPORT const char* web_version()
{
#define TYPEMESH_WEB_WORD(number) #number
#define TYPEMESH_WEB_VERSION(a, b, c) TYPEMESH_WEB_WORD(a) "." TYPEMESH_WEB_WORD(b) "." TYPEMESH_WEB_WORD(c)
    return TYPEMESH_WEB_VERSION(TYPEMESH_VERSION_MAJOR, TYPEMESH_VERSION_MINOR, TYPEMESH_VERSION_PATCH);
}

/// A line an option: name, kind, choices, default, with tabs between.
TYPEMESH_WEB_EXPORT const char* web_options()
{
    static std::string all;
    constexpr const char* kinds[] = {"number", "boolean", "choice", "string", "numbers", "features"};
    all.clear();
    for (const option& o : all_options())
        all += std::string{o.name} + '\t' + kinds[static_cast<int>(o.kind)] + '\t' + o.choices + '\t' + o.usual + '\n';
    return all.c_str();
}

/// The names of parts, with spaces between.
TYPEMESH_WEB_EXPORT const char* web_part_names()
{
    static std::string all;
    all.clear();
    for (const char* name : part_names) all += (all.empty() ? "" : " ") + std::string{name};
    return all.c_str();
}

/// Opens a font and takes its bytes, which malloc() gave; null if that fails. Lives until web_close_font().
TYPEMESH_WEB_EXPORT web_font* web_open_font(std::byte* bytes, std::uint32_t size, std::uint32_t index,
                                            const web_variation* variations, std::uint32_t count)
{
    std::vector<typemesh::variation> axes;
    for (std::uint32_t i = 0; i < count; ++i) {
        typemesh::variation v{{}, variations[i].value};
        for (unsigned k = 0; k < 4; ++k) v.tag[k] = static_cast<char>(variations[i].tag >> (24 - 8 * k) & 0xFFu);
        axes.push_back(v);
    }
    auto made = typemesh::harfbuzz_font::open({bytes, size}, {.face = index, .variations = axes});
    if (!made) {
        std::free(bytes);
        fail(made.error());
        return nullptr;
    }
    auto* font = new web_font{std::make_shared<opened_font>(bytes, std::move(*made)), {}, {}, {}, {}};
    hb_face_t* face = hb_font_get_face(font->font->font.handle());
    font->family = name_of(face, HB_OT_NAME_ID_FONT_FAMILY);
    font->style = name_of(face, HB_OT_NAME_ID_FONT_SUBFAMILY);
    read_axes(face, *font);
    return font;
}

TYPEMESH_WEB_EXPORT void web_close_font(web_font* font) { delete font; }

TYPEMESH_WEB_EXPORT const font_facts* web_font_facts(const web_font* font)
{
    static font_facts facts;
    const typemesh::harfbuzz_font& f = font->font->font;
    hb_blob_t* blob = hb_face_reference_blob(hb_font_get_face(f.handle()));
    facts = {static_cast<std::uint32_t>(f.units_per_em()),
             f.glyph_count(),
             hb_face_count(blob),
             font->family.c_str(),
             font->style.c_str(),
             font->axes.data(),
             static_cast<std::uint32_t>(font->axes.size())};
    hb_blob_destroy(blob);
    return &facts;
}

TYPEMESH_WEB_EXPORT std::uint32_t web_font_has(const web_font* font, std::uint32_t character)
{
    hb_codepoint_t glyph = 0;
    return hb_font_get_nominal_glyph(font->font->font.handle(), character, &glyph) ? 1 : 0;
}

/// At least one font. Lives until web_close_mesher().
TYPEMESH_WEB_EXPORT web_mesher* web_open_mesher(web_font* const* fonts, std::uint32_t count)
{
    std::vector<shared_font> all;
    for (std::uint32_t i = 0; i < count; ++i) all.push_back(fonts[i]->font);
    return new web_mesher{std::move(all)};
}

TYPEMESH_WEB_EXPORT void web_close_mesher(web_mesher* m) { delete m; }

/// Options are gathered from their defaults on, then taken: web_reset(), web_set...(), web_take().
TYPEMESH_WEB_EXPORT void web_reset(web_mesher* m) { m->next = settings{}; }

TYPEMESH_WEB_EXPORT void web_set_number(web_mesher* m, std::uint32_t option, double value)
{
    all_options()[option].set(m->next, value);
}

TYPEMESH_WEB_EXPORT void web_set_text(web_mesher* m, std::uint32_t option, const char16_t* text, std::uint32_t size)
{
    all_options()[option].set_text(m->next, {text, size});
}

TYPEMESH_WEB_EXPORT void web_add_feature(web_mesher* m, std::uint32_t tag, std::uint32_t value)
{
    char letters[5] = {};
    for (unsigned k = 0; k < 4; ++k) letters[k] = static_cast<char>(tag >> (24 - 8 * k) & 0xFFu);
    add_feature(m->next, letters, value);
}

TYPEMESH_WEB_EXPORT void web_take(web_mesher* m) { m->made.set(m->next); }

/// Makes the mesh of a text; 0, or 1 for a failure.
TYPEMESH_WEB_EXPORT std::uint32_t web_make(web_mesher* m, const char16_t* text, std::uint32_t size,
                                           std::uint32_t instances)
{
    if (const char* why = m->made.refused()) return fail(why);
    const auto done = m->made.make({text, size}, instances != 0);
    return done ? 0 : fail(*m, done.error());
}

/// Plans a text that moves along an axis of the first font; 0, or 1 for a failure.
TYPEMESH_WEB_EXPORT std::uint32_t web_plan_morph(web_mesher* m, const char16_t* text, std::uint32_t size,
                                                 std::uint32_t axis)
{
    char tag[5] = {};
    for (unsigned k = 0; k < 4; ++k) tag[k] = static_cast<char>(axis >> (24 - 8 * k) & 0xFFu);
    const auto done = m->made.plan_morph({text, size}, tag);
    return done ? 0 : fail(*m, done.error());
}

/// Makes the mesh of that text at a value of the axis; likewise.
TYPEMESH_WEB_EXPORT std::uint32_t web_write_morph(web_mesher* m, double value)
{
    if (!m->made.has_morph()) return fail("Plan a morph before it is written.");
    const auto done = m->made.write_morph(value);
    return done ? 0 : fail(done.error());
}

/// What web_make() has made. Its arrays live until the next web_make() of this mesher.
TYPEMESH_WEB_EXPORT const web_mesh* web_result(web_mesher* m)
{
    const mesh_arrays& a = m->made.arrays();
    const typemesh::text_report& r = a.report;
    const auto number = [](auto n) { return static_cast<std::uint32_t>(n); };
    if (r.refused > 0) typemesh::describe(r.first_refusal.at(typemesh::no_glyph, typemesh::no_cluster), m->words);
    m->result = {a.position.data(),
                 a.normal.data(),
                 a.uv.data(),
                 a.index.data(),
                 number(a.vertices()),
                 number(a.triangles()),
                 a.parts.data(),
                 number(a.parts.size()),
                 a.letters.data(),
                 number(a.letters.size()),
                 a.instances.data(),
                 a.translations.data(),
                 number(a.instances.size()),
                 {a.bounds.low.x, a.bounds.low.y, a.bounds.low.z, a.bounds.high.x, a.bounds.high.y, a.bounds.high.z},
                 r.glyphs,
                 a.lines,
                 number(a.contour_points),
                 r.missing,
                 r.first_missing,
                 r.refused,
                 r.narrowed,
                 r.invalid_units,
                 r.unbroken,
                 m->words,
                 static_cast<float>(a.plan_microseconds),
                 a.letter_of.data(),
                 a.letter_rows.data(),
                 number(a.letter_rows.size() / 5),
                 a.tints.data(),
                 number(a.tints.size()),
                 static_cast<float>(a.advance)};
    return &m->result;
}

TYPEMESH_WEB_EXPORT std::uint32_t web_open_edges(const web_mesher* m) { return open_edges(m->made.arrays()); }

/// How many numbers web_contours() has.
TYPEMESH_WEB_EXPORT std::uint32_t web_find_contours(web_mesher* m)
{
    contours_of(m->made.arrays(), m->segments);
    return static_cast<std::uint32_t>(m->segments.size());
}
TYPEMESH_WEB_EXPORT const float* web_contours(const web_mesher* m) { return m->segments.data(); }

/// Two halves, the upper first.
TYPEMESH_WEB_EXPORT const std::uint32_t* web_hash(const web_mesher* m)
{
    static std::uint32_t halves[2];
    const std::uint64_t hash = hash_of(m->made.arrays());
    halves[0] = static_cast<std::uint32_t>(hash >> 32);
    halves[1] = static_cast<std::uint32_t>(hash);
    return halves;
}

TYPEMESH_WEB_EXPORT void web_clear_cache(web_mesher* m) { m->made.clear_cache(); }
