// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/executor.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/core/impl/taken.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/extrude/extrude.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/text/impl/mesh_layout.hpp>
#include <typemesh/text/impl/text_glyphs.hpp>
#include <typemesh/text/lettered_plan.hpp>
#include <typemesh/vertex/ranged_sink.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// The owner of a triangle: see text_plan::hit().
struct mesh_hit {
    std::size_t glyph = 0;            ///< the glyph's index in glyphs()
    std::uint32_t of_run = 0;         ///< the glyph's index in the run, or shared_glyph: see text_plan::owner()
    cluster_id cluster = no_cluster;  ///< the glyph's place in the text; for shared glyphs, the place of the first
                                      ///< glyph; no_cluster for a decoration's bar
};

/// Consecutive glyphs of a plan: glyphs [first, last).
struct glyph_span {
    std::size_t first = 0;
    std::size_t last = 0;
};

/// A text, meshed and measured but not yet written: first the exact sizes, then write() as often as you like.
///
///     vertices   [ front: glyph 0, glyph 1, ... | back: ... | side: ... ]       each part is contiguous, so it can
///     indices    [ front: glyph 0, glyph 1, ... | back: ... | side: ... ]       be drawn with a material of its own
///
/// Glyphs are numbered style by style (see glyph_style.hpp) and in drawing order within a style, so each style is also
/// contiguous within a part. Without glyph styles there is one style, and the order is the drawing order. glyphs()
/// contains only glyphs with a filled area.
///
/// Move-only. A plan refers to its mesher, which must outlive it. It becomes invalid when the mesher is moved or makes
/// another plan(); an assertion fails if an invalid plan is used. As long as the plan is valid, glyphs that it took
/// from a glyph_cache stay in place, even if others evict them. Glyphs that glyph_workers built are stored in these
/// workers.
template <extruder Extruder>
class text_plan : public lettered_plan<text_plan<Extruder>> {
    friend class text_chunks;
    friend class lettered_plan<text_plan>;

public:
    using lettered_plan<text_plan>::write;
    using lettered_plan<text_plan>::write_instances;

    text_plan(text_glyphs& glyphs, const glyph_run& run, const Extruder& extruder) noexcept
        : glyphs_{&glyphs}, run_{&run}, extruder_{extruder}, generation_{glyphs.generation.number}
    {
    }
    text_plan(text_plan&& other) noexcept
        : glyphs_{taken(other.glyphs_)},
          run_{other.run_},
          extruder_{std::move(other.extruder_)},
          generation_{other.generation_}
    {
    }
    text_plan& operator=(text_plan&& other) noexcept
    {
        swap_values(glyphs_, other.glyphs_);
        swap_values(run_, other.run_);
        swap_values(extruder_, other.extruder_);
        swap_values(generation_, other.generation_);
        return *this;
    }
    ~text_plan()
    {
        if (glyphs_ != nullptr && glyphs_->generation.number == generation_) glyphs_->pinned.release();
    }

    /// The exact numbers of vertices and triangles that write() will emit.
    [[nodiscard]] mesh_size size() const noexcept { return whole().size(); }

    /// The parts that its extruder writes: front, back and side, and any further ones.
    [[nodiscard]] static constexpr std::span<const part> parts() noexcept { return parts_of<Extruder>; }

    /// The range of the whole output.
    [[nodiscard]] mesh_range range() const noexcept
    {
        const mesh_size all = size();
        return {0, static_cast<std::uint32_t>(all.vertices), 0, static_cast<std::uint32_t>(all.indices())};
    }

    /// The range of one part in the output.
    [[nodiscard]] mesh_range range(part p) const noexcept { return whole().range(p); }

    /// The range of one glyph in a part. glyph < glyphs().size().
    [[nodiscard]] mesh_range range(std::size_t glyph, part p) const noexcept
    {
        return range(glyph_span{glyph, glyph + 1}, p);
    }

