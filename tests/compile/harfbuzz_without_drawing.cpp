// SPDX-License-Identifier: MIT

// Must not compile: a project that builds HarfBuzz with HB_TINY, which leaves out outlines.

#define HB_TINY

#include <typemesh/adapt/harfbuzz.hpp>
