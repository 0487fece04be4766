// SPDX-License-Identifier: MIT
#include "compiled/text_hash.hpp"

#ifdef TYPEMESH_COMPILED
#error "this unit is to be compiled without typemesh::compiled"
#endif

test::text_hash test::hash_of_header_only_unit(const char* font, const char* text) { return hash_of(font, text); }
