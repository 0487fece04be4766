// SPDX-License-Identifier: MIT

#include "cells.hpp"

void bench::add_bevelled_rows(cell_rows& rows, protocol_font& f) { add_rows(rows, f, "bevelled", bevelled{}); }
