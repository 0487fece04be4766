// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/vertex/vertex_traits.hpp>

#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// The parameter type of a call operator, and whether it is noexcept. If the operator is a template or takes any other
/// parameter, is_known is false.
template <class Call>
struct lambda_call {
    static constexpr bool is_known = false;
};
template <class F, class V, attribute Wants>
struct lambda_call<V (F::*)(const surface_point<Wants>&) const> {
    static constexpr bool is_known = true, is_noexcept = false;
    static constexpr attribute wants = Wants;
};
template <class F, class V, attribute Wants>
struct lambda_call<V (F::*)(const surface_point<Wants>&) const noexcept>
    : lambda_call<V (F::*)(const surface_point<Wants>&) const> {
    static constexpr bool is_noexcept = true;
};
template <class F, class V, attribute Wants>
struct lambda_call<V (F::*)(surface_point<Wants>) const> : lambda_call<V (F::*)(const surface_point<Wants>&) const> {};
template <class F, class V, attribute Wants>
struct lambda_call<V (F::*)(surface_point<Wants>) const noexcept>
    : lambda_call<V (F::*)(const surface_point<Wants>&) const noexcept> {};

/// Replaces a refused lambda.
template <class Vertex>
struct no_writer {
    static constexpr attribute wants = attribute::position;
    Vertex operator()(const surface_point<wants>&) const noexcept;
};

template <class F>
struct call_of : lambda_call<void> {};
template <class F>
    requires requires { &F::operator(); }
struct call_of<F> : lambda_call<decltype(&F::operator())> {};

}  // namespace detail

/// A function object that makes vertices but is no vertex_writer: a lambda. Errors in its form are reported when it is
/// used.
template <class F>
concept vertex_lambda = std::is_class_v<F> && !vertex_writer<F>;

/// A lambda as a vertex_writer: the lambda's parameter determines the attributes that the writer wants.
///
///     constexpr auto wants = attribute::position | attribute::normal;
///     into(vertices, indices, [&](const surface_point<wants>& s) noexcept { return vertex{s.position, s.normal}; })
template <class F>
class lambda_writer {
public:
    static constexpr attribute wants = detail::call_of<F>::wants;

    explicit lambda_writer(F make) noexcept : make_{std::move(make)} {}

    [[nodiscard]] auto operator()(const surface_point<wants>& s) const noexcept { return make_(s); }

private:
    F make_;
};

/// Makes the writer, or says in one sentence why the lambda is not suitable.
template <class Vertex, class F>
[[nodiscard]] auto writer_of(F make) noexcept
{
    constexpr bool is_known = detail::call_of<F>::is_known;
    static_assert(is_known,
                  "typemesh: a lambda that makes vertices must not be mutable and has one parameter, whose type "
                  "names all attributes that it uses: `[](const surface_point<wants>& s) noexcept { return "
                  "my_vertex{...}; }`, where `wants` is constexpr.");
    if constexpr (is_known) {
        static_assert(detail::call_of<F>::is_noexcept,
                      "typemesh: a lambda that makes vertices must be noexcept: "
                      "`[](const surface_point<wants>& s) noexcept { ... }`.");
        static_assert(std::is_convertible_v<decltype(lambda_writer<F>{std::move(make)}({})), Vertex>,
                      "typemesh: this lambda does not return the vertex type of the array.");
        return lambda_writer<F>{std::move(make)};
    } else {
        return detail::no_writer<Vertex>{};
    }
}

}  // namespace typemesh::inline TYPEMESH_ABI
