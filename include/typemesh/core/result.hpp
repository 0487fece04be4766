// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/error.hpp>

#include <concepts>
#include <new>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// A value, or the error that prevented it. Its members have the names of C++23's std::expected.
///
///     if (auto made = f()) use(*made); else puts(made.error().message());
///     auto mesh = open(file).and_then([](font& f) noexcept { return f.outline(glyph); });
///
/// Using the value of a failed result is the caller's mistake, and an assertion fails. A result whose value has been
/// moved out still counts as having a value.
template <class T>
class [[nodiscard]] result {
public:
    using value_type = T;
    using error_type = typemesh::error;  ///< the error, as a type

    result(T value) noexcept : value_{std::move(value)}, has_value_{true} {}
    result(typemesh::error e) noexcept : nothing_{}, error_{e}
    {
        TYPEMESH_ASSERT(e, "a result without a value must have an error");
    }
    result(typemesh::error::kind k) noexcept : result{typemesh::error{k}} {}

    result(result&& other) noexcept : nothing_{}, error_{other.error_} { take(std::move(other)); }
    result(const result& other) noexcept
        requires requires(const T& t) { T(t); }
        : nothing_{}, error_{other.error_}
    {
        take(other);
    }
    result& operator=(result&& other) noexcept
    {
        if (this != &other) drop(), error_ = other.error_, take(std::move(other));
        return *this;
    }
    result& operator=(const result& other) noexcept
        requires requires(const T& t) { T(t); }
    {
        if (this != &other) drop(), error_ = other.error_, take(other);
        return *this;
    }
    ~result() { drop(); }

    /// Whether there is a value. If not, error() is the reason.
    [[nodiscard]] bool has_value() const noexcept { return has_value_; }
    [[nodiscard]] explicit operator bool() const noexcept { return has_value_; }

    [[nodiscard]] T& value() & noexcept { return *checked(); }
    [[nodiscard]] const T& value() const& noexcept { return *checked(); }
    [[nodiscard]] T&& value() && noexcept { return std::move(*checked()); }
    [[nodiscard]] T& operator*() & noexcept { return *checked(); }
    [[nodiscard]] const T& operator*() const& noexcept { return *checked(); }
    [[nodiscard]] T&& operator*() && noexcept { return std::move(*checked()); }
    [[nodiscard]] T* operator->() noexcept { return checked(); }
    [[nodiscard]] const T* operator->() const noexcept { return checked(); }

    /// What went wrong; error::none if there is a value.
    [[nodiscard]] typemesh::error error() const noexcept { return error_; }

    /// Returns the result of `next(value)`, or this error.
    template <class Next>
    [[nodiscard]] auto and_then(Next&& next) & noexcept -> std::remove_cvref_t<decltype(next(std::declval<T&>()))>
    {
        if (!has_value_) return error_;
        return next(value_);
    }
    template <class Next>
    [[nodiscard]] auto and_then(Next&& next) && noexcept -> std::remove_cvref_t<decltype(next(std::declval<T>()))>
    {
        if (!has_value_) return error_;
        return next(std::move(value_));
    }

private:
    T* checked() noexcept
    {
        TYPEMESH_ASSERT(has_value_, "the value of a failed result was used; test it with `if` first");
        return &value_;
    }
    const T* checked() const noexcept { return const_cast<result*>(this)->checked(); }

    template <class Other>
    void take(Other&& other) noexcept
    {
        if (!other.has_value_) return;
        ::new (static_cast<void*>(&value_)) T(std::forward<Other>(other).value_);
        has_value_ = true;
    }
    void drop() noexcept
    {
        if (has_value_) value_.~T();
        has_value_ = false;
    }

    union {
        T value_;
        char nothing_;  ///< the active member if there is no value
    };
    bool has_value_ = false;
    typemesh::error error_;
};

/// Success, or the error that prevented it. Calls without a value to return use it.
///
///     if (auto written = plan->write(sink); !written) puts(written.error().message());
///
/// A result is true on success. These calls once returned an error, which was true on failure. Code written for an
/// error must not compile, so an unnamed result<void> does not convert to bool: write `if (!plan->write(sink))`, or
/// call has_value().
template <>
class [[nodiscard]] result<void> {
public:
    using value_type = void;
    using error_type = typemesh::error;

    constexpr result() noexcept = default;                       ///< success
    constexpr result(typemesh::error e) noexcept : error_{e} {}  ///< a failure, or success for error::none
    constexpr result(typemesh::error::kind k) noexcept : error_{k} {}

    [[nodiscard]] constexpr bool has_value() const noexcept { return error_.code == typemesh::error::none; }
    [[nodiscard]] explicit constexpr operator bool() const& noexcept { return has_value(); }
    [[nodiscard]] constexpr bool operator!() const noexcept { return !has_value(); }
    explicit operator bool() const&& = delete;

    /// What went wrong; error::none on success.
    [[nodiscard]] constexpr typemesh::error error() const noexcept { return error_; }
    friend constexpr bool operator==(const result& r, typemesh::error::kind k) noexcept { return r.error_ == k; }

    /// Returns the result of `next()`, or this error.
    template <class Next>
    [[nodiscard]] auto and_then(Next&& next) const noexcept -> std::remove_cvref_t<decltype(next())>
    {
        if (!has_value()) return error_;
        return next();
    }

private:
    typemesh::error error_;
};

/// Makes the compiler report a forgotten `*` in one sentence. It is for overloads that take a result where a value is
/// needed.
template <class T>
constexpr error refuse_result() noexcept
{
    static_assert(sizeof(T) == 0,
                  "typemesh: this is a typemesh::result, not its value. Test it first, "
                  "`if (!made) ... made.error()`, then pass the value: `*made`.");
    return error::bad_option;
}

/// For functions with several arguments, which may be values or results. A value is returned as it is.
template <class T>
T& refuse_result(T& value) noexcept
{
    return value;
}
/// A result does not compile, and the compiler shows the sentence above.
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
