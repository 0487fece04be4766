// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/executor.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/text/impl/split_glyphs.hpp>
#include <typemesh/text/text_plan.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// One chunk of a text: its range of the output, and the glyphs that it holds.
struct text_chunk {
    std::uint32_t first_vertex = 0;
    std::uint32_t first_index = 0;
    part_sizes sizes;
    std::uint32_t first_glyph = 0;  ///< the chunk's first glyph in plan.glyphs()
    std::uint32_t glyph_count = 0;
    std::uint32_t piece = whole_glyphs;  ///< the number of the piece, if its only glyph had to be split

    static constexpr std::uint32_t whole_glyphs = 0xFFFF'FFFFu;  ///< `piece` of a chunk that splits no glyph

    [[nodiscard]] mesh_size size() const noexcept { return sizes.total(); }

    /// The range of one of the chunk's parts in the output. Its indices count from first_vertex.
    [[nodiscard]] mesh_range range(part p) const noexcept { return sizes.range(p, first_vertex, first_index); }
    /// The range of the whole chunk.
    [[nodiscard]] mesh_range range() const noexcept
    {
        return {first_vertex, static_cast<std::uint32_t>(size().vertices), first_index,
                static_cast<std::uint32_t>(size().indices())};
    }
};

/// A planned text, divided into chunks that small indices can number. Each chunk is a mesh of its own with indices from
/// 0.
///
///     vertices   [ chunk 0: front | back | side ][ chunk 1: front | back | side ] ...
///     indices    [ chunk 0: front | back | side ][ chunk 1: front | back | side ] ...      each from 0
///
///     text_chunks chunks;                                              // keeps its memory for the next text
///     auto cut = chunks.cut(*plan);                                    // 65,535 vertices: 16-bit indices up to 65,534
///     auto size = chunks.size();                                       // exact, repeated vertices included
///     auto written = chunks.write(*plan, into(vertices, short_indices));
///     for (const text_chunk& c : chunks.view()) draw(c.range(), ...);  // base vertex c.first_vertex
///
/// Or one by one, each into its own buffers: chunks.write(*plan, k, sink).
///
/// A chunk holds as many whole glyphs as fit, in drawing order. A glyph that is too large for a chunk is split into
/// pieces, each with a chunk of its own. A piece holds consecutive triangles and the vertices that they use, so
/// vertices between two pieces are repeated.
///
/// Chunks are valid as long as the plan is valid; call cut() for a new plan.
class text_chunks {
public:
    static constexpr std::uint32_t max_for_16_bits = 0xFFFF;  ///< 0xFFFF itself is reserved: it means "restart"

    explicit text_chunks(memory source = heap()) noexcept : chunks_{source}, pieces_{source} {}

    /// Divides a text into chunks of at most `most` vertices, which replace the previous chunks.
    ///
    /// Fails  error::bad_option: most < 3; error::too_large: more than 2^32 - 1 vertices or indices;
    ///        error::out_of_memory; there are then no chunks
    template <extruder Extruder>
    result<void> cut(const text_plan<Extruder>& plan, std::uint32_t most = max_for_16_bits) noexcept
    {
        clear();
        if (most < 3) return error::bad("most");
        const error e = cut_all(plan.fresh(), plan.extruder_, most);
        if (e) clear();
        from_ = plan.glyphs_;
        generation_ = plan.generation_;
        return e;
    }

    void clear() noexcept
    {
        chunks_.clear();
        pieces_.clear();
        total_ = {};
        largest_ = 0;
    }

    /// The chunks, in the order of the output.
    [[nodiscard]] array_view<const text_chunk> view() const noexcept { return chunks_.view(); }

    /// The size of all chunks together.
    [[nodiscard]] mesh_size size() const noexcept { return total_; }

    /// The range of a style in one part of chunk k. `plan` is the plan that cut() divided.
    template <extruder Extruder>
    [[nodiscard]] mesh_range range(const text_plan<Extruder>& plan, std::size_t k, style_id style,
                                   part p) const noexcept
    {
        const text_glyphs& all = fresh(plan);
        const text_chunk& c = chunks_[k];
        const std::size_t first = c.first_glyph, last = first + c.glyph_count;
        const auto in_chunk = [first, last](std::size_t glyph) noexcept {
            return glyph < first ? first : glyph > last ? last : glyph;
        };
        const std::size_t own_first = in_chunk(all.first_of(style)), own_last = in_chunk(all.last_of(style));
        mesh_range found = c.range(p);
        if (c.piece != text_chunk::whole_glyphs) {  // a piece of one glyph: it has the style as a whole or not at all
            if (own_first < own_last) return found;
            if (own_first == last) {
                found.first_vertex += found.vertex_count;
                found.first_index += found.index_count;
            }
            found.vertex_count = found.index_count = 0;
            return found;
        }
        found = mesh_layout{all, first, last}.range(p, own_first, own_last);
        found.first_vertex += c.first_vertex;
        found.first_index += c.first_index;
        return found;
    }

    /// Writes all chunks: every vertex and every index once, ascending. Only the sink can fail, in begin_chunks() or
    /// end(); nothing is allocated. `plan` is the plan that cut() divided.
    template <extruder Extruder, class Sink>
        requires chunked_sink<std::remove_reference_t<Sink>>
    result<void> write(const text_plan<Extruder>& plan, Sink&& sink) const noexcept
    {
        one_worker alone;
        return write(plan, std::forward<Sink>(sink), alone);
    }

