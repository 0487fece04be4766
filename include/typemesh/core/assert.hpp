// SPDX-License-Identifier: MIT
#pragma once

/// Checks what the caller must guarantee: TYPEMESH_ASSERT(condition, "one sentence").
///
/// Only mistakes of the calling program are asserted; bad fonts and full buffers come back as `error`.
///
/// Define it before the first include, alike in all files of a program, to handle failures yourself. Your definition
/// must evaluate the condition exactly once or not at all: some conditions count what they examine. By default it is
/// assert(), which costs nothing with NDEBUG.
#ifndef TYPEMESH_ASSERT
#include <cassert>
#define TYPEMESH_ASSERT(condition, words) assert((condition) && (words))
#endif
