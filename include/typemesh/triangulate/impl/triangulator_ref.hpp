// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/policy_key.hpp>
#include <typemesh/triangulate/cut_region.hpp>
#include <typemesh/triangulate/triangulator.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// Refers to a triangulator of any type, which must outlive it. One indirect call cuts a whole region.
class triangulator_ref {
public:
    /// There is one table for each type of triangulator.
    struct calls {
        using proof = result<region> (*)(const void* how, const contours& loops, workspace& space,
                                         triangle_list& out) noexcept;

        error (*cut)(const void* how, const region& r, workspace& space, triangle_list& out) noexcept;
        policy_key (*key)(const void* how) noexcept;
        proof prove = nullptr;           // null: it is no proving_triangulator
        proof prove_touching = nullptr;  // null: it is no touching_triangulator
        bool has_final_diagonals = false;
    };
    template <triangulator T>
    struct table {
        static const calls of;
    };

    template <triangulator T>
    triangulator_ref(const T& how) noexcept : triangulator_ref{&how, table<T>::of}
    {
    }
    triangulator_ref(const void* how, const calls& does) noexcept : how_{how}, does_{&does} {}

    /// Calls cut_region().
    [[nodiscard]] error cut(const region& r, workspace& space, triangle_list& out) const noexcept
    {
        return does_->cut(how_, r, space, out);
    }

    /// See proving_triangulator and touching_triangulator; low triangles have not been flipped yet.
    [[nodiscard]] bool proves() const noexcept { return does_->prove != nullptr; }
    [[nodiscard]] bool proves_touching() const noexcept { return does_->prove_touching != nullptr; }
    [[nodiscard]] result<region> prove(const contours& loops, workspace& space, triangle_list& out) const noexcept
    {
        return does_->prove(how_, loops, space, out);
    }
    [[nodiscard]] result<region> prove_touching(const contours& loops, workspace& space,
                                                triangle_list& out) const noexcept
    {
        return does_->prove_touching(how_, loops, space, out);
    }
    [[nodiscard]] bool has_final_diagonals() const noexcept { return does_->has_final_diagonals; }
    [[nodiscard]] policy_key key() const noexcept { return does_->key(how_); }

private:
    const void* how_;
    const calls* does_;
};

template <triangulator T>
constinit const triangulator_ref::calls triangulator_ref::table<T>::of = [] {
    calls made{[](const void* how, const region& r, workspace& space, triangle_list& out) noexcept {
                   return cut_region(r, *static_cast<const T*>(how), space, out).error();
               },
               [](const void* how) noexcept { return key_of(*static_cast<const T*>(how)); }};
    if constexpr (proving_triangulator<T>)
        made.prove = [](const void* how, const contours& loops, workspace& space, triangle_list& out) noexcept {
            return static_cast<const T*>(how)->prove(loops, space, out);
        };
    if constexpr (touching_triangulator<T>)
        made.prove_touching = [](const void* how, const contours& loops, workspace& space,
                                 triangle_list& out) noexcept {
            return static_cast<const T*>(how)->prove_touching(loops, space, out);
        };
    made.has_final_diagonals = typemesh::has_final_diagonals<T>;
    return made;
}();

}  // namespace typemesh::inline TYPEMESH_ABI
