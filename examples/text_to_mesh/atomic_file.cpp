// SPDX-License-Identifier: MIT
#include "atomic_file.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <system_error>

namespace text_to_mesh {
namespace {

namespace fs = std::filesystem;

std::string sentence(const std::string& path, const char* what, const std::error_code& why)
{
    return path + " " + what + ": " + (why ? why.message() : "input/output error") + ".";
}

std::error_code last_error() { return {errno, std::generic_category()}; }

/// Writes and closes; disk quotas and network file systems may report only at the flush or the close.
std::error_code write_and_close(std::FILE* file, std::span<const unsigned char> bytes)
{
    std::error_code why;
    errno = 0;
    const std::size_t written =
        bytes.empty() ? 0 : std::fwrite(bytes.data(), 1, bytes.size(), file);  // null for no bytes
    if (written != bytes.size() || std::fflush(file) != 0) why = last_error();
    const bool failed = bool(why) || std::ferror(file) != 0;
    if (std::fclose(file) != 0 && !why) why = last_error();
    if (failed && !why) why = std::make_error_code(std::errc::io_error);
    return why;
}

/// Opens a file of a name that nobody uses yet. The name does not grow with the target's, which may be as long as is
/// allowed.
std::FILE* open_beside(const fs::path& target, fs::path& temporary)
{
    const auto start = std::chrono::steady_clock::now().time_since_epoch().count();
    for (int attempt = 0; attempt < 100; ++attempt) {
        temporary = target.parent_path() / (".text_to_mesh-" + std::to_string(start + attempt) + ".part");
        errno = 0;
        if (std::FILE* file = std::fopen(temporary.string().c_str(), "wbx")) return file;
        if (errno != EEXIST) break;
    }
    return nullptr;
}

}  // namespace

std::string write_atomically(const std::string& path, std::span<const unsigned char> bytes)
{
#ifdef SIGXFSZ
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is to be an error to report, not the end of the program
#endif
    if (path.empty()) return "The name of the output file is empty.";

    // Where the path is a symbolic link, the file it leads to is made or replaced, not the link.
    std::error_code ignored;
    fs::path target = path;
    for (int links = 0; links < 40 && fs::is_symlink(fs::symlink_status(target, ignored)); ++links) {
        const fs::path led = fs::read_symlink(target, ignored);
        target = led.is_absolute() ? led : target.parent_path() / led;
    }

    std::error_code why;
    const fs::file_status before = fs::status(target, why);
    if (before.type() == fs::file_type::none) return sentence(path, "cannot be written", why);
    if (fs::is_directory(before)) return path + " cannot be written: it is a directory.";
    if (fs::exists(before)) {
        // Never replace a device by a file, nor a file that its owner has protected.
        std::FILE* file = std::fopen(target.string().c_str(), fs::is_regular_file(before) ? "r+b" : "wb");
        if (file == nullptr) return sentence(path, "cannot be written", last_error());
        if (!fs::is_regular_file(before)) {
            why = write_and_close(file, bytes);
            return why ? sentence(path, "cannot be written", why) : std::string{};
        }
        std::fclose(file);
    }

    fs::path temporary;
    std::FILE* file = open_beside(target, temporary);
    if (file == nullptr) return sentence(path, "cannot be written, its folder takes no new file", last_error());

    why = write_and_close(file, bytes);
    if (!why && fs::exists(before)) fs::permissions(temporary, before.permissions(), ignored);
    if (!why) fs::rename(temporary, target, why);
    if (!why) return {};
    fs::remove(temporary, ignored);
    return sentence(path, "cannot be written", why);
}

}  // namespace text_to_mesh
