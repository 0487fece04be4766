// SPDX-License-Identifier: MIT
#pragma once

/// States what the caller owes, with words: TYPEMESH_ASSERT(condition, "one sentence").
///
/// Whatever stands in its place evaluates a condition exactly once, or not at all: some count what they look at.
///
/// Only mistakes of the calling program are asserted; bad fonts and full buffers come back as `error`.
/// Define it before the first include, and alike in all files of a program, to send failures elsewhere. Undefined, it
/// is assert(): with NDEBUG it costs nothing.
#ifndef TYPEMESH_ASSERT
#include <cassert>
#define TYPEMESH_ASSERT(condition, words) assert((condition) && (words))
#endif