    /// The range of consecutive glyphs in a part.
    [[nodiscard]] mesh_range range(glyph_span some, part p) const noexcept
    {
        return whole().range(p, some.first, some.last);
    }

    /// The range of one style in a part, which is drawn with one material.
    [[nodiscard]] mesh_range range(style_id style, part p) const noexcept { return range(glyphs_of(style), p); }

    /// The styles in the mesh, ascending.
    [[nodiscard]] std::span<const style_id> styles() const noexcept { return fresh().styles(); }

    /// The glyphs of one style; empty (first == last) if the mesh has no glyph of this style. Cost: O(log glyphs).
    [[nodiscard]] glyph_span glyphs_of(style_id style) const noexcept
    {
        return {fresh().first_of(style), fresh().last_of(style)};
    }

    /// The glyphs that come from a position in the caller's text; empty (first == last) if the mesh has no glyph from
    /// there. The glyphs of a cluster are consecutive, whatever the script's direction. If a cluster has several
    /// styles, the result is the glyphs of its first style. Cost: O(glyphs).
    [[nodiscard]] glyph_span glyphs_of(cluster_id cluster) const noexcept { return glyphs_of(cluster, all_glyphs()); }

    /// The glyphs of the cluster that have one style. Cost: O(glyphs of the style).
    [[nodiscard]] glyph_span glyphs_of(cluster_id cluster, style_id style) const noexcept
    {
        return glyphs_of(cluster, glyphs_of(style));
    }

    /// The glyphs in the mesh: style by style, in drawing order within a style.
    [[nodiscard]] std::span<const drawn_glyph> glyphs() const noexcept { return fresh().records.view(); }

    /// The glyphs of the run that one of glyphs() represents, ascending: this glyph alone, or all glyphs that
    /// text_options::merge merged with it. glyph < glyphs().size().
    [[nodiscard]] std::span<const std::uint32_t> members(std::size_t glyph) const noexcept
    {
        const drawn_glyph& s = fresh().records[glyph];
        if (s.merged == drawn_glyph::none) return {&s.glyph, 1};
        return glyphs_->merged.members_of(glyphs_->merged.groups[s.merged]);
    }

    /// The owner of a triangle, as an index in the run. A wall's triangle belongs to the glyph on whose outline the
    /// wall stands. A cap's triangle belongs to the glyph to whose outline all contour edges at its corners belong. If
    /// these edges belong to several glyphs, the owner is shared_glyph. This requires an extruder that writes caps in
    /// the order of the region's triangles and walls edge by edge, with equally many triangles for each edge, such as
    /// flat and extruded. If an extruder makes its own caps (bevelled), all triangles of merged glyphs are shared. So
    /// are all walls if their triangles cannot be divided equally among the edges.
    ///
    ///     triangle    its position in range(glyph, p), below index_count / 3
    [[nodiscard]] std::uint32_t owner(std::size_t glyph, part p, std::uint32_t triangle) const noexcept
    {
        const drawn_glyph& s = fresh().records[glyph];
        if (s.merged == drawn_glyph::none) return s.glyph;
        if (has_own_caps(extruder_)) return shared_glyph;
        const merged_group& group = glyphs_->merged.groups[s.merged];
        if (p == part::side) {
            const auto owners = glyphs_->merged.owners_of(group);  // one for each edge
            const auto triangles = static_cast<std::size_t>(s.built->sizes().triangles[part::side]);
            if (triangles % owners.size() != 0) return shared_glyph;
            return owners[triangle / (triangles / owners.size())];
        }
        if (p > part::side) return shared_glyph;
        return glyphs_->merged.owner_of(group, s.built->form().triangles[triangle]);
    }

