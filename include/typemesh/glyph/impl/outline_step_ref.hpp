// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/glyph/outline_step.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Refers to an outline_step of any type, which must outlive it, or to no_outline_step. One indirect call runs the step
/// on a glyph.
class outline_step_ref {
public:
    /// One table for each type of step.
    struct calls {
        result<double> (*step)(const void* how, const outline& drawn, const drawn_place& at, double tolerance,
                               std::uint32_t most, outline& out) noexcept;  // null: no_outline_step
        error (*refused)(const void* how, const box& text) noexcept;
        error (*place)(const void* how, const glyph_run& run, double units_per_em,
                       glyph_stand* stands) noexcept;  // null: it has none
    };
    template <class S>
        requires(outline_step<S> || std::same_as<S, no_outline_step>)
    struct table {
        static const calls of;
    };

    outline_step_ref() noexcept;  ///< to no_outline_step
    template <outline_step S>
    outline_step_ref(const S& how) noexcept : outline_step_ref{&how, table<S>::of}
    {
    }
    outline_step_ref(const void* how, const calls& does) noexcept : how_{how}, does_{&does} {}

    /// Whether it refers to no_outline_step.
    [[nodiscard]] bool is_none() const noexcept { return does_->step == nullptr; }

    /// Needs a step.
    [[nodiscard]] result<double> operator()(const outline& drawn, const drawn_place& at, double tolerance,
                                            std::uint32_t most, outline& out) const noexcept
    {
        return does_->step(how_, drawn, at, tolerance, most, out);
    }
    /// See outline_step; none without a step.
    [[nodiscard]] error refused(const box& text) const noexcept
    {
        return is_none() ? error{} : does_->refused(how_, text);
    }
    /// Whether it says where glyphs stand: see placing_step.
    [[nodiscard]] bool places() const noexcept { return does_->place != nullptr; }
    /// Needs a step that places.
    [[nodiscard]] error place(const glyph_run& run, double units_per_em, glyph_stand* stands) const noexcept
    {
        return does_->place(how_, run, units_per_em, stands);
    }

private:
    static constexpr no_outline_step none{};

    const void* how_;
    const calls* does_;
};

template <class S>
    requires(outline_step<S> || std::same_as<S, no_outline_step>)
constinit const outline_step_ref::calls outline_step_ref::table<S>::of = [] {
    calls made{nullptr, nullptr, nullptr};
    if constexpr (outline_step<S>) {
        made.step = [](const void* how, const outline& drawn, const drawn_place& at, double tolerance,
                       std::uint32_t most, outline& out) noexcept -> result<double> {
            return (*static_cast<const S*>(how))(drawn, at, tolerance, most, out);
        };
        made.refused = [](const void* how, const box& text) noexcept {
            return static_cast<const S*>(how)->refused(text);
        };
        if constexpr (placing_step<S>)
            made.place = [](const void* how, const glyph_run& run, double units_per_em, glyph_stand* stands) noexcept {
                return static_cast<const S*>(how)->place(run, units_per_em, stands);
            };
    }
    return made;
}();

inline outline_step_ref::outline_step_ref() noexcept : outline_step_ref{&none, table<no_outline_step>::of} {}

}  // namespace typemesh::inline TYPEMESH_ABI
