// SPDX-License-Identifier: MIT
//
//     every_shape [FIRST] [COUNT]
//
// Makes bevels, bolder and hollow letters of random outlines that are hard for moved edges (support/random_outlines.hpp),
// 20,000 from the first, and prints what is wrong, narrowed or refused; the status is 0 if nothing is wrong.

#include "shape_laws.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv)
{
    const std::uint64_t first = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 0,
                        count = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 20'000;
    test::shape_findings all;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const test::shape_laws laws{seed};
        const test::shape_findings& f = laws.found();
        if (!f.wrong.empty()) std::printf("%llu: %s\n", static_cast<unsigned long long>(seed), f.wrong.c_str());
        all.add(f);
    }
    std::printf("%zu shapes, %zu solids, %zu narrowed, %zu of them to nothing, %zu refused\n", all.shapes, all.solids,
                all.narrowed, all.to_nothing, all.refused);
    return all.wrong.empty() ? 0 : 1;
}
