// SPDX-License-Identifier: MIT
#pragma once

// A Type 1 Multiple Master font of two axes, made here: no free one is installed anywhere.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace test {

/// As Type 1 fonts are written (Adobe Type 1 Font Format, 7.1).
inline std::string encrypted(std::string_view plain, std::uint16_t key)
{
    std::string out;
    for (const char c : plain) {
        const auto code = static_cast<std::uint8_t>(static_cast<std::uint8_t>(c) ^ (key >> 8));
        out += static_cast<char>(code);
        key = static_cast<std::uint16_t>((code + key) * 52845u + 22719u);
    }
    return out;
}

/// The glyph A is a box, 700 units high and 100 units wide in the light narrow master, 400 in the bold narrow, 600 in
/// the light wide and 1100 in the bold wide one; the axes are: "Weight" from 200 to 800, "Width" from 50 to 150.
/// `vector` holds the weights of the four masters (light narrow, bold narrow, light wide, bold wide) with which the
/// font is opened.
inline std::vector<std::byte> type1_mm_font(std::string_view vector)
{
    const auto number = [](int v) {
        std::string s;
        if (v >= -107 && v <= 107) return s += static_cast<char>(v + 139), s;
        s += static_cast<char>(255);
        for (int shift = 24; shift >= 0; shift -= 8) s += static_cast<char>(static_cast<unsigned>(v) >> shift & 0xFFu);
        return s;
    };
    const auto charstring = [&](const std::string& code) { return encrypted("0000" + code, 4330); };
    const std::string hsbw = number(0) + number(900) + "\x0D";
    const std::string blended = number(100) + number(300) + number(500) + number(1000) + number(4) + number(14) +
                                std::string{"\x0C\x10\x0C\x11", 4};  // callothersubr, pop
    const std::string box = hsbw + number(0) + number(0) + "\x15" + blended + "\x06" + number(700) + "\x07\x09\x0E";
    const std::string notdef = charstring(hsbw + "\x0E"), a = charstring(box);
    const std::string secret =
        "0000dup /Private 8 dict dup begin\n/RD {string currentfile exch readstring pop} executeonly def\n"
        "/ND {def} executeonly def\n/NP {put} executeonly def\n/BlueValues [] def\n/MinFeature {16 16} def\n"
        "/password 5839 def\n2 index /CharStrings 2 dict dup begin\n/.notdef " +
        std::to_string(notdef.size()) + " RD " + notdef + " ND\n/A " + std::to_string(a.size()) + " RD " + a +
        " ND\nend\nend\nreadonly put\nnoaccess put\ndup /FontName get exch definefont pop\nmark currentfile "
        "closefile\n";
    std::string file =
        "%!PS-AdobeFont-1.0: ToyMM 001.000\n12 dict begin\n/FontInfo 8 dict dup begin\n"
        "/BlendDesignPositions [[0 0][1 0][0 1][1 1]] def\n"
        "/BlendDesignMap [[[200 0][800 1]][[50 0][150 1]]] def\n/BlendAxisTypes [/Weight /Width] def\nend readonly "
        "def\n"
        "/FontName /ToyMM def\n/PaintType 0 def\n/FontType 1 def\n/FontMatrix [0.001 0 0 0.001 0 0] readonly def\n"
        "/Encoding 256 array\n0 1 255 {1 index exch /.notdef put} for\ndup 65 /A put\nreadonly def\n"
        "/FontBBox {0 0 1000 1000} readonly def\n/WeightVector [" +
        std::string{vector} +
        "] def\n/Blend 3 dict dup begin\n/FontBBox [{0 0 0 0}{0 0 0 0}{1000 1000 1000 1000}{1000 1000 1000 1000}] def\n"
        "/Private 14 dict def\nend def\ncurrentdict end\ncurrentfile eexec\n" +
        encrypted(secret, 55665) + "\n";
    for (int line = 0; line < 8; ++line) file.append(64, '0').append("\n");
    file += "cleartomark\n";
    const auto* bytes = reinterpret_cast<const std::byte*>(file.data());
    return {bytes, bytes + file.size()};
}

}  // namespace test
