// SPDX-License-Identifier: MIT
#pragma once

// One spelling for Catch2 2.13 and 3: `Approx` and `Catch::Approx` are there with both.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
namespace Catch {
using Catch::Detail::Approx;
}
#endif

/// CHECK for inner loops: only a failure costs time.
#define CHECK_QUICKLY(...)                            \
    do {                                              \
        if (!(__VA_ARGS__)) FAIL_CHECK(#__VA_ARGS__); \
    } while (false)
