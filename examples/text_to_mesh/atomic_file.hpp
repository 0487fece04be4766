// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace text_to_mesh {

/// What names standard output instead of a file; a file of that name is "./-".
inline constexpr const char* standard_output = "-";

/// Makes `path` hold exactly `bytes`, or leaves it as it was.
///
///     a new or ordinary file   written as a temporary beside it, then renamed over it; permissions and symbolic links
///                              stay
///     a device or a pipe       written straight away (there is nothing to keep); so is standard output, once
///     a directory, a file that may not be written    refused
///
/// Gives  an empty string, or one sentence for the user: "hello.glb cannot be written: No space left on device."
///        No temporary is left behind in either case, nor by SIGINT, SIGTERM and SIGHUP: see part_file.
[[nodiscard]] std::string write_atomically(const std::string& path, std::span<const unsigned char> bytes);

class pending_file;

/// Files that belong together: all take their places, or none does.
///
///     file_set files;
///     files.add(...), files.add(...)    each is complete beside its place, or refused
///     files.finish()                    all take their places: devices first, for they alone can be full; then in the
///                                       order of add(), so the file that names the others comes last
///
/// What was not finished is removed by the destructor.
class file_set {
public:
    file_set();
    ~file_set();
    file_set(const file_set&) = delete;
    file_set& operator=(const file_set&) = delete;

    /// Both give what write_atomically() gives.
    [[nodiscard]] std::string add(const std::string& path, std::span<const unsigned char> bytes);
    [[nodiscard]] std::string finish();

private:
    std::vector<std::unique_ptr<pending_file>> pending_;
};

}  // namespace text_to_mesh
