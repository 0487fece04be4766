// SPDX-License-Identifier: MIT
#include "text_maker.hpp"

#include "text_to_mesh/stages.hpp"
#include "text_writer.hpp"

#include <typemesh/text/on_path.hpp>

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
    text_options how = text_options_of(options_);
    if (job.instances) how.merge = false;
    auto plan = job.page != nullptr ? mesher_.plan(*job.page, how) : mesher_.plan(job.text, how);
    if (!plan) return plan.error();
    const auto taken = std::chrono::steady_clock::now() - job.begun;
    out.plan_microseconds = std::chrono::duration<double, std::micro>(taken).count();
    out.report = plan->report();
    out.bounds = plan->bounds();
    out.contour_points = plan->contour_points();
    out.lines = static_cast<std::uint32_t>(plan->run().lines.size());
    if (job.instances) return write_letters(*plan, out);
    if (const auto done = write_whole(*plan, out); !done || !job.letters) return done;
    const bool down = options_.direction == direction::top_to_bottom;
    if (const auto found = plan->find_letters(job.text, {.pivot = letter_pivot::centre, .down = down}); !found)
        return found;
    return name_letters(*plan, out);
}

}  // namespace typemesh_web
