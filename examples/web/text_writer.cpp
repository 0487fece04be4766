// SPDX-License-Identifier: MIT
#include "text_writer.hpp"

namespace typemesh_web {

using namespace typemesh;

namespace {

struct float2 {
    float x, y;
};

/// Into the arrays from a vertex and an index on, whose room was made.
auto sink_into(mesh_arrays& out, std::size_t vertex, std::size_t index)
{
    return stream_sink{std::span<std::uint32_t>{out.index.data(), out.index.size()}.subspan(index),
                       static_cast<std::uint32_t>(vertex),
                       stream<attribute::position, float3>::in(bytes_of(out.position, 3 * vertex), 0),
                       stream<attribute::normal, float3>::in(bytes_of(out.normal, 3 * vertex), 0),
                       stream<attribute::uv, float2>::in(bytes_of(out.uv, 2 * vertex), 0)};
}

/// The vertices of a glyph of the plan, which stand behind `first` others in the arrays.
template <class Do>
void each_vertex(const web_plan& plan, std::size_t g, std::uint32_t first, const Do& what)
{
    for (const part p : plan.parts()) {
        const mesh_range r = plan.range(g, p);
        for (std::uint32_t i = 0; i < r.vertex_count; ++i) what(first + r.first_vertex + i);
    }
}

}  // namespace

result<void> write_whole(const web_plan& plan, mesh_arrays& out) noexcept
{
    const mesh_size size = plan.size();
    const std::size_t vertex = out.vertices(), index = out.index.size();
    if (!out.make_room(size.vertices, size.indices())) return error::out_of_memory;
    for (const part p : plan.parts()) {
        mesh_range r = plan.range(p);
        r.first_vertex += static_cast<std::uint32_t>(vertex);
        r.first_index += static_cast<std::uint32_t>(index);
        if (!out.add_part(p, r)) return error::out_of_memory;
    }
    return plan.write(sink_into(out, vertex, index));
}

result<void> name_letters(const web_plan& plan, std::uint32_t first, mesh_arrays& out) noexcept
{
    const letter_rows rows = plan.letters();
    const auto row = static_cast<std::uint32_t>(out.letter_rows.size() / 5);
    if (out.vertices() != first && out.letter_of.append(out.vertices() - first) == nullptr) return error::out_of_memory;
    for (const auto& some : {rows.letters, rows.bars}) {
        for (const text_letter& l : some) {
            const float numbers[] = {l.pivot.x, l.pivot.y, l.pivot.z,
                                     l.word == not_a_letter ? -1.0f : static_cast<float>(l.word),
                                     static_cast<float>(l.line)};
            for (const float f : numbers)
                if (!out.letter_rows.push_back(f)) return error::out_of_memory;
        }
    }
    for (std::size_t g = 0; g < plan.glyphs().size(); ++g) {
        const auto own = row + static_cast<std::uint32_t>(&plan.row_of(g) - rows.letters.data());  // bars lie behind
        each_vertex(plan, g, first, [&](std::uint32_t i) { out.letter_of[i] = own; });
    }
    return {};
}

result<void> name_tints(const web_plan& plan, const marked_words& words, std::uint32_t first, mesh_arrays& out) noexcept
{
    if (out.vertices() != first && out.tints.append(out.vertices() - first) == nullptr) return error::out_of_memory;
    for (std::size_t g = 0; g < plan.glyphs().size(); ++g) {
        const auto colour = words.colour_of(plan.glyphs()[g].style);
        const std::uint32_t c = colour.value_or(0);
        const std::uint32_t tint = colour ? (c >> 16 & 255u) | (c & 0xFF00u) | (c & 255u) << 16 : 0xFF00'0000u;
        each_vertex(plan, g, first, [&](std::uint32_t i) { out.tints[i] = tint; });
    }
    return {};
}

result<void> write_letters(const web_plan& plan, mesh_arrays& out) noexcept
{
    const mesh_size size = plan.meshes_size();
    if (!out.make_room(size.vertices, size.indices())) return error::out_of_memory;
    for (std::size_t m = 0; m < plan.meshes().size(); ++m) {
        const auto first = static_cast<std::uint32_t>(out.parts.size());
        for (const part p : plan.parts())
            if (!out.add_part(p, plan.mesh_part(m, p))) return error::out_of_memory;
        const auto count = static_cast<std::uint32_t>(out.parts.size()) - first;
        if (!out.letters.push_back({plan.meshes()[m].id, first, count})) return error::out_of_memory;
    }
    const std::size_t count = plan.glyphs().size();
    if (!out.instances.reserve(count) || !out.translations.reserve(3 * count)) return error::out_of_memory;
    plan.write_instances([&out](const glyph_instance& i) noexcept {
        out.instances.push_back_unchecked(i.mesh);
        for (const float v : {i.translation.x, i.translation.y, i.translation.z})
            out.translations.push_back_unchecked(v);
    });
    return plan.write_meshes(sink_into(out, 0, 0));
}

}  // namespace typemesh_web
