// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/face_metrics.hpp>
#include <typemesh/layout/impl/itemise.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/layout/style_spans.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// The settings of an item from its style. Lengths are in font units.
struct item_setting {
    double scale = 1.0;           ///< of its letters
    double lift = 0.0;            ///< of superscripts and subscripts
    double letter_spacing = 0.0;  ///< including the whole text's
};

/// The settings of a text's items from its styles.
class item_settings {
public:
    explicit item_settings(memory source = heap()) noexcept : settings_{source}, features_{source}, tried_{source} {}

    /// The settings of a text without styles. Lengths are in font units.
    struct base {
        shape_options options;
        double letter_spacing = 0.0;
    };

    /// Gives each item its style and face, and finds its settings. Without spans it does nothing.
    ///
    /// Fails  error::out_of_memory, and as the shaper does, which shapes superscripts and subscripts
    template <shaper Shaper>
    error read(Shaper& shaper, text_view text, const text_analysis& found, const style_spans& styles, const base& plain,
               array_view<text_item> items) noexcept
    {
        plain_ = plain;
        clear();
        if (styles.empty()) return {};
        const double em = shaper.units_per_em();
        for (text_item& item : items) {
            item.style = styles.number_at(item.first);
            const text_style& s = styles[item.style];
            item.face = s.face;
            setting own{{s.size, 0.0, plain.letter_spacing + s.letter_spacing * em}, s.language, 0, 0};
            if (error e = add_features(plain.options.features, s.features, own)) return e;
            if (s.position != script_position::normal && silent_at(text, item.first) == 0)
                if (error e = set_small(shaper, text, found, item, s.position, own)) return e;
            if (!settings_.push_back(own)) return error::out_of_memory;
        }
        return {};
    }

    void clear() noexcept
    {
        settings_.clear();
        features_.clear();
    }

    /// The settings of an item.
    [[nodiscard]] item_setting operator[](std::uint32_t item) const noexcept
    {
        return settings_.empty() ? item_setting{.letter_spacing = plain_.letter_spacing} : settings_[item].how;
    }

    /// The shape options of an item.
    [[nodiscard]] shape_options options_of(std::uint32_t item) const noexcept
    {
        return settings_.empty() ? options_of(setting{{.letter_spacing = plain_.letter_spacing}, {}, 0, 0})
                                 : options_of(settings_[item]);
    }

private:
    struct setting {
        item_setting how;
        std::string_view language;
        std::uint32_t first_feature, feature_count;  // 0: the whole text's features
    };

    [[nodiscard]] shape_options options_of(const setting& s) const noexcept
    {
        shape_options how = plain_.options;
        if (!is_zero(s.how.letter_spacing)) how.ligatures = false;
        if (!s.language.empty()) how.language = s.language;
        if (s.feature_count != 0) how.features = features_.view().subspan(s.first_feature, s.feature_count);
        return how;
    }

    error add_features(array_view<const feature> some, array_view<const feature> more, setting& own) noexcept
    {
        if (more.empty()) return {};
        const auto first = static_cast<std::uint32_t>(features_.size());
        if (!features_.append(some) || !features_.append(more)) return error::out_of_memory;
        own.first_feature = first;
        own.feature_count = static_cast<std::uint32_t>(features_.size()) - first;
        return {};
    }

    /// Makes an item superscript or subscript. It uses the font's own letters if they change all glyphs, otherwise
    /// smaller letters.
    template <shaper Shaper>
    error set_small(Shaper& shaper, text_view text, const text_analysis& found, const text_item& item,
                    script_position position, setting& own) noexcept
    {
        const bool raised = position == script_position::superscript;
        const feature letters[] = {raised ? feature{"sups", 1} : feature{"subs", 1}};
        setting other = own;
        if (error e = add_features(options_of(own).features, letters, other)) return e;

        tried_.clear();
        if (error e = shaper.shape(text, item, options_of(own), tried_)) return e;
        const std::size_t count = tried_.size();
        if (error e = shaper.shape(text, item, options_of(other), tried_)) return e;
        bool all = tried_.size() == 2 * count;
        for (std::size_t g = 0; all && g < count; ++g)
            all = tried_[g].id != tried_[count + g].id || has(found.marks[tried_[g].cluster], text_mark::space);
        if (all) {
            own = other;
            return {};
        }
        const face_metrics metrics = face_metrics_of(shaper, item.face);
        const script_metrics& suggested = raised ? metrics.superscript : metrics.subscript;
        own.how.lift = suggested.rise * own.how.scale * shaper.units_per_em();
        own.how.scale *= suggested.size;
        return {};
    }

    base plain_;
    buffer<setting> settings_;  // of the items; empty without styles
    buffer<feature> features_;
    buffer<shaped_glyph> tried_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
