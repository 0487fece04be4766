// SPDX-License-Identifier: MIT
#pragma once

#define TYPEMESH_VERSION_MAJOR 0
#define TYPEMESH_VERSION_MINOR 1
#define TYPEMESH_VERSION_PATCH 0
