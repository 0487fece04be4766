// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// 10 to a power, within a few units of the last place; 0 or infinity beyond the range of double.
[[nodiscard]] inline double power_of_ten(std::int32_t exponent) noexcept
{
    if (exponent > 310) exponent = 310;
    if (exponent < -330) exponent = -330;
    std::uint32_t left = static_cast<std::uint32_t>(exponent < 0 ? -exponent : exponent);
    double power = 1.0, square = 10.0;  // 10^(2^k) is exact up to 10^22
    for (; left != 0; left >>= 1, square *= square)
        if ((left & 1u) != 0) power *= square;
    return power;
}

/// Reads the numbers and flags of path data, one after the other. Nothing depends on the locale.
class path_numbers {
public:
    explicit path_numbers(std::string_view data) noexcept : data_{data} {}

    /// The number of bytes before the next one.
    [[nodiscard]] std::size_t place() const noexcept { return at_; }
    [[nodiscard]] bool at_end() const noexcept { return at_ == data_.size(); }
    /// The next byte; 0 at the end.
    [[nodiscard]] char next() const noexcept { return at_ < data_.size() ? data_[at_] : '\0'; }
    void step() noexcept { ++at_; }

    void skip_space() noexcept
    {
        while (is_space(next())) ++at_;
    }
    /// Skips what may stand between two numbers. Returns whether there was a comma.
    bool skip_comma() noexcept
    {
        skip_space();
        if (next() != ',') return false;
        ++at_;
        skip_space();
        return true;
    }

    /// Whether a number may begin here.
    [[nodiscard]] bool begins_number() const noexcept
    {
        const char c = next();
        return is_digit(c) || c == '.' || c == '-' || c == '+';
    }

    /// Reads a number: digits with at most one point among them, which need no digit before or after it; a sign
    /// before; an exponent behind. It ends before a second point, a sign or anything else, so that "1.5.5-2" are three
    /// numbers. False if there is none; the place is then where it breaks off.
    [[nodiscard]] bool read(double& value) noexcept
    {
        const bool negative = next() == '-';
        if (negative || next() == '+') ++at_;
        digits_ = 0;
        exponent_ = 0;
        std::size_t count = read_digits(0);
        if (next() == '.' && (count != 0 || is_digit(after()))) {
            ++at_;
            count += read_digits(-1);
        }
        if (count == 0) return false;
        if ((next() == 'e' || next() == 'E') && !read_exponent()) return false;
        const double whole = static_cast<double>(digits_);
        if (digits_ == 0)
            value = 0.0;
        else if (exponent_ >= 0)
            value = whole * power_of_ten(exponent_);
        else if (exponent_ >= -300)
            value = whole / power_of_ten(-exponent_);
        else
            value = whole / power_of_ten(300) / power_of_ten(-exponent_ - 300);
        if (negative) value = -value;
        return true;
    }

    /// Reads a flag, which is one digit and needs no separator behind it.
    [[nodiscard]] bool read_flag(bool& flag) noexcept
    {
        flag = next() == '1';
        if (!flag && next() != '0') return false;
        ++at_;
        return true;
    }

    [[nodiscard]] static constexpr bool is_space(char c) noexcept
    {
        return c == ' ' || c == '\t' || c == '\n' || c == '\f' || c == '\r';
    }
    [[nodiscard]] static constexpr bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

private:
    static constexpr std::int32_t farthest = 10'000;  // no exponent matters beyond it

    [[nodiscard]] char after() const noexcept { return at_ + 1 < data_.size() ? data_[at_ + 1] : '\0'; }

    /// Appends digits to the number; each changes the exponent by `each`. Digits beyond the nineteenth only count.
    std::size_t read_digits(std::int32_t each) noexcept
    {
        const std::size_t first = at_;
        for (; is_digit(next()); ++at_) {
            const bool fits = digits_ < 1'000'000'000'000'000'000u;
            if (fits) digits_ = digits_ * 10 + static_cast<std::uint64_t>(next() - '0');
            const std::int32_t change = fits ? each : each + 1;
            if (exponent_ < farthest && exponent_ > -farthest) exponent_ += change;
        }
        return at_ - first;
    }

    [[nodiscard]] bool read_exponent() noexcept
    {
        ++at_;
        const bool negative = next() == '-';
        if (negative || next() == '+') ++at_;
        if (!is_digit(next())) return false;
        std::int32_t own = 0;
        for (; is_digit(next()); ++at_)
            if (own < 2 * farthest) own = own * 10 + (next() - '0');
        exponent_ += negative ? -own : own;
        return true;
    }

    std::string_view data_;
    std::size_t at_ = 0;
    std::uint64_t digits_ = 0;
    std::int32_t exponent_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
