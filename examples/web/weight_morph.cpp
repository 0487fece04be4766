// SPDX-License-Identifier: MIT
#include "weight_morph.hpp"

#include "text_maker.hpp"

namespace typemesh_web {

using namespace typemesh;

result<void> weight_morph::plan(std::u16string_view text, const text_to_mesh::options& o)
{
    morph_options how;
    how.tolerance = o.tolerance;
    how.size = size_ = o.size;
    how.depth = o.depth;
    how.shape = shape_options_of(o);
    how.layout = o.lines;
    how.layout.width = layout_options{}.width;  // a morph's lines end where the text demands it
    auto made = morph_.plan(text, how);
    if (!made) return made.error();
    plan_ = std::move(*made);
    return {};
}

result<void> weight_morph::write(double value, mesh_arrays& out)
{
    out.clear();
    const axis_coordinate at = axis_.coordinate(value);
    if (plan_.section_count() == 0) return {};
    const std::size_t section = plan_.section_at(at);
    const mesh_size size = plan_.size(section);
    if (!out.make_room(size.vertices, size.indices())) return error::out_of_memory;
    for (const part p : {part::front, part::back, part::side})
        if (!out.add_part(p, plan_.range(section, p))) return error::out_of_memory;
    const auto written =
        plan_.write_at(at, stream_sink{std::span<std::uint32_t>{out.index.data(), out.index.size()},
                                       stream<attribute::position, float3>::in(bytes_of(out.position), 0),
                                       stream<attribute::normal, float3>::in(bytes_of(out.normal), 0)});
    const auto per_em = static_cast<float>(1.0 / size_);
    for (std::size_t i = 0; i < out.vertices(); ++i) {
        const float* const p = out.position.data() + 3 * i;
        const vec3 at_vertex{p[0], p[1], p[2]};
        if (i == 0) out.bounds = {at_vertex, at_vertex};
        out.bounds.add(at_vertex);
        for (std::size_t k = 0; k < 2; ++k) out.uv[2 * i + k] = p[k] * per_em;
    }
    const morph_report& report = plan_.report();
    out.report.glyphs = report.letters;
    out.report.missing = report.missing;
    return written;
}

}  // namespace typemesh_web
