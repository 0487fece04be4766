// SPDX-License-Identifier: MIT
//
// The C++20 side of engines/irrlicht_text.hpp: nothing of Irrlicht is included here.

#include "engines/irrlicht_text.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/text/text_mesher.hpp>
#include <typemesh/vertex/array_sink.hpp>

#include <optional>
#include <span>
#include <utility>

namespace engines::irrlicht {

namespace {

struct writer {
    static constexpr auto wants = typemesh::attribute::position | typemesh::attribute::normal | typemesh::attribute::uv;
    std::uint32_t colour;

    text_vertex operator()(const typemesh::surface_point<wants>& s) const noexcept
    {
        return {
            {s.position.x, s.position.y, s.position.z}, {s.normal.x, s.normal.y, s.normal.z}, colour, {s.uv.x, s.uv.y}};
    }
};

using mesher = typemesh::text_mesher<>;

}  // namespace

struct text::made {
    std::optional<typemesh::harfbuzz_font> font;
    std::optional<mesher> meshes;
    std::optional<mesher::plan_type> plan;

    template <class Index>
    const char* write(text_vertex* vertices, Index* indices, std::uint32_t colour) const
    {
        if (!plan) return "no text was planned";
        const typemesh::mesh_size size = plan->size();
        const auto written = plan->write(
            typemesh::into(std::span{vertices, size.vertices}, std::span{indices, size.indices()}, writer{colour}));
        return written ? nullptr : written.error().message();
    }
};

text::text() : made_{std::make_unique<made>()} {}
text::~text() = default;

const char* text::open(const char* font_file)
{
    made_ = std::make_unique<made>();
    auto opened = typemesh::harfbuzz_font::open(font_file);
    if (!opened) return opened.error().message();
    made_->font.emplace(std::move(*opened));
    made_->meshes.emplace(*made_->font);
    return nullptr;
}

const char* text::plan(const char* utf8)
{
    made_->plan.reset();
    if (!made_->meshes) return "no font was opened";
    typemesh::text_options options;
    options.frame = typemesh::left_handed_y_up;
    auto planned = made_->meshes->plan(utf8, options);
    if (!planned) return planned.error().message();
    made_->plan.emplace(std::move(*planned));
    return nullptr;
}

std::size_t text::vertices() const { return made_->plan ? made_->plan->size().vertices : 0; }
std::size_t text::indices() const { return made_->plan ? made_->plan->size().indices() : 0; }

const char* text::write(text_vertex* to_vertices, std::uint16_t* to_indices, std::uint32_t colour) const
{
    return made_->write(to_vertices, to_indices, colour);
}
const char* text::write(text_vertex* to_vertices, std::uint32_t* to_indices, std::uint32_t colour) const
{
    return made_->write(to_vertices, to_indices, colour);
}

}  // namespace engines::irrlicht
