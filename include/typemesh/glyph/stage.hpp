// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <concepts>
#include <cstdint>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// The stages of a text, in order. `idle` follows when a call of the mesher ends.
enum class stage : std::uint8_t { shape, outline, discretise, fill, triangulate, extrude, idle };

/// A function object that is called at every change of stage, for profilers and statistics: observe(stage) noexcept. It
/// should be cheap, because it is called about six times per glyph.
///
/// A triangulator that proves (see triangulate/triangulator.hpp) does the work of fill on most glyphs. This work counts
/// as triangulate.
template <class O>
concept stage_observer = requires(O& observe, stage now) {
    { observe(now) } noexcept;
};

/// An observer that does nothing.
struct no_observer {
    constexpr void operator()(stage) const noexcept {}
};

/// Refers to an observer of any type, which must outlive it.
class observer_ref {
public:
    /// One table for each type of observer.
    struct calls {
        void (*observe)(void* observer, stage now) noexcept;
    };
    /// The table of O.
    template <stage_observer O>
    struct table {
        static const calls of;
    };

    template <stage_observer O>
        requires(!std::is_const_v<O> && !std::same_as<O, observer_ref>)
    observer_ref(O& observer) noexcept : observer_ref{&observer, table<O>::of}
    {
    }
    observer_ref(void* observer, const calls& does) noexcept : observer_{observer}, does_{&does} {}

    void operator()(stage now) const noexcept { does_->observe(observer_, now); }

private:
    void* observer_;
    const calls* does_;
};

template <stage_observer O>
constinit const observer_ref::calls observer_ref::table<O>::of = {
    [](void* observer, stage now) noexcept { (*static_cast<O*>(observer))(now); }};

}  // namespace typemesh::inline TYPEMESH_ABI
