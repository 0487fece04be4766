// SPDX-License-Identifier: MIT
#include "text_maker.hpp"

#include "text_to_mesh/stages.hpp"
#include "text_writer.hpp"

#include <typemesh/layout/select_glyphs.hpp>
#include <typemesh/text/on_path.hpp>

#include <algorithm>

namespace typemesh_web {
namespace {

using namespace typemesh;

text_options text_options_of(const text_to_mesh::options& o)
{
    text_options how;
    how.shape = shape_options_of(o);
    how.layout = o.lines;
    how.tolerance = o.tolerance;
    how.fill = o.fill;
    how.size = o.size;
    how.merge = o.merge;
    how.frame.uv = uv_origin::bottom_left;
    return how;
}

web_solid solid_of(const text_to_mesh::options& o)
{
    using namespace text_to_mesh;
    if (o.inflate.height > 0.0f) return inflated_of(o);
    if (o.tube.radius > 0.0f) return tubed_of(o);
    if (o.bend.is_on && o.bevel.width > 0.0f) return bent_of(o, bevelled_of(o));
    if (o.bend.is_on) return bent_of(o, plain_of(o));
    const web_upright letter = o.bevel.width > 0.0f ? web_upright{bevelled_of(o)} : web_upright{plain_of(o)};
    if (o.outline.width > 0.0f) return hollow_of(o, letter);
    return letter;
}

}  // namespace

shape_options shape_options_of(const text_to_mesh::options& o)
{
    return {.direction = o.direction,
            .language = o.language,
            .script = o.script,
            .features = o.features,
            .letter_spacing = o.letter_spacing,
            .columns = o.columns};
}

text_maker::text_maker(font_set& fonts, glyph_cache<>& cache) : fonts_{&fonts}, mesher_{fonts, cached_in{cache, 1}} {}

void text_maker::take(const text_to_mesh::options& o)
{
    options_ = o;
    mesher_.use(solid_of(options_));
    text_to_mesh::use_stages(options_, fonts_->units_per_em(), mesher_);
    if (options_.path.curve) mesher_.use(on_path{options_.path.curve.get(), {.anchor = path_anchor::middle}});
}

result<void> text_maker::make(const text_job& job, mesh_arrays& out)
{
    if (job.marked == nullptr || job.marked->solids() < 2) return add(job, out);
    const text_to_mesh::options usual = options_;
    const auto done = make_solids(job, out);
    take(usual);
    return done;
}

/// Letters whose tags ask for another solid are planned apart. All backs lie in one plane.
result<void> text_maker::make_solids(const text_job& job, mesh_arrays& out)
{
    const text_to_mesh::options usual = options_;
    glyph_run run;
    text_job some = job;
    some.page = &run;
    for (std::uint32_t solid = 0; solid < job.marked->solids(); ++solid) {
        const auto is_its = [&](style_id s) noexcept { return job.marked->solid_of(s) == solid; };
        if (const auto done = select_glyphs(*job.page, is_its, run); !done) return done.error();
        if (run.glyphs.empty()) continue;
        take(job.marked->options_of(usual, solid));
        const std::size_t first = out.position.size();
        const std::uint32_t lines = out.lines;
        if (const auto done = add(some, out); !done) return done;
        out.lines = (std::max)(lines, out.lines);
        const auto up = static_cast<float>((double{options_.depth} - double{usual.depth}) * usual.size);
        if (first == 0)
            out.bounds.low.z += up, out.bounds.high.z += up;  // the other solids' vertices are added to these
        for (std::size_t i = first + 2; i < out.position.size(); i += 3) {
            out.position[i] += up;
            out.bounds.add({out.position[i - 2], out.position[i - 1], out.position[i]});
        }
    }
    return {};
}

/// Adds one solid's letters.
result<void> text_maker::add(const text_job& job, mesh_arrays& out)
{
    text_options how = text_options_of(options_);
    if (job.instances) how.merge = false;
    auto plan = job.page != nullptr ? mesher_.plan(*job.page, how) : mesher_.plan(job.text, how);
    if (!plan) return plan.error();
    const auto taken = std::chrono::steady_clock::now() - job.begun;
    out.plan_microseconds = std::chrono::duration<double, std::micro>(taken).count();
    const bool is_first = out.vertices() == 0;
    out.add(plan->report());
    if (is_first) out.bounds = plan->bounds();
    out.contour_points += plan->contour_points();
    const glyph_run& run = plan->run();
    out.lines = static_cast<std::uint32_t>(run.lines.size());
    const double per_em = run.units_per_em > 0.0 ? 1.0 / run.units_per_em : 1.0;
    for (const text_line& line : run.lines) out.advance = (std::max)(out.advance, line.advance * per_em);
    if (job.instances) return write_letters(*plan, out);
    const auto first = static_cast<std::uint32_t>(out.vertices());
    if (const auto done = write_whole(*plan, out); !done) return done;
    if (job.marked != nullptr)
        if (const auto done = name_tints(*plan, *job.marked, first, out); !done) return done;
    if (!job.letters) return {};
    const bool down = options_.direction == direction::top_to_bottom;
    if (const auto found = plan->find_letters(job.text, {.pivot = letter_pivot::centre, .down = down}); !found)
        return found;
    return name_letters(*plan, first, out);
}

}  // namespace typemesh_web
