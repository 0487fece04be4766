// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Calls action(), which is the caller's or the standard library's and may throw. Returns false if it has thrown; in
/// builds without exceptions it cannot. Microsoft's compilers name exceptions by a macro of their own.
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
