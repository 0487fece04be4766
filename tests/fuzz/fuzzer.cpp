// SPDX-License-Identifier: MIT
//
// A libFuzzer target of one function: run.sh names it by TYPEMESH_FUZZ_TARGET and includes its header first.

#include "values.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    const fuzz::broken_law broken = fuzz::TYPEMESH_FUZZ_TARGET(fuzz::values{{bytes, size}});
    if (broken.empty()) return 0;
    std::fprintf(stderr, "BROKEN LAW: %s\n", broken.c_str());
    std::abort();
}
