// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/core/impl/taken.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/plain_text.hpp>
#include <typemesh/layout/shape_options.hpp>
#include <typemesh/layout/shaped_glyph.hpp>
#include <typemesh/layout/text_item.hpp>
#include <typemesh/unicode/impl/grapheme_boundaries.hpp>
#include <typemesh/unicode/text_range.hpp>
#include <typemesh/unicode/text_view.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Shapes with several faces. Where a face lacks glyphs, the next face shapes the text.
///
///     text      t e a   R S T !      Face 0 shapes the whole text. Face 1 shapes the hole; the text around it is
///     face 0    t e a   - - - !      context, so its letters join as with face 1 only.
///     face 1            R S T
///
/// A hole consists of whole graphemes and whole clusters, so no grapheme has two faces. Controls and invisible
/// characters are never looked up in another face. Text that no face has is drawn by the item's own face, flagged as
/// missing. Faces are tried by number: first the item's face, then the others from 0 on.
///
/// The parameter `Faces` below is one of several classes:
///
///     f.face_count()                         faces are numbered from 0; found faces are added
///     f.shape(text, item, o, glyphs)         as in shaper, by face item.face, in the units of face 0 and with the
///                                            face's number in the glyphs: see font_faces.hpp
///     f.find(text, range, script, language)  result: the number of another face for a grapheme that no face has, or
///                                            no_face if there is no such face. Classes that find no faces omit this
///                                            function.
///
/// It keeps its memory for the next item.
class fallback_shaping {
public:
    static constexpr std::uint32_t no_face = 0xFFFFu;

    explicit fallback_shaping(memory source = heap()) noexcept
        : now_{source}, made_{source}, clusters_{source}, graphemes_{source}
    {
    }

    /// Shapes an item like a shaper. `face` of each glyph is the face that the glyph belongs to.
    ///
    /// Fails  as the faces do, except that error::needs_shaping of other faces counts as a missing script
    /// Cost   the cost of the item's own face, if this face has all glyphs; otherwise one more call for each hole and
    ///        face, and O(n) for each face that is tried
    template <class Faces>
    error shape(Faces& faces, text_view text, const text_item& item, const shape_options& how,
                buffer<shaped_glyph>& glyphs) noexcept
    {
        const std::size_t before = glyphs.size();
        if (error e = faces.shape(text, item, how, glyphs)) return e;
        glyph_flags all = glyph_flags::none;
        for (const shaped_glyph& g : glyphs.view().subspan(before)) all = all | g.flags;
        return has(all, glyph_flags::missing) ? fill_holes(faces, {text, item, how}, before, glyphs) : error{};
    }

private:
    struct job {
        text_view text;
        const text_item& item;
        const shape_options& how;
    };

    /// A cluster of an item, and its glyphs.
    struct cluster {
        cluster_id first = 0;
        std::uint32_t glyph = 0, glyph_count = 0;
        bool missing = false;  // whether the cluster lacks glyphs and may be looked up in other faces
        bool unsafe = false;
    };

    /// Clusters [first, last) of an item.
    struct hole {
        std::size_t first, last;
    };

    /// Fills the holes of an item whose glyphs are glyphs[before, ..).
    template <class Faces>
    error fill_holes(Faces& faces, const job& of, std::size_t before, buffer<shaped_glyph>& glyphs) noexcept
    {
        std::uint32_t known = faces.face_count();
        constexpr bool finds = requires { faces.find(of.text, text_range{}, of.item.script, of.how.language); };
        if (!finds && known < 2) return {};
        now_.clear();
        if (!now_.append(glyphs.view().subspan(before))) return error::out_of_memory;
        if (of.item.to_the_left()) reverse(now_.view());
        if (error e = find_graphemes(of)) return e;

        bool open = true;  // whether there may be holes
        for (std::uint32_t face = 0; face < known && open; ++face)
            if (face != of.item.face)
                if (error e = fill_with(faces, of, face, open)) return e;
        if constexpr (finds)
            while (open) {
                if (error e = ask(faces, of, known)) return e;
                const std::uint32_t from = known;
                known = faces.face_count();
                if (from == known) break;
                for (std::uint32_t face = from; face < known && open; ++face)
                    if (error e = fill_with(faces, of, face, open)) return e;
            }
        if (open)
            if (error e = fill_with(faces, of, of.item.face, open)) return e;

        if (of.item.to_the_left()) reverse(now_.view());
        glyphs.truncate(before);
        return glyphs.append(now_.view()) ? error{} : error{error::out_of_memory};
    }

