// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <bit>
#include <cstdint>
#include <cstring>

namespace typemesh::inline TYPEMESH_ABI {

/// A policy's options as bits, which distinguish cached results: up to four numbers.
///
///     struct my_discretiser {
///         double distance;
///         int levels;
///         option_bits cache_key() const noexcept { return {distance, levels}; }
///
/// If two policies of one type can give distinct results, they must have distinct bits. Leave out options that do not
/// affect the cached result. A policy whose state does not fit may count its changes instead.
struct option_bits {
    std::uint64_t words[4] = {};

    constexpr option_bits() noexcept = default;

    template <class... Numbers>
        requires(sizeof...(Numbers) >= 1 && sizeof...(Numbers) <= 4)
    option_bits(Numbers... numbers) noexcept
    {
        std::uint64_t* next = words;
        (put(*next++, numbers), ...);
    }

    friend constexpr bool operator==(const option_bits& a, const option_bits& b) noexcept
    {
        return a.words[0] == b.words[0] && a.words[1] == b.words[1] && a.words[2] == b.words[2] &&
               a.words[3] == b.words[3];
    }

private:
    template <class Number>
    static void put(std::uint64_t& word, Number n) noexcept
    {
        static_assert(sizeof(Number) <= sizeof word, "an option of more than 64 bits");
        constexpr bool highest_first = std::endian::native == std::endian::big;  // numbers lie in the lowest bits
        std::memcpy(reinterpret_cast<unsigned char*>(&word) + (highest_first ? sizeof word - sizeof n : 0), &n,
                    sizeof n);
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
