// SPDX-License-Identifier: MIT
#include "core_headers.hpp"

int version_seen_by_the_other_unit();

int main() { return version_seen_by_the_other_unit() == TYPEMESH_VERSION_MAJOR * 100 + TYPEMESH_VERSION_MINOR ? 0 : 1; }