    /// Shapes all holes with one face. The item's own face also shapes text that was given up. `open`: whether there
    /// were any holes.
    template <class Faces>
    error fill_with(Faces& faces, const job& of, std::uint32_t face, bool& open) noexcept
    {
        if (error e = find_clusters(of, face == of.item.face)) return e;
        made_.clear();
        std::size_t kept = 0;
        for (hole h = next_hole(0); h.first < clusters_.size(); h = next_hole(h.last)) {
            if (!keep(kept, h.first)) return error::out_of_memory;
            if (error e = fill(faces, of, h, face)) return e;
            kept = h.last;
        }
        open = kept != 0;
        if (!open) return {};
        if (!keep(kept, clusters_.size())) return error::out_of_memory;
        now_.swap(made_);
        return {};
    }

    /// Shapes one hole with one face.
    template <class Faces>
    error fill(Faces& faces, const job& of, const hole& h, std::uint32_t face) noexcept
    {
        const std::size_t before = made_.size();
        text_item part = of.item;
        part.first = clusters_[h.first].first;
        part.last = end_of(of, h.last - 1);
        part.face = static_cast<std::uint16_t>(face);
        const error e = faces.shape(of.text, part, of.how, made_);
        if (e == error::needs_shaping && face != of.item.face) {
            made_.truncate(before);
            return keep(h.first, h.last) ? error{} : error{error::out_of_memory};
        }
        if (e) return e;
        const array_view<shaped_glyph> made = made_.view().subspan(before);
        if (of.item.to_the_left()) reverse(made);
        // A line could not end before an unsafe cluster, and cannot now, because the text beside the hole has not been
        // shaped again. A line cannot end inside a grapheme either: part of it may have another face.
        std::size_t k = h.first;
        for (shaped_glyph& g : made) {
            while (k + 1 < h.last && clusters_[k + 1].first <= g.cluster) ++k;
            if (clusters_[k].unsafe || clusters_[k].first != g.cluster || !begins_grapheme(g.cluster))
                g.flags = g.flags | glyph_flags::unsafe_to_break;
        }
        return {};
    }

    /// Looks for faces for the text that the first `known` faces lack, and gives up text that has none. If a face is
    /// found, that face gets the rest of the hole.
    template <class Faces>
    error ask(Faces& faces, const job& of, std::uint32_t known) noexcept
    {
        if (error e = find_clusters(of, false)) return e;
        for (hole h = next_hole(0); h.first < clusters_.size(); h = next_hole(h.last))
            for (std::size_t k = h.first, next = k; k < h.last; k = next) {
                do ++next;
                while (next < h.last && !begins_grapheme(clusters_[next].first));
                const text_range range{clusters_[k].first, end_of(of, next - 1)};
                const result<std::uint32_t> face = faces.find(of.text, range, of.item.script, of.how.language);
                if (!face) return face.error();
                if (*face >= known && *face != no_face) break;
                for (; k < next; ++k)
                    for (shaped_glyph& g : glyphs_of(clusters_[k])) g.face = no_face;
            }
        return {};
    }

