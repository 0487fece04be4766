// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/executor.hpp>
#include <typemesh/layout/impl/shaped_text.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Shapes the items of a text with several workers, each with its own shaper. The glyphs are the same as with one
/// shaper, and so is the error: the first item's that has one. It keeps its memory for the next text.
class shared_shaping {
public:
    explicit shared_shaping(memory source = heap()) noexcept : items_{source}, places_{source}, blocks_{source} {}

    /// Shapes the items of a text that has been read. Then items() has the glyphs of each.
    ///
    ///     shaper_of(worker)    the worker's shaper
    ///     glyphs_of(worker)    the worker's memory, buffer<shaped_glyph>&; unchanged until the text is shaped
    ///
    /// Fails  error::out_of_memory; the items have the errors of shapers
    template <executor Executor, class ShaperOf, class GlyphsOf>
    error operator()(Executor& workers, const ShaperOf& shaper_of, const GlyphsOf& glyphs_of,
                     const shaped_text& shaped) noexcept
    {
        const std::size_t count = workers.workers();
        if (error e = find_blocks(shaped, 8 * count)) return e;
        for (std::size_t w = 0; w < count; ++w) glyphs_of(w).clear();
        workers.run(blocks_.size(), [&, this](std::size_t b, std::size_t worker) noexcept {
            buffer<shaped_glyph>& glyphs = glyphs_of(worker);
            auto&& with = shaper_of(worker);
            const std::uint32_t last = b + 1 < blocks_.size() ? blocks_[b + 1] : item_count(shaped);
            for (std::uint32_t i = blocks_[b]; i < last; ++i) {
                const text_item& item = shaped.items()[i];
                if (silent_at(shaped.text(), item.first) != 0) continue;
                const std::size_t first = glyphs.size();
                items_[i].failure = with.shape(shaped.text(), item, shaped.options_of(i), glyphs);
                if (items_[i].failure) return;  // later items of this block do not matter
                places_[i] = {worker, first, glyphs.size() - first};
            }
        });
        for (std::size_t i = 0; i < items_.size(); ++i) {
            const buffer<shaped_glyph>& glyphs = glyphs_of(places_[i].worker);
            items_[i].glyphs = glyphs.view().subspan(places_[i].first, places_[i].count);
        }
        return {};
    }

    /// The glyphs of the items, in the workers' memory.
    [[nodiscard]] array_view<const shaped_item> items() const noexcept { return items_.view(); }

private:
    /// The place of an item's glyphs in its worker's memory.
    struct place {
        std::size_t worker = 0, first = 0, count = 0;
    };

    static std::uint32_t item_count(const shaped_text& shaped) noexcept
    {
        return static_cast<std::uint32_t>(shaped.items().size());
    }

    /// Groups the items into about `wanted` blocks of equal length. Very short blocks are avoided.
    error find_blocks(const shaped_text& shaped, std::size_t wanted) noexcept
    {
        items_.clear();
        places_.clear();
        blocks_.clear();
        const std::size_t length = shaped.text().size() / wanted, least = length > 256 ? length : 256;
        std::uint32_t begin = 0;
        for (std::uint32_t i = 0; i < item_count(shaped); ++i) {
            const std::uint32_t at = shaped.items()[i].first;
            if (i == 0 || at - begin >= least) {
                if (!blocks_.push_back(i)) return error::out_of_memory;
                begin = at;
            }
            if (!items_.push_back({}) || !places_.push_back({})) return error::out_of_memory;
        }
        return {};
    }

    buffer<shaped_item> items_;
    buffer<place> places_;
    buffer<std::uint32_t> blocks_;  // the first item of each
};

/// Workers that shape the items of a text: team.shape(shared, shaped) calls shared(...) with its executor.
template <class T>
concept shaping_team = requires(T& team, shared_shaping& shared, const shaped_text& shaped) {
    { team.shape(shared, shaped) } noexcept -> std::same_as<error>;
};

/// No workers: the caller shapes.
struct no_team {
    error shape(shared_shaping&, const shaped_text&) noexcept { return {}; }
};

}  // namespace typemesh::inline TYPEMESH_ABI
