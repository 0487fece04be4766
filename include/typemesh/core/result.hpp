// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/error.hpp>

#include <optional>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// A value, or the error that prevented it.
///
///     if (auto made = f()) use(*made); else puts(made.error().message());
template <class T>
class [[nodiscard]] result {
public:
    result(T value) noexcept : value_{std::move(value)} {}
    result(typemesh::error e) noexcept : error_{e}
    {
        TYPEMESH_ASSERT(e, "a result without a value must carry an error");
    }
    result(typemesh::error::kind k) noexcept : result{typemesh::error{k}} {}

    [[nodiscard]] explicit operator bool() const noexcept { return value_.has_value(); }

    [[nodiscard]] T& operator*() & noexcept { return *checked(); }
    [[nodiscard]] const T& operator*() const& noexcept { return *const_cast<result*>(this)->checked(); }
    [[nodiscard]] T&& operator*() && noexcept { return std::move(*checked()); }
    [[nodiscard]] T* operator->() noexcept { return checked(); }
    [[nodiscard]] const T* operator->() const noexcept { return const_cast<result*>(this)->checked(); }

    /// What went wrong; error::none when there is a value.
    [[nodiscard]] typemesh::error error() const noexcept { return error_; }

private:
    T* checked() noexcept
    {
        TYPEMESH_ASSERT(value_.has_value(), "the value of a failed result was used; test it with `if` first");
        return &*value_;
    }

    std::optional<T> value_;
    typemesh::error error_;
};

/// For overloads beside those that take a value, so that a forgotten `*` is reported in one sentence.
template <class T>
constexpr error refuse_result() noexcept
{
    static_assert(sizeof(T) == 0,
                  "typemesh: this is a typemesh::result, not its value. Test it first, "
                  "`if (!made) ... made.error()`, then pass the value: `*made`.");
    return error::bad_option;
}

/// Likewise for functions that take several values: the value itself, or that sentence for a result.
template <class T>
T& refuse_result(T& value) noexcept
{
    return value;
}
/// The refusal: it does not compile.
template <class T>
T& refuse_result(result<T>& made) noexcept
{
    (void)refuse_result<T>();
    return *made;
}

/// Whether T is a result.
template <class T>
inline constexpr bool is_result = false;
template <class T>
inline constexpr bool is_result<result<T>> = true;

}  // namespace typemesh::inline TYPEMESH_ABI
