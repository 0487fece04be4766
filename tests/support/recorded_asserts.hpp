// SPDX-License-Identifier: MIT
#pragma once

// Include it first, in every file of a program: failed asserts are recorded and do not end the program.
#include <string>
#include <vector>

namespace test {
inline std::vector<std::string> failed_asserts;
}

#define TYPEMESH_ASSERT(condition, words) ((condition) ? (void)0 : test::failed_asserts.push_back(words))
