// SPDX-License-Identifier: MIT

// Must not compile, each with a sentence: functions for a run that are not noexcept, or not behind the options.

#include "../support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

using namespace typemesh;

void edit(text_mesher<>& mesher, glyph_workers<one_worker, test::toy_font>& workers)
{
    (void)mesher.plan("o", {}, [](glyph_run& run) { run.glyphs[0].origin.y = 1.0; });
    (void)mesher.plan("o", {}, workers, [](glyph_run& run) { run.glyphs[0].origin.y = 1.0; });
    (void)mesher.plan("o", [](glyph_run& run) noexcept { run.glyphs[0].origin.y = 1.0; });
}
