// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Calls action(), which belongs to the caller or the standard library and may throw. Returns false if it has thrown,
/// which cannot happen in builds without exceptions. Microsoft's compilers have their own macro for exceptions.
template <class Action>
[[nodiscard]] bool attempt(Action&& action) noexcept
{
#if defined(__cpp_exceptions) || defined(_CPPUNWIND)
    try {
        action();
    } catch (...) {
        return false;
    }
#else
    action();
#endif
    return true;
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
