// SPDX-License-Identifier: MIT
#include "well_formed.hpp"

#include <cstddef>

namespace text_to_mesh {
namespace {

/// The length of the well-formed UTF-8 sequence at the start of `s` (not empty), or 0.
std::size_t sequence_length(std::string_view s)
{
    const auto at = [&](std::size_t i) { return i < s.size() ? static_cast<unsigned char>(s[i]) : 0u; };
    const auto follows = [&](std::size_t i) { return (at(i) & 0xC0u) == 0x80u; };
    const unsigned lead = at(0);
    if (lead < 0x80u) return 1;
    if (lead >= 0xC2u && lead <= 0xDFu) return follows(1) ? 2 : 0;
    if (lead >= 0xE0u && lead <= 0xEFu) {
        if (!follows(1) || !follows(2)) return 0;
        if (lead == 0xE0u && at(1) < 0xA0u) return 0;  // longer than needed
        if (lead == 0xEDu && at(1) > 0x9Fu) return 0;  // a surrogate
        return 3;
    }
    if (lead >= 0xF0u && lead <= 0xF4u) {
        if (!follows(1) || !follows(2) || !follows(3)) return 0;
        if (lead == 0xF0u && at(1) < 0x90u) return 0;
        if (lead == 0xF4u && at(1) > 0x8Fu) return 0;
        return 4;
    }
    return 0;
}

}  // namespace

std::string well_formed(std::string_view s)
{
    std::string out;
    while (!s.empty()) {
        const std::size_t length = sequence_length(s);
        if (length == 0) out += "\xEF\xBF\xBD";
        else out.append(s.substr(0, length));
        s.remove_prefix(length == 0 ? 1 : length);
    }
    return out;
}

}  // namespace text_to_mesh
