// SPDX-License-Identifier: MIT
#include "text_maker.hpp"

#include "any_solid.hpp"
#include "text_to_mesh/policies.hpp"
#include "text_writer.hpp"

#include <utility>
#include <variant>

namespace typemesh_web {
namespace {

using namespace typemesh;

/// Any of the discretisers, so that there is one mesher for all. Where contours cross, curves are halved, as `certified`
/// asks for, which the others by themselves never do.
struct any_discretiser {
    text_to_mesh::chosen_discretiser choice;

    [[nodiscard]] option_bits cache_key() const noexcept { return text_to_mesh::key_of_choice(choice); }

    template <class Curve, class Put>
    void operator()(const Curve& curve, double tolerance, Put&& put) const noexcept
    {
        if (const auto* kept = std::get_if<certified>(&choice))
            (*kept)(curve, tolerance, put);
        else
            std::get<text_to_mesh::unbounded_discretiser>(choice)(curve, tolerance, put);
    }
};

text_options text_options_of(const text_to_mesh::options& o)
{
    text_options how;
    how.shape = {.direction = o.direction, .language = o.language, .script = o.script, .features = o.features};
    how.shape.columns = o.columns;
    how.layout = {.align = o.align, .line_spacing = o.line_spacing, .letter_spacing = o.letter_spacing};
    how.tolerance = o.tolerance;
    how.fill = o.fill;
    how.size = o.size;
    how.merge = o.merge;
    how.frame.uv = uv_origin::bottom_left;
    return how;
}

template <extruder Extruder>
class maker_of final : public text_maker {
public:
    maker_of(const text_to_mesh::options& o, font_set& fonts, glyph_cache<>& cache)
        : fonts_{&fonts}, mesher_{fonts, cached_in{cache, 1}, Extruder{}}
    {
        (void)take(o);
    }

    bool take(const text_to_mesh::options& o) override
    {
        const auto raise = typemesh_web::extruder_of(o);
        const auto* own = std::get_if<Extruder>(&raise);
        if (own == nullptr) return false;
        mesher_.use(any_discretiser{text_to_mesh::discretiser_of(o, fonts_->units_per_em())});
        mesher_.use(*own);
        mesher_.use(text_to_mesh::triangulator_of(o));
        options_ = o;
        return true;
    }

    error make(const text_job& job, mesh_arrays& out) override
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
        return job.instances ? write_letters(*plan, out) : write_whole(*plan, out);
    }

private:
    font_set* fonts_;
    text_to_mesh::options options_;  // the texts in them are read while a plan is made
    text_mesher<Extruder> mesher_;
};

}  // namespace

std::unique_ptr<text_maker> maker_for(const text_to_mesh::options& o, font_set& fonts, glyph_cache<>& cache)
{
    const auto make = [&](const auto& e) -> std::unique_ptr<text_maker> {
        return std::make_unique<maker_of<std::remove_cvref_t<decltype(e)>>>(o, fonts, cache);
    };
    return std::visit(make, typemesh_web::extruder_of(o));
}

}  // namespace typemesh_web
