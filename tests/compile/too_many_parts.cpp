// SPDX-License-Identifier: MIT

// Must not compile: a ring and a letter that have ten parts together.

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/outlined.hpp>

using namespace typemesh;

const outlined<bevelled, bevelled> both{.width = 0.02f};
