// SPDX-License-Identifier: MIT
#pragma once

#include "text_to_mesh/atomic_file.hpp"

#include <string>

/// Calls `write(what..., files)` and puts in place what it has prepared. Gives an empty string, or one sentence.
template <class Write, class... What>
std::string written_alone(Write write, const What&... what)
{
    text_to_mesh::file_set files;
    std::string trouble = write(what..., files);
    return trouble.empty() ? files.finish() : trouble;
}
