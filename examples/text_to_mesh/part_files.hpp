// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <filesystem>
#include <system_error>

namespace text_to_mesh {

/// A temporary file that no signal leaves behind: from the first open() on SIGINT, SIGTERM and SIGHUP remove those there
/// are before they end the program, unless they were ignored when it began. Up to 16 at a time; on Windows none.
class part_file {
public:
    part_file() = default;
    part_file(const part_file&) = delete;
    part_file& operator=(const part_file&) = delete;
    ~part_file() { discard(); }

    /// Opens a new file of a name that nobody uses yet, in a folder. Null, with errno, if there can be none.
    [[nodiscard]] std::FILE* open(const std::filesystem::path& folder);

    /// Empty before open() and after the file has gone.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Gives the file another name: it takes the place of what is there.
    [[nodiscard]] std::error_code move_to(const std::filesystem::path& target);

    void discard();

private:
    std::filesystem::path path_;
    int slot_ = -1;
};

}  // namespace text_to_mesh
