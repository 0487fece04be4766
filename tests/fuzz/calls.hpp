// SPDX-License-Identifier: MIT
#pragma once

#include "plan_laws.hpp"
#include "toy_texts.hpp"

#include "support/counting_memory.hpp"

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/glyph/glyph_cache.hpp>
#include <typemesh/text/glyph_workers.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// Sequences of calls: meshers with a small cache in common, plans, all ways of writing, updates of a changed text,
/// workers, failing memory. All meshes equal the meshes of a fresh mesher without a cache.
namespace fuzz {

namespace call_laws {

using namespace typemesh;

/// Meshers with two extruders. One has memory of its own that may fail.
class session {
public:
    explicit session(values& in)
        : in_{in}, cache_{std::size_t{1} << (10 + in.below(10)), cache_memory_.source()}, own_font_{memory_.source()}
    {
    }

    broken_law run()
    {
        for (int step = 0; step < 24 && !in_.empty(); ++step)
            if (broken_law broken = call(in_.below(13)); !broken.empty()) return broken;
        held_.reset();
        const cache_statistics seen = cache_.statistics();
        return seen.pinned == 0 ? "" : "glyphs stay pinned without a plan";
    }

private:
    broken_law call(std::uint32_t what)
    {
        switch (what) {
        case 0: walls_.solid().depth = float(in_.between(0.01, 2.0)); return {};
        case 1: walls_.solid().texture = in_.flag() ? texture_mapping::box : texture_mapping::em; return {};
        case 2: bevels_.solid().width = float(in_.between(0.001, 0.08)); return {};
        case 3: in_.flag() ? walls_.trim() : bevels_.trim(); return {};
        case 4: return hold();
        case 5: return fail();
        case 6: return compare(bevels_);
        case 7: read_bevels(bevels_.solid()); return {};
        case 8: return update(walls_);
        case 9:  // bevels that fit the text may change all letters when one does
            return bevels_.solid().mode == bevel_mode::fit_text ? broken_law{} : update(bevels_);
        case 10: return divide(walls_);
        case 11: return divide(bevels_);
        default: return compare(walls_);
        }
    }

    /// Compares a plan and its mesh with a fresh mesher's, and then in chunks.
    template <class Mesher>
    broken_law compare(Mesher& mesher)
    {
        const std::string text = read_letters(in_, 12);
        const text_options how = read_options(in_);
        text_mesher fresh{font_, mesher.solid()};
        const auto plan = mesher.plan(text, how);
        const auto wanted = fresh.plan(text, how);
        if (!plan || !wanted)
            return plan.error().code == wanted.error().code ? "" : "another error than without a cache";
        test::full_mesh m, n;
        if (!plan->write(into(m.vertices, m.indices)) || !wanted->write(into(n.vertices, n.indices)))
            return "write failed";
        if (!(mesh_size{m.vertices.size(), m.indices.size() / 3} == plan->size())) return "another size than planned";
        if (!same_bits(m, n)) return "another mesh than without a cache";
        if (plan->report().refused != wanted->report().refused || plan->report().blank != wanted->report().blank)
            return "another report than without a cache";
        if (const auto closed = test::examine(m);
            mesher.solid().front && (closed.unmatched_edges != 0 || closed.bad_corners != 0))
            return "the mesh is open";
        std::uint32_t next = 0;
        for (const part p : plan->parts()) {
            if (plan->range(p).first_vertex != next) return "parts leave a gap";
            next += plan->range(p).vertex_count;
        }
        return plan_laws::of_writing(*plan, in_);
    }

    void read_bevels(bevelled& how)
    {
        const std::uint32_t bits = in_.byte();
        how.sides = static_cast<bevel_sides>((bits & 3) % 3);
        how.mode = static_cast<bevel_mode>((bits >> 2 & 3) % 3);
        how.outward = (bits & 16) != 0;
        how.joins = (bits & 32) != 0 ? bevel_joins::bevelled : bevel_joins::round;
        how.shading = (bits & 64) != 0 ? bevel_shading::rounded : bevel_shading::by_slope;
        how.front = (bits & 128) == 0;
        how.profile = round_profile(in_.below(9));
    }

    /// What a glyph of a plan draws, and where: if this changes, it must be written again.
    struct drawn {
        std::vector<std::uint32_t> ids;
        std::vector<double> places;
        std::vector<mesh_range> ranges;

        template <class Plan>
        drawn(const Plan& plan, std::size_t glyph)
        {
            for (const std::uint32_t m : plan.members(glyph)) {
                const placed_glyph& g = plan.run().glyphs[m];
                ids.insert(ids.end(), {m, g.id});
                places.insert(places.end(), {g.origin.x, g.origin.y});
            }
            for (const part p : plan.parts()) ranges.push_back(plan.range(glyph, p));
        }
        [[nodiscard]] bool draws_the_same(const drawn& d) const { return ids == d.ids && places == d.places; }
    };

