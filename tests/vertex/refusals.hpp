// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>

#include <cstdint>

#include "support/catch.hpp"

namespace test {

/// A sink refuses with this error, which counts what is missing.
inline void check_refused(const typemesh::error& e, typemesh::error::kind expected, std::uint64_t count)
{
    CHECK(e == expected);
    CHECK(e.count == count);
}

}  // namespace test
