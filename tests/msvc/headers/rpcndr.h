// SPDX-License-Identifier: MIT
//
// Interfaces get their GUIDs as in Microsoft's headers, for __uuidof.
#pragma once
#include_next <rpcndr.h>
#undef MIDL_INTERFACE
#define MIDL_INTERFACE(x) struct __declspec(uuid(x))