    /// Some glyphs of a text are moved or exchanged: if nothing else moves in memory, writing these is enough.
    template <class Mesher>
    broken_law update(Mesher& mesher)
    {
        const std::string text = read_letters(in_, 12);
        text_options how = read_options(in_);
        how.texture_over = texture_box::glyph;
        if (how.unit == output_unit::unit_box) how.unit = output_unit::em;
        glyph_run before, after;
        for (glyph_run* run : {&before, &after})
            if (!layout(font_, text, how.shape, how.layout, *run)) return "a text of toy letters has no layout";
        for (std::uint32_t left = in_.below(4); left > 0 && !after.glyphs.empty(); --left) {
            placed_glyph& g = after.glyphs[in_.below(static_cast<std::uint32_t>(after.glyphs.size()))];
            if (in_.flag()) g.origin = g.origin + point{in_.between(-2000.0, 2000.0), in_.between(-1000.0, 1000.0)};
            if (in_.flag()) g.id = after.glyphs[in_.below(static_cast<std::uint32_t>(after.glyphs.size()))].id;
        }
        test::full_mesh shown, wanted;
        std::vector<drawn> were;
        {
            const auto plan = mesher.plan(before, how);
            if (!plan) return plan.error() == error::bad_option ? "" : plan.error().message();
            if (!plan->write(into(shown.vertices, shown.indices))) return "write failed";
            for (std::size_t g = 0; g < plan->glyphs().size(); ++g) were.emplace_back(*plan, g);
        }
        const auto plan = mesher.plan(after, how);
        if (!plan) return plan.error() == error::bad_option ? "" : plan.error().message();
        if (!plan->write(into(wanted.vertices, wanted.indices))) return "write failed";
        if (plan->glyphs().size() != were.size() || wanted.vertices.size() != shown.vertices.size()) return {};
        const auto sink = [&shown] { return into(std::span{shown.vertices}, std::span{shown.indices}); };
        for (std::size_t g = 0; g < were.size(); ++g) {
            const drawn now{*plan, g};
            if (now.ranges != were[g].ranges) return {};
            if (now.draws_the_same(were[g])) continue;
            if (!plan->write(glyph_span{g, g + 1}, sink())) return "a glyph cannot be written anew";
        }
        return same_bits(shown, wanted) ? "" : "an updated text differs from the text";
    }

    /// Several workers plan the same as one.
    template <class Mesher>
    broken_law divide(Mesher& mesher)
    {
        const std::string text = read_letters(in_, 12);
        const text_options how = read_options(in_);
        auto one = text_mesher{font_}.with(mesher.solid()), many = text_mesher{font_}.with(mesher.solid());
        test::scrambled_workers several{1 + in_.below(4), in_.byte()};
        auto pool =
            workers_of(several, [](std::size_t) noexcept -> result<test::toy_font> { return test::toy_font{}; });
        if (!pool) return pool.error().message();
        const auto plan = many.plan(text, how, *pool);
        const auto wanted = one.plan(text, how);
        if (!plan || !wanted) return plan.error().code == wanted.error().code ? "" : "another error than one worker's";
        test::full_mesh m, n;
        if (!plan->write(into(m.vertices, m.indices)) || !wanted->write(into(n.vertices, n.indices)))
            return "write failed";
        return same_bits(m, n) ? "" : "several workers plan another mesh";
    }

    /// A plan that is kept while others evict what they can still writes the same.
    broken_law hold()
    {
        if (held_) {
            test::full_mesh m;
            if (!held_->write(into(m.vertices, m.indices))) return "a plan that is held cannot be written";
            const bool same = same_bits(m, held_mesh_);
            held_.reset();
            return same ? "" : "a plan writes another mesh later";
        }
        const std::string text = read_letters(in_, 12);
        auto plan = holder_.plan(text, read_options(in_));
        if (!plan) return {};
        held_mesh_ = {};
        if (!plan->write(into(held_mesh_.vertices, held_mesh_.indices))) return "write failed";
        held_.emplace(std::move(*plan));
        return {};
    }

    /// When memory fails at some request, the result is out_of_memory or a plan, and later all is as before.
    broken_law fail()
    {
        const std::string text = read_letters(in_, 12);
        const text_options how = read_options(in_);
        test::counting_memory& failing = in_.flag() ? cache_memory_ : memory_;
        failing.fail_at = failing.requests + 1 + in_.below(40);
        failing.fail_once = in_.flag();
        {
            auto mesher = text_mesher{own_font_, memory_.source()}.with(cached_in{cache_, 1});
            const auto plan = mesher.plan(text, how);
            failing.fail_at = 0;
            const bool expected = plan || plan.error() == error::out_of_memory || plan.error() == error::bad_option;
            if (!expected) return plan.error().message();
            if (!plan && !mesher.plan(text, how) && plan.error() == error::out_of_memory)
                return "a mesher does not recover when memory does";
        }
        return compare(walls_);
    }

    values& in_;
    test::counting_memory cache_memory_, memory_;
    glyph_cache<> cache_;
    test::toy_font font_, own_font_;
    text_mesher<extruded<>> walls_{font_, cached_in{cache_, 1}}, holder_{font_, cached_in{cache_, 1}};
    text_mesher<bevelled> bevels_{font_, cached_in{cache_, 1}, bevelled{.profile = round_profile(3)}};
    std::optional<text_plan<extruded<>>> held_;
    test::full_mesh held_mesh_;
};

}  // namespace call_laws

inline broken_law calls(values in)
{
    call_laws::session s{in};
    return s.run();
}

}  // namespace fuzz