    /// The owner of a triangle of the mesh, for example the triangle below a mouse pointer. Cost: O(log glyphs)
    ///
    ///     triangle    its position in range(p), below index_count / 3
    [[nodiscard]] mesh_hit hit(part p, std::uint32_t triangle) const noexcept
    {
        TYPEMESH_ASSERT(triangle < range(p).index_count / 3, "the part has no triangle of this number");
        const std::uint32_t index = range(p).first_index + 3 * triangle;
        const auto ends_behind = [&](std::size_t g) noexcept {
            const mesh_range r = range(g, p);
            return r.first_index + r.index_count > index;
        };
        const std::size_t glyph = first_where(0, fresh().records.size(), ends_behind);
        return hit_within(glyph, p, (index - range(glyph, p).first_index) / 3);
    }

    /// The owner of a triangle of the mesh, for callers that do not know its part. Cost: O(log glyphs)
    ///
    ///     triangle    its position in range(), below index_count / 3
    [[nodiscard]] mesh_hit hit(std::uint32_t triangle) const noexcept
    {
        TYPEMESH_ASSERT(triangle < range().index_count / 3, "the mesh has no triangle of this number");
        std::size_t k = parts().size() - 1;  // the last part that begins at or before the triangle
        while (range(parts()[k]).first_index > 3 * triangle) --k;
        return hit(parts()[k], triangle - range(parts()[k]).first_index / 3);
    }

    /// The owner of a triangle of an instance. Cost: O(log contours) for merged glyphs, otherwise O(1)
    ///
    ///     drawn       from this plan's write_instances()
    ///     triangle    its position in mesh_part(drawn.mesh, p), below index_count / 3
    [[nodiscard]] mesh_hit hit(const glyph_instance& drawn, part p, std::uint32_t triangle) const noexcept
    {
        TYPEMESH_ASSERT(triangle < mesh_part(drawn.mesh, p).index_count / 3,
                        "this part of the mesh has no triangle of this number");
        return hit_within(drawn.glyph, p, triangle);
    }

    /// The place in the text that a point of the mesh shows, in em: the unit of laid_text. Positions in run(), divided
    /// by the units per em, are also in em. character_at() in picked_character.hpp finds the letter at the place.
    [[nodiscard]] point place_of(vec3 p) const noexcept
    {
        const text_placement& placed = fresh().placed;
        const auto product = [p](vec3 axis) noexcept {
            return as_double(axis.x) * as_double(p.x) + as_double(axis.y) * as_double(p.y) +
                   as_double(axis.z) * as_double(p.z);
        };
        const point from = {product(placed.frame.right), product(placed.frame.up)};
        return (1.0 / placed.units_per_em) * ((1.0 / placed.unit_per_font_unit) * from + placed.centre);
    }

    /// The place in the flat text, if a path moved the letter that was hit (on_path.hpp). It is exact for letters that
    /// the path only turns, and nearly so for warped ones.
    [[nodiscard]] point place_of(vec3 p, const mesh_hit& of) const noexcept
    {
        const text_glyphs& all = fresh();
        if (all.stands.empty()) return place_of(p);
        const std::uint32_t glyph = of.of_run == shared_glyph ? all.records[of.glyph].glyph : of.of_run;
        const glyph_stand& s = all.stands[glyph];
        const point arm = all.placed.units_per_em * place_of(p) - s.origin;
        return all.placed.em_per_font_unit *
               (run_->glyphs[glyph].origin + point{dot(arm, s.right), cross(s.right, arm)});
    }

    /// The report: which glyphs are not in the mesh, and why.
    [[nodiscard]] const text_report& report() const noexcept { return fresh().report; }

    /// The shaped text of the mesh: every glyph with its position and cluster, every line.
    [[nodiscard]] const glyph_run& run() const noexcept
    {
        (void)fresh();
        return *run_;
    }

    /// The bounding box of all vertices. It is exact for frames whose axes are parallel to the coordinate axes, unless
    /// a path turns letters; otherwise it may be larger.
    [[nodiscard]] bounds3 bounds() const noexcept { return fresh().bounds; }

