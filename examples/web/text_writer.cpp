// SPDX-License-Identifier: MIT
#include "text_writer.hpp"

namespace typemesh_web {

using namespace typemesh;

namespace {

struct float2 {
    float x, y;
};
struct float3 {
    float x, y, z;
};

/// Into the arrays, whose room was made.
auto sink_into(mesh_arrays& out)
{
    // Spans with their types written out: older standard libraries take a temporary view for a constant one.
    const auto bytes = [](buffer<float>& b) { return std::as_writable_bytes(std::span<float>{b.data(), b.size()}); };
    return stream_sink{std::span<std::uint32_t>{out.index.data(), out.index.size()},
                       stream<attribute::position, float3>::in(bytes(out.position), 0),
                       stream<attribute::normal, float3>::in(bytes(out.normal), 0),
                       stream<attribute::uv, float2>::in(bytes(out.uv), 0)};
}

[[nodiscard]] bool add_part(part p, const mesh_range& r, mesh_arrays& out) noexcept
{
    if (r.index_count == 0) return true;
    return out.parts.push_back(
        {static_cast<std::uint32_t>(p), r.first_index, r.index_count, r.first_vertex, r.vertex_count});
}

}  // namespace

result<void> write_whole(const web_plan& plan, mesh_arrays& out) noexcept
{
    const mesh_size size = plan.size();
    if (!out.make_room(size.vertices, size.indices())) return error::out_of_memory;
    for (const part p : plan.parts())
        if (!add_part(p, plan.range(p), out)) return error::out_of_memory;
    return plan.write(sink_into(out));
}

result<void> name_letters(const web_plan& plan, mesh_arrays& out) noexcept
{
    const letter_rows rows = plan.letters();
    if (out.vertices() != 0 && out.letter_of.append(out.vertices()) == nullptr) return error::out_of_memory;
    for (const auto& some : {rows.letters, rows.bars}) {
        for (const text_letter& l : some) {
            const float row[] = {l.pivot.x, l.pivot.y, l.pivot.z,
                                 l.word == not_a_letter ? -1.0f : static_cast<float>(l.word),
                                 static_cast<float>(l.line)};
            for (const float f : row)
                if (!out.letter_rows.push_back(f)) return error::out_of_memory;
        }
    }
    for (std::size_t g = 0; g < plan.glyphs().size(); ++g) {
        const auto row = static_cast<std::uint32_t>(&plan.row_of(g) - rows.letters.data());  // bars lie behind letters
        for (const part p : plan.parts()) {
            const mesh_range r = plan.range(g, p);
            for (std::uint32_t i = r.first_vertex; i < r.first_vertex + r.vertex_count; ++i) out.letter_of[i] = row;
        }
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
            if (!add_part(p, plan.mesh_part(m, p), out)) return error::out_of_memory;
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
    return plan.write_meshes(sink_into(out));
}

}  // namespace typemesh_web
