// SPDX-License-Identifier: MIT
#include "srgb.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace text_to_mesh {
namespace {

const std::array<double, 256>& linear_table()
{
    static const std::array<double, 256> table = [] {
        std::array<double, 256> t{};
        for (std::size_t i = 0; i < 256; ++i) {
            const double s = double(i) / 255.0;
            t[i] = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
        }
        return t;
    }();
    return table;
}

}  // namespace

vec3 to_linear(const unsigned char (&rgb)[3])
{
    const auto& table = linear_table();
    return {table[rgb[0]], table[rgb[1]], table[rgb[2]]};
}

unsigned char to_srgb(double value)
{
    static const std::array<unsigned char, 4097> coarse = [] {
        std::array<unsigned char, 4097> t{};
        for (std::size_t i = 0; i < t.size(); ++i) {
            const double v = double(i) / 4096.0;
            t[i] = static_cast<unsigned char>(255.0 *
                                              (v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055));
        }
        return t;
    }();
    // The table rounds down; the last step is decided in linear light, halfway between two neighbours' codes.
    const auto& linear = linear_table();
    const double v = clamp01(value);
    std::size_t code = coarse[static_cast<std::size_t>(v * 4096.0)];
    while (code < 255 && v > 0.5 * (linear[code] + linear[code + 1])) ++code;
    return static_cast<unsigned char>(code);
}

}  // namespace text_to_mesh