    /// The distance between adjacent 32-bit floats at the mesh's farthest coordinate, in em. No position is rounded by
    /// more than half this distance, or by little more than the distance if the frame's axes are not parallel to the
    /// coordinate axes. Features thinner than twice the distance may collapse; see flipped_triangles.hpp.
    [[nodiscard]] double position_step() const noexcept
    {
        const text_glyphs& all = fresh();
        float farthest = 0.0f;
        for (const vec3 corner : {all.bounds.low, all.bounds.high})
            for (const float v : {corner.x, corner.y, corner.z})
                farthest = std::fabs(v) > farthest ? std::fabs(v) : farthest;
        const float next = std::nextafter(farthest, (std::numeric_limits<float>::max)());
        return (as_double(next) - as_double(farthest)) / (all.placed.unit_per_font_unit * all.placed.units_per_em);
    }

    /// The placement that the extruder receives for one glyph.
    [[nodiscard]] placement place(std::size_t glyph) const noexcept { return fresh().place(fresh().records[glyph]); }
    /// The text's frame: text_options::frame. place() turns it for a glyph that a path turns.
    [[nodiscard]] const typemesh::frame& text_frame() const noexcept { return fresh().placed.frame; }

    /// Calls put(a, b, c) with the grid points of each triangle of a glyph that faces the front, as its extruder
    /// reports them (seen_from_front in extruder.hpp). Without a report, these are the region's triangles.
    template <class Put>
    void each_seen_from_front(std::size_t glyph, Put&& put) const noexcept
    {
        typemesh::each_seen_from_front(extruder_, fresh().records[glyph].built->template planned<Extruder>().form, put);
    }

    /// N in the vertex counts 2N, 4N and 4N + 2H: the number of contour points. H is the number of hard points among
    /// them, whose side vertices are doubled. Seams of em mapping are no hard points; their vertices come in addition.
    /// N is the number for letters as drawn, before an extruder moves their edges. Cost: O(glyphs), and O(points) for
    /// H.
    [[nodiscard]] std::uint64_t contour_points() const noexcept
    {
        std::uint64_t points = 0;
        for (const drawn_glyph& s : fresh().records) points += s.built->form().points.size();
        return points;
    }
    /// H: see contour_points().
    [[nodiscard]] std::uint64_t hard_edges() const noexcept
        requires has_hard_edges<Extruder>
    {
        std::uint64_t hard = 0;
        for (const drawn_glyph& r : fresh().records) hard += extruder_.hard_edges(r.built->planned<Extruder>().form);
        return hard;
    }

    /// Emits every vertex and every triangle once, in ascending order. Only the sink can fail, in begin() or end();
    /// nothing is allocated. error::unknown_letters: the sink wants letter data; call find_letters() first.
    template <class Sink>
        requires mesh_sink<std::remove_reference_t<Sink>>
    result<void> write(Sink&& sink) const noexcept
    {
        if (error e = detail::refused_letters<std::remove_cvref_t<Sink>>(fresh())) return e;
        if (error e = sink.begin(size())) return e;
        whole().everything(extruder_, sink);
        return end_of(sink);
    }

    /// Emits the mesh with several workers, in equal shares; the output is bit for bit the output of one worker. The
    /// sink must take subranges (see ranged_sink), like the sinks over arrays and containers. Each share is written in
    /// ascending order.
    template <class Sink, executor Executor>
        requires ranged_sink<std::remove_reference_t<Sink>>
    result<void> write(Sink&& sink, Executor& workers) const noexcept
    {
        if (error e = detail::refused_letters<std::remove_cvref_t<Sink>>(fresh())) return e;
        if (error e = sink.begin(size())) return e;
        const mesh_layout all = whole();
        const std::size_t shares = shares_for(workers.workers());
        workers.run(shares, [&, this](std::size_t k, std::size_t) noexcept {
            all.share(k, shares, extruder_, std::as_const(sink));
        });
        return end_of(sink);
    }