    /// Finds where the graphemes of an item begin.
    error find_graphemes(const job& of) noexcept
    {
        graphemes_.clear();
        grapheme_boundaries begins;
        for (std::size_t i = of.item.first; i < of.item.last;) {
            const code_point c = decode(of.text, i, of.item.last);
            if (begins(character_of(c.value).grapheme) && !graphemes_.push_back(static_cast<std::uint32_t>(i)))
                return error::out_of_memory;
            i = c.next;
        }
        return {};
    }
    [[nodiscard]] bool begins_grapheme(cluster_id unit) const noexcept
    {
        const std::size_t k =
            first_where(0, graphemes_.size(), [&](std::size_t i) noexcept { return graphemes_[i] >= unit; });
        return k < graphemes_.size() && graphemes_[k] == unit;
    }

    /// Gathers the glyphs into clusters.
    error find_clusters(const job& of, bool with_given_up) noexcept
    {
        clusters_.clear();
        for (std::uint32_t i = 0; i < now_.size();) {
            cluster c{.first = clusters_.empty() ? of.item.first : now_[i].cluster, .glyph = i};
            bool missing = false, given_up = false;
            const cluster_id id = now_[i].cluster;
            for (; i < now_.size() && now_[i].cluster == id; ++i, ++c.glyph_count) {
                missing = missing || has(now_[i].flags, glyph_flags::missing);
                given_up = given_up || now_[i].face == no_face;
                c.unsafe = c.unsafe || has(now_[i].flags, glyph_flags::unsafe_to_break);
            }
            const cluster_id end = i < now_.size() ? now_[i].cluster : of.item.last;
            c.missing = given_up ? with_given_up : missing && is_drawn(of.text, c.first, end);
            if (!clusters_.push_back(c)) return error::out_of_memory;
        }
        return {};
    }

    /// Whether text[first, last) contains more than controls and invisible characters.
    [[nodiscard]] static bool is_drawn(text_view text, std::size_t first, std::size_t last) noexcept
    {
        using enum grapheme_class;
        while (first < last) {
            const code_point c = decode(text, first, last);
            const grapheme_class kind = character_of(c.value).grapheme;
            if (kind != control && kind != cr && kind != lf && !is_default_ignorable(c.value)) return true;
            first = c.next;
        }
        return false;
    }

    /// The first hole from a cluster on; the cluster begins a grapheme. If there is no hole, the result is empty and
    /// lies after the last cluster.
    [[nodiscard]] hole next_hole(std::size_t from) const noexcept
    {
        hole h{from, from};
        while (h.first < clusters_.size() && !clusters_[h.first].missing) ++h.first;
        h.last = h.first;
        while (h.first > from && h.first < clusters_.size() && !begins_grapheme(clusters_[h.first].first)) --h.first;
        while (h.last < clusters_.size() && (clusters_[h.last].missing || !begins_grapheme(clusters_[h.last].first)))
            ++h.last;
        return h;
    }

    [[nodiscard]] cluster_id end_of(const job& of, std::size_t k) const noexcept
    {
        return k + 1 < clusters_.size() ? clusters_[k + 1].first : of.item.last;
    }
    [[nodiscard]] array_view<shaped_glyph> glyphs_of(const cluster& c) noexcept
    {
        return now_.view().subspan(c.glyph, c.glyph_count);
    }

    /// Copies clusters [first, last) unchanged.
    [[nodiscard]] bool keep(std::size_t first, std::size_t last) noexcept
    {
        if (first == last) return true;
        const std::size_t begin = clusters_[first].glyph,
                          end = clusters_[last - 1].glyph + clusters_[last - 1].glyph_count;
        return made_.append(array_view<const shaped_glyph>{now_.view().subspan(begin, end - begin)});
    }

    static void reverse(array_view<shaped_glyph> glyphs) noexcept
    {
        for (std::size_t i = 0, k = glyphs.size(); i + 1 < k; ++i) swap_values(glyphs[i], glyphs[--k]);
    }

    buffer<shaped_glyph> now_;   // the glyphs of the item, in the order of its text
    buffer<shaped_glyph> made_;  // the glyphs with the holes filled
    buffer<cluster> clusters_;
    buffer<std::uint32_t> graphemes_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
