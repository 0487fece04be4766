// SPDX-License-Identifier: MIT
#include "core_headers.hpp"

int version_seen_by_the_other_unit();

int version_seen_by_the_other_unit() { return TYPEMESH_VERSION_MAJOR * 100 + TYPEMESH_VERSION_MINOR; }
