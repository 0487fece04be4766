// SPDX-License-Identifier: MIT
#pragma once

namespace typemesh {

[[nodiscard]] constexpr double d3dx_tolerance(double deviation) noexcept
{
    return deviation / 4;
}

}  // namespace typemesh
