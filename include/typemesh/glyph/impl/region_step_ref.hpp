// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/policy_key.hpp>
#include <typemesh/extrude/impl/plan_scratch.hpp>
#include <typemesh/extrude/region_step.hpp>
#include <typemesh/glyph/region_caps.hpp>

#include <concepts>

namespace typemesh::inline TYPEMESH_ABI {

/// Refers to a region_step of any type, which must outlive it, or to no_step. One indirect call runs the step on a
/// glyph.
class region_step_ref {
public:
    /// One table for each type of step.
    struct calls {
        result<stepped_region> (*step)(const void* how, const region& drawn, plan_scratch& scratch,
                                       region_caps& caps) noexcept;  // null: no_step
        error (*refused_options)(const void* how) noexcept;
        policy_key (*key)(const void* how) noexcept;
    };
    template <class S>
        requires(region_step<S> || std::same_as<S, no_step>)
    struct table {
        static const calls of;
    };

    region_step_ref() noexcept;  ///< to no_step
    template <region_step S>
    region_step_ref(const S& how) noexcept : region_step_ref{&how, table<S>::of}
    {
    }
    region_step_ref(const void* how, const calls& does) noexcept : how_{how}, does_{&does} {}

    /// Whether it refers to no_step.
    [[nodiscard]] bool is_none() const noexcept { return does_->step == nullptr; }

    /// Needs a step.
    [[nodiscard]] result<stepped_region> operator()(const region& drawn, plan_scratch& scratch,
                                                    region_caps& caps) const noexcept
    {
        return does_->step(how_, drawn, scratch, caps);
    }
    /// See region_step.
    [[nodiscard]] error refused_options() const noexcept { return does_->refused_options(how_); }
    /// See policy_key.
    [[nodiscard]] policy_key key() const noexcept { return does_->key(how_); }

private:
    static constexpr no_step none{};

    const void* how_;
    const calls* does_;
};

template <class S>
    requires(region_step<S> || std::same_as<S, no_step>)
constinit const region_step_ref::calls region_step_ref::table<S>::of = [] {
    calls made{nullptr, [](const void*) noexcept { return error{}; },
               [](const void* how) noexcept { return key_of(*static_cast<const S*>(how)); }};
    if constexpr (region_step<S>) {
        made.step = [](const void* how, const region& drawn, plan_scratch& scratch,
                       region_caps& caps) noexcept -> result<stepped_region> {
            auto* fresh = scratch.fresh<typename S::scratch>();
            if (fresh == nullptr) return error::out_of_memory;
            return (*static_cast<const S*>(how))(drawn, *fresh, caps);
        };
        made.refused_options = [](const void* how) noexcept { return static_cast<const S*>(how)->refused_options(); };
    }
    return made;
}();

inline region_step_ref::region_step_ref() noexcept : region_step_ref{&none, table<no_step>::of} {}

}  // namespace typemesh::inline TYPEMESH_ABI
