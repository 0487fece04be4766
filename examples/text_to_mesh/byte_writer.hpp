// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace text_to_mesh {

/// Collects a file in memory: little-endian numbers whatever the machine, texts whatever the locale.
class byte_writer {
public:
    void reserve(std::size_t bytes) { bytes_.reserve(bytes); }

    void text(std::string_view s) { bytes_.insert(bytes_.end(), s.begin(), s.end()); }

    /// The shortest decimal text that reads back as the same float.
    void decimal(float value)
    {
        char digits[32];
        text({digits, std::to_chars(digits, digits + sizeof digits, value).ptr});
    }

    void u8(unsigned value) { bytes_.push_back(static_cast<unsigned char>(value & 0xFFu)); }

    void u16(std::uint32_t value)
    {
        const unsigned char low_first[] = {static_cast<unsigned char>(value & 0xFFu),
                                           static_cast<unsigned char>(value >> 8 & 0xFFu)};
        bytes_.insert(bytes_.end(), low_first, low_first + sizeof low_first);
    }

    void u32(std::uint32_t value)
    {
        const unsigned char low_first[] = {
            static_cast<unsigned char>(value & 0xFFu), static_cast<unsigned char>(value >> 8 & 0xFFu),
            static_cast<unsigned char>(value >> 16 & 0xFFu), static_cast<unsigned char>(value >> 24)};
        bytes_.insert(bytes_.end(), low_first, low_first + sizeof low_first);
    }

    void f32(float value)
    {
        std::uint32_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        u32(bits);
    }

    [[nodiscard]] const std::vector<unsigned char>& bytes() const { return bytes_; }
    [[nodiscard]] std::vector<unsigned char> take() { return std::move(bytes_); }

private:
    std::vector<unsigned char> bytes_;
};

/// The name on one line: a line break or any other control character becomes a space.
inline std::string one_line(std::string_view name)
{
    std::string line{name};
    for (char& c : line)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    return line;
}

}  // namespace text_to_mesh
