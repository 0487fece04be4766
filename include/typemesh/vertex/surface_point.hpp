// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/vertex/attribute.hpp>

#include <type_traits>

namespace typemesh {

/// Stands where an attribute was not asked for: using it is a compile error that carries this name.
template <attribute A>
struct not_in_wants {
};

/// One point of the mesh's surface, with the attributes in `Wants` and no others.
///
///     position   in the output's unit and frame (text_options)
///     normal     unit length, outward, in the same frame
///     uv         texture coordinates (see extrude/texture.hpp)
template <attribute Wants>
struct surface_point {
    template <attribute A, class T>
    using wanted = std::conditional_t<has(Wants, A), T, not_in_wants<A>>;

    [[no_unique_address]] wanted<attribute::position, vec3> position{};
    [[no_unique_address]] wanted<attribute::normal, vec3> normal{};
    [[no_unique_address]] wanted<attribute::uv, vec2> uv{};
};

/// The same point with fewer attributes; Fewer must be among those it has.
template <attribute Fewer, attribute Wants>
[[nodiscard]] constexpr surface_point<Fewer> only(const surface_point<Wants>& s) noexcept
{
    static_assert((Fewer | Wants) == Wants,
                  "typemesh: an attribute is asked for that this surface point does not have");
    surface_point<Fewer> fewer;
    if constexpr (has(Fewer, attribute::position)) fewer.position = s.position;
    if constexpr (has(Fewer, attribute::normal)) fewer.normal = s.normal;
    if constexpr (has(Fewer, attribute::uv)) fewer.uv = s.uv;
    return fewer;
}

}  // namespace typemesh
