// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/executor.hpp>
#include <typemesh/extrude/extrude.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/text/mesh_layout.hpp>
#include <typemesh/text/text_shapes.hpp>
#include <typemesh/vertex/ranged_sink.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

namespace typemesh {

/// A text, meshed and measured but not yet written: exact sizes first, then write() as often as you like.
///
///     vertices   [ front: glyph 0, glyph 1, ... | back: ... | side: ... ]       each part in one piece, so that it can
///     indices    [ front: glyph 0, glyph 1, ... | back: ... | side: ... ]       be drawn with a material of its own
///
/// Move-only. It refers to its mesher, which must outlive it; a move of the mesher ends it, and so does the mesher's
/// next plan() (using it then is asserted). Until its end the shapes that it took from a glyph_cache stay where they
/// are, whoever throws out others; those that a glyph_team built lie there. Only glyphs that have triangles are counted among glyphs().
template <extruder Extruder>
class text_plan {
    friend class text_chunks;

public:
    text_plan(text_shapes& shapes, const glyph_run& run, const Extruder& extruder) noexcept
        : shapes_{&shapes}, run_{&run}, extruder_{extruder}, generation_{shapes.generation.number}
    {
    }
    text_plan(text_plan&& other) noexcept
        : shapes_{std::exchange(other.shapes_, nullptr)},
          run_{other.run_},
          extruder_{std::move(other.extruder_)},
          generation_{other.generation_}
    {
    }
    text_plan& operator=(text_plan&& other) noexcept
    {
        std::swap(shapes_, other.shapes_);
        std::swap(run_, other.run_);
        std::swap(extruder_, other.extruder_);
        std::swap(generation_, other.generation_);
        return *this;
    }
    ~text_plan()
    {
        if (shapes_ != nullptr && shapes_->generation.number == generation_) shapes_->shapes.release();
    }

    /// Exactly how many vertices and triangles write() will emit.
    [[nodiscard]] mesh_size size() const noexcept { return whole().size(); }

    /// Where one part lies in the output.
    [[nodiscard]] mesh_range range(part p) const noexcept { return whole().range(p); }

    /// Where one glyph's share of a part lies. glyph < glyphs().size().
    [[nodiscard]] mesh_range range(std::size_t glyph, part p) const noexcept
    {
        return whole().range(p, glyph, glyph + 1);
    }

    /// The glyphs in the mesh, in drawing order.
    [[nodiscard]] std::span<const shape_record> glyphs() const noexcept { return fresh().records.view(); }

    /// What is not in the mesh, and why.
    [[nodiscard]] const text_report& report() const noexcept { return fresh().report; }

    /// The shaped text behind the mesh: every glyph with its place and cluster, every line.
    [[nodiscard]] const glyph_run& run() const noexcept
    {
        (void)fresh();
        return *run_;
    }

    /// The box around all vertices; exact for frames whose axes lie along the coordinate axes, else it may be larger.
    [[nodiscard]] bounds3 bounds() const noexcept { return fresh().bounds; }

    /// N and H of the four vertex counts 2N, 4N and 4N + 2H: contour points, and those among them with doubled side
    /// vertices. Cost: O(glyphs), and O(points) for H.
    [[nodiscard]] std::uint64_t contour_points() const noexcept
    {
        std::uint64_t points = 0;
        for (const shape_record& s : fresh().records) points += s.shape->form().points.size();
        return points;
    }
    [[nodiscard]] std::uint64_t hard_edges() const noexcept
    {
        std::uint64_t hard = 0;
        for (const shape_record& r : fresh().records)
            for (const side_point& s : r.shape->form().sides)
                hard += s.doubled && !(s.seam && s.before == s.after) ? 1u : 0u;
        return hard;
    }

    /// Emits every vertex and every triangle once, in ascending order. Only the sink's begin() can fail; nothing is
    /// allocated.
    template <class Sink>
        requires mesh_sink<std::remove_reference_t<Sink>>
    error write(Sink&& sink) const noexcept
    {
        if (error e = sink.begin(size())) return e;
        whole().everything(extruder_, sink);
        sink.end();
        return {};
    }

    /// The same by several workers, in equal shares; the output is the same to the bit. The sink must take stretches
    /// (see ranged_sink), as those over arrays and containers do. A share is written ascending.
    template <class Sink, executor Executor>
        requires ranged_sink<std::remove_reference_t<Sink>>
    error write(Sink&& sink, Executor& workers) const noexcept
    {
        if (error e = sink.begin(size())) return e;
        const mesh_layout all = whole();
        const std::size_t shares = shares_for(workers.workers());
        workers.run(shares, [&, this](std::size_t k, std::size_t) noexcept {
            all.share(k, shares, extruder_, std::as_const(sink));
        });
        sink.end();
        return {};
    }

private:
    const text_shapes& fresh() const noexcept
    {
        TYPEMESH_ASSERT(shapes_ != nullptr, "a text_plan was used that has been moved away");
        TYPEMESH_ASSERT(shapes_->generation.number == generation_,
                        "this text_plan is stale: its mesher has made another plan or was moved since");
        TYPEMESH_ASSERT(shapes_->lent.are_there(), "this text_plan is stale: its glyph_team has built another since");
        return *shapes_;
    }

    [[nodiscard]] mesh_layout whole() const noexcept { return {fresh(), 0, fresh().records.size()}; }

    /// Enough shares that no worker waits long for another, none so small that it is not worth the asking.
    [[nodiscard]] std::size_t shares_for(std::size_t workers) const noexcept
    {
        if (workers <= 1) return 1;
        const std::uint64_t worth = size().vertices / 2048 + 1;
        return worth < 8 * workers ? static_cast<std::size_t>(worth) : 8 * workers;
    }

    text_shapes* shapes_;
    const glyph_run* run_;
    Extruder extruder_;
    std::uint64_t generation_;
};

}  // namespace typemesh
