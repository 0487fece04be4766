// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Numbers with a fixed number of digits after the point, as integers and as text.
class fixed_point {
public:
    /// `decimals`, 0 to 9: the number of digits after the point.
    constexpr explicit fixed_point(int decimals) noexcept : decimals_{decimals}
    {
        for (int i = 0; i < decimals; ++i) scale_ *= 10;
    }

    /// The nearest multiple of the last digit, as a number of last digits; halves are rounded up.
    ///
    /// Fails  error::outline_not_finite; error::too_large: it has more than 15 digits
    [[nodiscard]] error round(double value, std::int64_t& out) const noexcept
    {
        const double wanted = std::floor(value * static_cast<double>(scale_) + 0.5);
        if (!is_finite(wanted)) return error::outline_not_finite;
        if (!(std::fabs(wanted) < 1e15)) return error::too_large;
        out = static_cast<std::int64_t>(wanted);
        return {};
    }

    /// The text of a number of round(). With `all`, every digit after the point is written; otherwise zeros at its end
    /// are left out, and the point if nothing follows it. The next call overwrites the text.
    [[nodiscard]] std::string_view text(std::int64_t number, bool all) noexcept
    {
        char* const end = digits_ + sizeof digits_;
        char* first = end;
        const bool negative = number < 0;
        std::int64_t left = negative ? -number : number;
        bool shown = all;
        for (int i = 0; i < decimals_; ++i, left /= 10) {
            shown = shown || left % 10 != 0;
            if (shown) *--first = static_cast<char>('0' + left % 10);
        }
        if (shown && decimals_ > 0) *--first = '.';
        do *--first = static_cast<char>('0' + left % 10);
        while ((left /= 10) != 0);
        if (negative) *--first = '-';
        return {first, static_cast<std::size_t>(end - first)};
    }

private:
    int decimals_;
    std::int64_t scale_ = 1;
    char digits_[24] = {};
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