    /// Writes only some consecutive glyphs, each part to its range of the whole mesh. It is for a text that has changed
    /// little since it was written. In each part, vertices are written in ascending order, then indices. Everything
    /// else is left unchanged.
    ///
    ///     keep of the previous text   size(), and range(glyph, part) of each glyph that will change
    ///     if size() and these ranges have not changed, nothing else has moved: write these glyphs
    ///     otherwise                   write the whole mesh
    ///
    /// The vertices of the other glyphs must also be unchanged. They depend on the pen positions (the advance of the
    /// changed glyphs) and, with texture_box::text, texture_box::line or output_unit::unit_box, on the box.
    ///
    /// Fails as write() does. The sink must refer to memory that holds the whole mesh, not to a container of another
    /// size.
    template <class Sink>
        requires ranged_sink<std::remove_reference_t<Sink>>
    result<void> write(glyph_span some, Sink&& sink) const noexcept
    {
        if (error e = detail::refused_letters<std::remove_cvref_t<Sink>>(fresh())) return e;
        const mesh_layout all = whole();
        if (error e = sink.begin(all.size())) return e;
        for (const part p : parts_of<Extruder>) {
            auto piece = std::as_const(sink).subrange(range(some, p));
            all.vertices(p, some.first, some.last, extruder_, piece);
            all.triangles(p, some.first, some.last, extruder_, piece);
        }
        return end_of(sink);
    }

    // Overloads that refuse arrays without their into().
    template <array_without_sink Vertices, array_without_sink Indices, class... Workers>
    result<void> write(Vertices&&, Indices&&, Workers&...) const noexcept
    {
        return refuse_arrays<Vertices>();
    }
    template <array_without_sink Vertices, array_without_sink Indices>
    result<void> write(glyph_span, Vertices&&, Indices&&) const noexcept
    {
        return refuse_arrays<Vertices>();
    }
    template <array_without_sink Vertices, array_without_sink Indices>
    result<void> write_meshes(Vertices&&, Indices&&) const noexcept
    {
        return refuse_arrays<Vertices>();
    }

    /// The text's distinct glyphs; write_meshes() writes each of them once.
    [[nodiscard]] std::span<const glyph_mesh> meshes() const noexcept { return fresh().meshes.view(); }

    /// The shape of a mesh: the key for keeping it from plan to plan, see glyph_shape.hpp. mesh < meshes().size().
    [[nodiscard]] glyph_shape shape_of(std::size_t mesh) const noexcept { return fresh().shape_of(mesh, *run_); }

    /// The exact size of write_meshes()'s output. There are glyphs().size() instances.
    [[nodiscard]] mesh_size meshes_size() const noexcept
    {
        mesh_size all;
        for (const glyph_mesh& m : meshes()) all = all + m.built->sizes().total();
        return all;
    }

    /// The range of one part of a mesh in the output of write_meshes(). mesh < meshes().size().
    [[nodiscard]] mesh_range mesh_part(std::size_t mesh, part p) const noexcept
    {
        const glyph_mesh& m = fresh().meshes[mesh];
        return m.built->sizes().range(p, m.first_vertex, m.first_index);
    }

    /// Writes every distinct glyph once, at the output's origin, for instanced drawing.
    ///
    ///     vertices   [ mesh 0: front, back, side | mesh 1: front, back, side | ... ]      indices likewise
    ///
    /// Further parts of the extruder follow the side. Textures cover each glyph's own box; in em mapping they begin at
    /// the glyph's own origin. Fails as write() does.
    template <class Sink>
        requires mesh_sink<std::remove_reference_t<Sink>>
    result<void> write_meshes(Sink&& sink) const noexcept
    {
        const text_glyphs& all = fresh();
        if (error e = sink.begin(meshes_size())) return e;
        for (const glyph_mesh& m : all.meshes)
            for (const part p : parts_of<Extruder>)
                write_vertices(p, m.built->planned<Extruder>(), extruder_, all.place(m), sink);
        const bool turned = all.placed.frame.turns_triangles();
        for (const glyph_mesh& m : all.meshes) {
            const first_vertices first = m.built->sizes().vertices.starts(m.first_vertex);
            for (const part p : parts_of<Extruder>)
                write_triangles(p, m.built->planned<Extruder>(), extruder_, first, turned, sink);
        }
        return end_of(sink);
    }

