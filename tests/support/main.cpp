// SPDX-License-Identifier: MIT

// Only for a Catch2 2.13 that brings no main() of its own.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
