// SPDX-License-Identifier: MIT
#pragma once
#include_next <d2d1.h>
struct __declspec(uuid("2cd9069e-12e2-11dc-9fed-001143a055f9")) ID2D1SimplifiedGeometrySink;