    /// The counterpart of write_meshes(): put(const glyph_instance&) for every glyph, first the glyphs of mesh 0
    /// (glyph_mesh::glyph_count of them, style by style), then the glyphs of mesh 1, and so on. A mesh turned and
    /// moved by its instance equals the placed glyph, except for rounding and for the origin of its textures.
    template <class Put>
    void write_instances(Put&& put) const noexcept
    {
        const text_glyphs& all = fresh();
        for (std::uint32_t mesh = 0; mesh < all.meshes.size(); ++mesh) {
            for (std::uint32_t i = all.meshes[mesh].first_glyph; i != drawn_glyph::none;
                 i = all.records[i].next_alike) {
                const drawn_glyph& s = all.records[i];
                glyph_instance instance{all.translation_of(s), mesh, i, s.id, s.cluster, s.style, all.letter_of(i)};
                turn(instance, s.right, all.placed.frame);
                put(instance);
            }
        }
    }

    /// The instances with one mesh and one style, which are drawn at once with one material. mesh < meshes().size().
    /// Cost: O(instances of the mesh)
    [[nodiscard]] instance_range instances(std::size_t mesh, style_id style) const noexcept
    {
        const text_glyphs& all = fresh();
        instance_range found{all.meshes[mesh].first_instance, 0};
        for (std::uint32_t i = all.meshes[mesh].first_glyph; i != drawn_glyph::none; i = all.records[i].next_alike) {
            if (all.records[i].style < style)
                ++found.first;
            else if (all.records[i].style == style)
                ++found.count;
        }
        return found;
    }

private:
    const text_glyphs& fresh() const noexcept
    {
        TYPEMESH_ASSERT(glyphs_ != nullptr, "a text_plan was used after it had been moved from");
        TYPEMESH_ASSERT(glyphs_->generation.number == generation_,
                        "this text_plan is stale: its mesher has made another plan or was moved since");
        TYPEMESH_ASSERT(glyphs_->lent.are_there(),
                        "this text_plan is stale: its glyph_workers has built another plan since");
        return *glyphs_;
    }

    [[nodiscard]] mesh_hit hit_within(std::size_t glyph, part p, std::uint32_t triangle) const noexcept
    {
        const std::uint32_t of_run = owner(glyph, p, triangle);
        const bool shared = of_run == shared_glyph;
        return {glyph, of_run, shared ? glyphs()[glyph].cluster : run().glyphs[of_run].cluster};
    }

    [[nodiscard]] glyph_span all_glyphs() const noexcept { return {0, fresh().records.size()}; }

    /// The first consecutive glyphs of a cluster within the span `among`.
    [[nodiscard]] glyph_span glyphs_of(cluster_id cluster, glyph_span among) const noexcept
    {
        const auto records = glyphs();
        std::size_t first = among.first;
        while (first < among.last && records[first].cluster != cluster) ++first;
        std::size_t last = first;
        while (last < among.last && records[last].cluster == cluster) ++last;
        return {first, last};
    }

    [[nodiscard]] mesh_layout whole() const noexcept { return {fresh(), 0, fresh().records.size()}; }

    /// The number of shares: so many that no worker waits long for another, but so few that each share is worth
    /// distributing.
    [[nodiscard]] std::size_t shares_for(std::size_t workers) const noexcept
    {
        if (workers <= 1) return 1;
        const std::uint64_t worth = size().vertices / 2048 + 1;
        return worth < 8 * workers ? static_cast<std::size_t>(worth) : 8 * workers;
    }

    text_glyphs* glyphs_;
    const glyph_run* run_;
    Extruder extruder_;
    std::uint64_t generation_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
