// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/layout/ligature_carets.hpp>
#include <typemesh/layout/shaped_glyph.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The carets inside the ligatures of a shaped text, by cluster.
class cluster_carets {
public:
    explicit cluster_carets(memory source = heap()) noexcept : clusters_{source}, places_{source} {}

    /// A cluster that needs carets.
    struct wanted {
        std::uint32_t cluster = 0;  ///< its number, greater than all previous ones
        std::uint32_t count = 0;    ///< the number of carets that it needs
        double scale = 1.0;         ///< of its glyphs
        bool down = false;          ///< the pen moves down
        bool turned = false;        ///< the glyphs lie on their side: their font treats them as in a line
    };

    /// Gets the carets of a cluster from a font. Keeps them if their number is right, they ascend, and they lie inside.
    ///
    ///     glyphs   the glyphs of the cluster, as they are set
    ///
    /// Fails  error::out_of_memory; nothing is kept then
    template <has_ligature_carets Font>
    error find(const Font& font, array_view<const shaped_glyph> glyphs, const wanted& which) noexcept
    {
        double all = 0.0, pen = 0.0;
        for (const shaped_glyph& g : glyphs) all += g.advance;
        const std::size_t before = places_.size();
        for (const shaped_glyph& g : glyphs) {
            error e = font.ligature_carets(g.face, g.id, which.down && !which.turned, places_);
            const double from = pen + (which.down ? 0.0 - g.offset.y : g.offset.x);
            if (!e && sets(before, from, all, which)) {
                if (clusters_.push_back({which.cluster, static_cast<std::uint32_t>(before)})) return {};
                e = error::out_of_memory;
            }
            places_.truncate(before);
            if (e) return e;
            pen += g.advance;
        }
        return {};
    }

    /// The carets of a cluster, measured from the start of its pen. Cost: O(log clusters)
    [[nodiscard]] array_view<const double> of(std::uint32_t cluster) const noexcept
    {
        const std::size_t k = first_at(cluster);
        if (k == clusters_.size() || clusters_[k].cluster != cluster) return {};
        const std::size_t first = clusters_[k].first;
        const std::size_t last = k + 1 < clusters_.size() ? clusters_[k + 1].first : places_.size();
        return places_.view().subspan(first, last - first);
    }

    /// Removes the clusters from a number on.
    void truncate(std::size_t cluster) noexcept
    {
        const std::size_t k = first_at(cluster);
        if (k == clusters_.size()) return;
        places_.truncate(clusters_[k].first);
        clusters_.truncate(k);
    }
    void clear() noexcept
    {
        clusters_.clear();
        places_.clear();
    }

private:
    struct owner {
        std::uint32_t cluster, first;  // of its places
    };

    /// Scales and moves the places from `first` on. Returns whether they are valid.
    bool sets(std::size_t first, double from, double all, const wanted& which) noexcept
    {
        if (places_.size() - first != which.count) return false;
        double before = 0.0;
        for (double& place : places_.view().subspan(first)) {
            place = from + which.scale * place;
            if (!(place > before)) return false;
            before = place;
        }
        return before < all;
    }

    [[nodiscard]] std::size_t first_at(std::size_t cluster) const noexcept
    {
        const auto is_at = [&](std::size_t k) noexcept { return clusters_[k].cluster >= cluster; };
        return first_where(0, clusters_.size(), is_at);
    }

    buffer<owner> clusters_;
    buffer<double> places_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
