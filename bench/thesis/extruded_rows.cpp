// SPDX-License-Identifier: MIT

#include "cells.hpp"

void bench::add_extruded_rows(cell_rows& rows, protocol_font& f) { add_rows(rows, f, "extruded", extruded<>{}); }
