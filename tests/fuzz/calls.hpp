// SPDX-License-Identifier: MIT
#pragma once

#include "toy_texts.hpp"

#include "support/counting_memory.hpp"

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/ready_profiles.hpp>
#include <typemesh/glyph/glyph_cache.hpp>
#include <typemesh/text/text_chunks.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

/// Sequences of calls: meshers that share a small cache, plans, writing, chunks, memory that fails. All meshes are those
/// that a fresh mesher without a cache makes.
namespace fuzz {

namespace call_laws {

using namespace typemesh;

template <class Extruder>
using cached_mesher = text_mesher<test::toy_font, certified, monotone, Extruder, no_observer, cached_in<no_lock>>;

/// Meshers with two extruders, one with memory of its own that may fail.
class session {
public:
    explicit session(values& in)
        : in_{in}, cache_{std::size_t{1} << (10 + in.below(10)), cache_memory_.source()}, own_font_{memory_.source()}
    {
    }

    broken_law run()
    {
        for (int step = 0; step < 24 && !in_.empty(); ++step)
            if (broken_law broken = call(in_.below(8)); !broken.empty()) return broken;
        held_.reset();
        const cache_statistics seen = cache_.statistics();
        return seen.pinned == 0 ? "" : "glyphs stay pinned without a plan";
    }

private:
    broken_law call(std::uint32_t what)
    {
        switch (what) {
        case 0: walls_.extruder_policy().depth = float(in_.between(0.01, 2.0)); return {};
        case 1: walls_.extruder_policy().texture = in_.flag() ? texture_mapping::box : texture_mapping::em; return {};
        case 2: bevels_.extruder_policy().width = float(in_.between(0.001, 0.08)); return {};
        case 3: in_.flag() ? walls_.trim() : bevels_.trim(); return {};
        case 4: return hold();
        case 5: return fail();
        case 6: return compare(bevels_);
        default: return compare(walls_);
        }
    }

    /// A plan and its mesh, against a fresh mesher's; then in chunks.
    template <class Mesher>
    broken_law compare(Mesher& mesher)
    {
        const std::string text = read_letters(in_, 12);
        const text_options how = read_options(in_);
        auto fresh = text_mesher{font_}.with(mesher.extruder_policy());
        const auto plan = mesher.plan(text, how);
        const auto wanted = fresh.plan(text, how);
        if (!plan || !wanted)
            return plan.error().code == wanted.error().code ? "" : "another error than without a cache";
        test::full_mesh m, n;
        if (plan->write(into(m.vertices, m.indices)) || wanted->write(into(n.vertices, n.indices)))
            return "write failed";
        if (!(mesh_size{m.vertices.size(), m.indices.size() / 3} == plan->size())) return "another size than planned";
        if (!same_bits(m, n)) return "another mesh than without a cache";
        if (plan->report().refused != wanted->report().refused || plan->report().blank != wanted->report().blank)
            return "another report than without a cache";
        if (const auto closed = test::examine(m); closed.unmatched_edges != 0 || closed.bad_corners != 0)
            return "the mesh is open";
        std::uint32_t next = 0;
        for (const part p : plan->parts()) {
            if (plan->range(p).first_vertex != next) return "parts leave a gap";
            next += plan->range(p).vertex_count;
        }
        return in_.flag() ? of_chunks(*plan, m) : "";
    }

    /// Chunks are no larger than asked for, and hold the mesh's triangles, glyph by glyph.
    template <class Plan>
    broken_law of_chunks(const Plan& plan, const test::full_mesh& whole)
    {
        text_chunks chunks;
        const std::uint32_t most = 3 + in_.below(600);
        if (chunks.cut(plan, most)) return "a plan cannot be cut";
        std::vector<std::array<float, 24>> of_whole, of_all;
        add_triangles(whole, of_whole);
        for (std::size_t k = 0; k < chunks.view().size(); ++k) {
            test::full_mesh m;
            if (chunks.write(plan, k, into(m.vertices, m.indices))) return "a chunk cannot be written";
            if (m.vertices.size() > most) return "a chunk is too large";
            if (!(mesh_size{m.vertices.size(), m.indices.size() / 3} == chunks.view()[k].size()))
                return "a chunk of another size than said";
            for (const std::uint32_t i : m.indices)
                if (i >= m.vertices.size()) return "an index beyond its chunk";
            add_triangles(m, of_all);
        }
        std::sort(of_whole.begin(), of_whole.end());
        std::sort(of_all.begin(), of_all.end());
        return of_whole == of_all ? "" : "chunks hold other triangles than the mesh";
    }
    static void add_triangles(const test::full_mesh& m, std::vector<std::array<float, 24>>& all)
    {
        for (std::size_t t = 0; t + 2 < m.indices.size(); t += 3) {
            std::array<float, 24> corners;
            for (std::size_t k = 0; k < 3; ++k)
                std::memcpy(corners.data() + 8 * k, &m.vertices[m.indices[t + k]], sizeof(test::full_vertex));
            all.push_back(corners);
        }
    }

    /// A plan that stays while others evict what they can: it writes what it wrote.
    broken_law hold()
    {
        if (held_) {
            test::full_mesh m;
            if (held_->write(into(m.vertices, m.indices))) return "a plan that is held cannot be written";
            const bool same = same_bits(m, held_mesh_);
            held_.reset();
            return same ? "" : "a plan writes another mesh later";
        }
        const std::string text = read_letters(in_, 12);
        auto plan = holder_.plan(text, read_options(in_));
        if (!plan) return {};
        held_mesh_ = {};
        if (plan->write(into(held_mesh_.vertices, held_mesh_.indices))) return "write failed";
        held_.emplace(std::move(*plan));
        return {};
    }

    /// Memory that fails at some request: out_of_memory or a plan, and afterwards all is as before.
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
    cached_mesher<extruded<>> walls_{text_mesher{font_}.with(cached_in{cache_, 1})},
        holder_{text_mesher{font_}.with(cached_in{cache_, 1})};
    cached_mesher<bevelled<round_profile>> bevels_{
        text_mesher{font_}.with(cached_in{cache_, 1}).with(bevelled<round_profile>{.profile = {.steps = 3}})};
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
