// SPDX-License-Identifier: MIT
#pragma once

#include "options.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace text_to_mesh {

/// A text of the command line, of a file or of one of its lines, and the files that it makes.
struct text_job {
    std::string text;
    std::string output, picture;
    std::size_t line = 0;  ///< of a batch, from 1; else 0
};

/// Reads a whole file, or standard input for "-", up to 64 MB: without a byte order mark, and "\r\n" becomes "\n".
/// Gives an empty string, or one sentence, with this advice if the file is larger.
[[nodiscard]] std::string read_file(const std::string& path, std::string& out, std::string_view advice = ": split it");

/// The name that a pattern has for a line of a batch.
///
///     {n}      the line's number, from 1, in as many digits as the last one's
///     {text}   its text, at most 100 bytes of it: _ stands for what names of files cannot hold on any system
[[nodiscard]] std::string file_name(std::string_view pattern, std::string_view text, std::size_t line,
                                    std::size_t last_line);

/// Why --output and --picture of a batch are refused, or an empty string.
[[nodiscard]] std::string refused_patterns(const options& o);

/// All texts. Of a file: a byte order mark at its beginning and the line break at its end are dropped, "\r\n" is a line
/// break; of a batch blank lines make nothing, and \n in a line starts a new line of its text. Gives an empty string, or
/// one sentence; two lines that would make the same file are refused.
[[nodiscard]] std::string read_texts(const options& o, std::vector<text_job>& out);

}  // namespace text_to_mesh
