// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace test {

/// Converts to a value of any type, where only the type matters.
struct any_value {
    template <class T>
    operator T() const noexcept;  // NOLINT: implicit, never defined
};

/// The number of members of an aggregate: the largest number of initial values.
template <class T, class... Values>
constexpr std::size_t member_count(Values... values)
{
    if constexpr (requires { T{values..., any_value{}}; })
        return member_count<T>(values..., any_value{});
    else
        return sizeof...(values);
}

}  // namespace test
