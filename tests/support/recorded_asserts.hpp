// SPDX-License-Identifier: MIT
#pragma once

// Include first, in every file of a program: failed asserts are written down instead of ending it.
#include <string>
#include <vector>

namespace test {
inline std::vector<std::string> failed_asserts;
}

#define TYPEMESH_ASSERT(condition, words) ((condition) ? (void)0 : test::failed_asserts.push_back(words))