    /// Writes all chunks with several workers, chunk by chunk. The output is identical.
    template <extruder Extruder, class Sink, executor Executor>
        requires chunked_sink<std::remove_reference_t<Sink>>
    result<void> write(const text_plan<Extruder>& plan, Sink&& sink, Executor& workers) const noexcept
    {
        if (error e = detail::refused_letters<std::remove_cvref_t<Sink>>(fresh(plan))) return e;
        if (error e = sink.begin_chunks(size(), largest_)) return e;
        const text_glyphs& all = fresh(plan);
        workers.run(chunks_.size(), [&, this](std::size_t k, std::size_t) noexcept {
            auto part_of_it = std::as_const(sink).subrange(chunks_[k].range());
            put(all, chunks_[k], plan.extruder_, part_of_it);
        });
        return end_of(sink);
    }

    /// Writes all chunks of a text whose letters move: see text_plan::write() with a motion.
    template <extruder Extruder, class Sink, letter_motion Motion>
        requires chunked_sink<std::remove_reference_t<Sink>>
    result<void> write(const text_plan<Extruder>& plan, Sink&& sink, Motion&& motion) const noexcept
    {
        return write(plan, plan.moved(sink, motion));
    }

    /// Writes only chunk k, as a whole mesh.
    template <extruder Extruder, class Sink>
        requires mesh_sink<std::remove_reference_t<Sink>>
    result<void> write(const text_plan<Extruder>& plan, std::size_t k, Sink&& sink) const noexcept
    {
        const text_chunk& chunk = chunks_[k];
        if (error e = detail::refused_letters<std::remove_cvref_t<Sink>>(fresh(plan))) return e;
        if (error e = sink.begin(chunk.size())) return e;
        put(fresh(plan), chunk, plan.extruder_, sink);
        return end_of(sink);
    }

    // Overloads that refuse a result without its `*` and arrays without their into().
    template <class Plan, class... More>
    result<void> cut(const result<Plan>&, More...) noexcept
    {
        return refuse_result<Plan>();
    }
    template <class Plan, class... More>
    result<void> write(const result<Plan>&, More&&...) const noexcept
    {
        return refuse_result<Plan>();
    }
    template <extruder Extruder, array_without_sink Vertices, array_without_sink Indices, class... Workers>
    result<void> write(const text_plan<Extruder>&, Vertices&&, Indices&&, Workers&...) const noexcept
    {
        return refuse_arrays<Vertices>();
    }

private:
    template <class Plan>
    const text_glyphs& fresh(const Plan& plan) const noexcept
    {
        TYPEMESH_ASSERT(chunks_.empty() || (plan.glyphs_ == from_ && plan.generation_ == generation_),
                        "these text_chunks were cut from another plan");
        return plan.fresh();
    }

    template <extruder Extruder>
    error cut_all(const text_glyphs& all, const Extruder& how, std::uint32_t most) noexcept
    {
        const std::size_t count = all.records.size();
        for (std::size_t first = 0; first < count;) {
            std::size_t last = first;
            std::uint64_t held = 0;
            while (last < count) {
                const std::uint64_t more = all.records[last].built->sizes().vertices.total();
                if (held + more > most) break;
                held += more;
                ++last;
            }
            if (last == first) {
                if (error e = split(all, first, how, most)) return e;
                ++first;
                continue;
            }
            if (error e = add(mesh_layout{all, first, last}.sizes(), first, last, text_chunk::whole_glyphs)) return e;
            first = last;
        }
        return {};
    }

    template <extruder Extruder>
    error split(const text_glyphs& all, std::size_t glyph, const Extruder& how, std::uint32_t most) noexcept
    {
        std::uint32_t piece = pieces_.size();
        const bool turned = all.placed.frame.turns_triangles();
        if (error e = pieces_.split(*all.records[glyph].built, how, turned, most)) return e;
        for (; piece < pieces_.size(); ++piece)
            if (error e = add(pieces_.sizes(piece), glyph, glyph + 1, piece)) return e;
        return {};
    }

    error add(const part_sizes& sizes, std::size_t first, std::size_t last, std::uint32_t piece) noexcept
    {
        text_chunk c{static_cast<std::uint32_t>(total_.vertices), static_cast<std::uint32_t>(total_.indices()), sizes,
                     static_cast<std::uint32_t>(first),           static_cast<std::uint32_t>(last - first),     piece};
        const mesh_size own = c.size();
        total_ = total_ + own;
        if (own.vertices > largest_) largest_ = static_cast<std::uint32_t>(own.vertices);
        if (!total_.fits_32_bits()) return error::too_large;
        return chunks_.push_back(c) ? error{} : error{error::out_of_memory};
    }

    template <extruder Extruder, mesh_sink Sink>
    void put(const text_glyphs& all, const text_chunk& c, const Extruder& how, Sink& sink) const noexcept
    {
        if (c.piece == text_chunk::whole_glyphs) {
            mesh_layout{all, c.first_glyph, std::size_t{c.first_glyph} + c.glyph_count}.everything(how, sink);
            return;
        }
        const drawn_glyph& s = all.records[c.first_glyph];
        detail::write_letter(all, c.first_glyph, sink, [&](auto& to, const placement& at) noexcept {
            pieces_.write(c.piece, *s.built, how, at, to);
        });
    }

    buffer<text_chunk> chunks_;
    split_glyphs pieces_;
    mesh_size total_;
    std::uint32_t largest_ = 0;
    const text_glyphs* from_ = nullptr;
    std::uint64_t generation_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI
