// SPDX-License-Identifier: MIT

// Words that windows.h, X.h, AssertMacros.h, Qt and engines define as macros, in the way of every header of the core. The
// standard headers come first: they need not bear these words (and some undefine min and max).
#include "standard_headers.hpp"

#include "x11_macros.hpp"

#define min(a, b) refused_macro
#define max(a, b) refused_macro
#define check(expression) refused_macro
#define verify(expression) refused_macro
#define TEXT(quote) refused_macro
#define near
#define far
#define small char
#define emit
#define slots
#define signals public
#define foreach refused_macro
#define forever for (;;)

#include "core_headers.hpp"
