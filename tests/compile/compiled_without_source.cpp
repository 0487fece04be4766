// SPDX-License-Identifier: MIT

// Must not link: with TYPEMESH_COMPILED the default mesher is not made here, and no typemesh/compiled/harfbuzz.cpp is there.

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

int main()
{
    auto font = typemesh::harfbuzz_font::open("");
    if (!font) return 1;
    typemesh::text_mesher mesher{*font};
    return mesher.plan("") ? 0 : 1;
}
