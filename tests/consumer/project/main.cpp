// SPDX-License-Identifier: MIT
#include <typemesh/typemesh.hpp>

#ifdef USER_HAS_harfbuzz
#include <typemesh/adapt/harfbuzz.hpp>
#endif
#ifdef USER_HAS_freetype
#include <typemesh/adapt/freetype.hpp>
#endif
#ifdef USER_HAS_directwrite
#include <typemesh/adapt/directwrite.hpp>
#endif
#ifdef USER_HAS_fontconfig
#include <typemesh/adapt/fontconfig.hpp>
#endif
#ifdef USER_HAS_glm
#include <typemesh/adapt/glm.hpp>
#endif
#ifdef USER_HAS_threads
#include <typemesh/adapt/threads.hpp>
#endif
#ifdef USER_HAS_compiled
#include "vertex_count.hpp"
#ifndef TYPEMESH_COMPILED
#error "typemesh::compiled did not define TYPEMESH_COMPILED"
#endif
#endif

int main()
{
#ifdef USER_HAS_compiled
    if (vertex_count("Hello world!") != vertex_count_of_other_part("Hello world!")) return 1;
#endif
#ifdef USER_HAS_harfbuzz
    if (!hb_version_atleast(4, 0, 0)) return 1;
#endif
#ifdef USER_HAS_freetype
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0) return 1;
    FT_Done_FreeType(library);
#endif
#ifdef USER_HAS_directwrite
    if (typemesh::directwrite_font::open(L"no such file")) return 1;
#endif
#ifdef USER_HAS_fontconfig
    typemesh::installed_font found;
    if (typemesh::fontconfig_fonts::open()->find("no such family", found) != typemesh::error::no_such_family) return 1;
#endif
#ifdef USER_HAS_glm
    if (glm::vec2(1.0f).x != 1.0f) return 1;
#endif
#ifdef USER_HAS_threads
    bool done[8] = {};
    typemesh::thread_pool{2}.run(8, [&done](std::size_t i, std::size_t) noexcept { done[i] = true; });
    for (const bool d : done)
        if (!d) return 1;
#endif
    return 0;
}
