// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace text_to_mesh {

/// The name with U+FFFD for what is not UTF-8, as decode() finds it (unicode/utf.hpp): JSON and XML hold Unicode only.
[[nodiscard]] std::string well_formed(std::string_view name);

}  // namespace text_to_mesh
