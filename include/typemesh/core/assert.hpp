// SPDX-License-Identifier: MIT
#pragma once

/// Checks a precondition that the caller must meet: TYPEMESH_ASSERT(condition, "one sentence").
///
/// Assertions check only for mistakes of the calling program. Bad fonts and full buffers are reported as `error`.
///
/// To handle failures yourself, define this macro before the first include, and in the same way in all files of a
/// program. Your definition must evaluate the condition exactly once or not at all, because some conditions count what
/// they examine. By default it is assert(), which costs nothing with NDEBUG.
#ifndef TYPEMESH_ASSERT
#include <cassert>
#define TYPEMESH_ASSERT(condition, words) assert((condition) && (words))
#endif
