// SPDX-License-Identifier: MIT
#pragma once

#if !(defined(_MSVC_LANG) ? _MSVC_LANG >= 202002L : __cplusplus >= 202002L)
#error "typemesh needs C++20: give the compiler -std=c++20 (cl: /std:c++20)"
#endif

#define TYPEMESH_VERSION_MAJOR 0
#define TYPEMESH_VERSION_MINOR 1
#define TYPEMESH_VERSION_PATCH 0

/// The inline namespace around everything: typemesh::vec3 is typemesh::v0_1_0::vec3. The translation units of one
/// program may use different versions of the library, or different settings (with NDEBUG or without, with
/// typemesh::compiled or without). No unit then runs another unit's functions, and the linker refuses to pass objects
/// between these units.
#if defined(NDEBUG) && defined(TYPEMESH_COMPILED)
#define TYPEMESH_ABI v0_1_0_compiled
#elif defined(NDEBUG)
#define TYPEMESH_ABI v0_1_0
#elif defined(TYPEMESH_COMPILED)
#define TYPEMESH_ABI v0_1_0_checked_compiled
#else
#define TYPEMESH_ABI v0_1_0_checked
#endif
