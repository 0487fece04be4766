// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace text_to_mesh {

/// Makes `path` hold exactly `bytes`, or leaves it as it was.
///
///     a new or ordinary file   written as a temporary beside it, then renamed over it; permissions and symbolic links
///                              stay
///     a device or a pipe       written straight away (there is nothing to keep)
///     a directory, a file that may not be written    refused
///
/// Gives  an empty string, or one sentence for the user: "hello.glb cannot be written: No space left on device."
///        No temporary is left behind in either case.
[[nodiscard]] std::string write_atomically(const std::string& path, std::span<const unsigned char> bytes);

/// One of several files that belong together.
struct file_to_write {
    std::string path;
    std::span<const unsigned char> bytes;
};

/// The same for several: none is renamed before all are there. Written in their order, so the file that names the
/// others comes last.
[[nodiscard]] std::string write_atomically(std::span<const file_to_write> files);

}  // namespace text_to_mesh
