// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A table of a font, whose numbers are big-endian. Bytes beyond its end are 0, and note that they were missing.
class table_bytes {
public:
    table_bytes() noexcept = default;
    explicit table_bytes(array_view<const std::byte> bytes) noexcept : bytes_{bytes} {}

    [[nodiscard]] std::size_t size() const noexcept { return bytes_.size(); }

    /// Whether something was read beyond the end.
    [[nodiscard]] bool is_short() const noexcept { return short_; }

    [[nodiscard]] std::uint32_t u8(std::size_t at) const noexcept
    {
        if (at < bytes_.size()) return std::to_integer<std::uint32_t>(bytes_[at]);
        short_ = true;
        return 0;
    }
    [[nodiscard]] std::uint32_t u16(std::size_t at) const noexcept { return u8(at) << 8 | u8(at + 1); }
    [[nodiscard]] std::uint32_t u24(std::size_t at) const noexcept { return u16(at) << 8 | u8(at + 2); }
    [[nodiscard]] std::uint32_t u32(std::size_t at) const noexcept { return u16(at) << 16 | u16(at + 2); }
    [[nodiscard]] std::int32_t i8(std::size_t at) const noexcept { return static_cast<std::int8_t>(u8(at)); }
    [[nodiscard]] std::int32_t i16(std::size_t at) const noexcept { return static_cast<std::int16_t>(u16(at)); }
    [[nodiscard]] std::int32_t i32(std::size_t at) const noexcept { return static_cast<std::int32_t>(u32(at)); }

    /// The index of the record with this 16-bit key at its start, among `count` records in ascending order; `count` if
    /// there is none.
    [[nodiscard]] std::size_t find(std::size_t first, std::size_t count, std::size_t stride,
                                   std::uint32_t key) const noexcept
    {
        std::size_t low = 0, high = count;
        while (low < high) {
            const std::size_t middle = low + (high - low) / 2;
            const std::uint32_t found = u16(first + middle * stride);
            if (found == key) return middle;
            if (found < key)
                low = middle + 1;
            else
                high = middle;
        }
        return count;
    }

private:
    array_view<const std::byte> bytes_;
    mutable bool short_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
