// SPDX-License-Identifier: MIT
//
// mingw-w64's headers, read by clang as Microsoft's compiler: what they call differently there.
#pragma once
#include_next <_mingw.h>
#undef __MINGW_IMPORT
#define __MINGW_IMPORT extern __declspec(dllimport)
