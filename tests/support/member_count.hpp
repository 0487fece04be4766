// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace test {

/// Becomes a value of any type, where only the type matters.
struct any_value {
    template <class T>
    operator T() const noexcept;  // NOLINT: implicit, never defined
};

/// How many members an aggregate has: as many values as it can be initialised with.
template <class T, class... Values>
constexpr std::size_t member_count(Values... values)
{
    if constexpr (requires { T{values..., any_value{}}; })
        return member_count<T>(values..., any_value{});
    else
        return sizeof...(values);
}

}  // namespace test
