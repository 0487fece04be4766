// SPDX-License-Identifier: MIT
#include "atomic_file.hpp"

#include "part_files.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#else
#include <unistd.h>
#endif

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

#ifdef _WIN32
bool is_terminal(std::FILE* file) { return _isatty(_fileno(file)) != 0; }
void take_bytes(std::FILE* file) { (void)_setmode(_fileno(file), _O_BINARY); }
#else
bool is_terminal(std::FILE* file) { return isatty(fileno(file)) != 0; }
void take_bytes(std::FILE*) {}
#endif

}  // namespace

/// A file on its way: complete beside its target, and not yet in its place.
class pending_file {
public:
    pending_file() = default;
    pending_file(const pending_file&) = delete;
    pending_file& operator=(const pending_file&) = delete;
    ~pending_file()
    {
        if (device_ != nullptr && device_ != stdout) std::fclose(device_);
    }

    /// Both give an empty string, or one sentence.
    std::string prepare(const std::string& path, std::span<const unsigned char> bytes);
    std::string finish();

    [[nodiscard]] bool is_device() const { return device_ != nullptr; }

private:
    std::string path_;
    std::vector<unsigned char> for_device_;
    fs::path target_;
    part_file part_;
    fs::file_status before_;
    std::FILE* device_ = nullptr;
};

std::string pending_file::prepare(const std::string& path, std::span<const unsigned char> bytes)
{
    path_ = path;
    if (path.empty()) return "The name of the output file is empty.";
    if (path == standard_output) {
        path_ = "standard output";
        if (is_terminal(stdout)) return path_ + " is a terminal, which cannot show this file: send it into a file.";
        take_bytes(stdout);
        device_ = stdout;
        for_device_.assign(bytes.begin(), bytes.end());
        return {};
    }

    // Where the path is a symbolic link, the file it leads to is made or replaced, not the link.
    std::error_code ignored;
    target_ = path;
    for (int links = 0; links < 40 && fs::is_symlink(fs::symlink_status(target_, ignored)); ++links) {
        const fs::path led = fs::read_symlink(target_, ignored);
        target_ = led.is_absolute() ? led : target_.parent_path() / led;
    }

    std::error_code why;
    before_ = fs::status(target_, why);
    if (before_.type() == fs::file_type::none) return sentence(path, "cannot be written", why);
    if (fs::is_directory(before_)) return path + " cannot be written: it is a directory.";
    if (fs::exists(before_)) {
        // Never replace a device by a file, nor a file that its owner has protected.
        std::FILE* opened = std::fopen(target_.string().c_str(), fs::is_regular_file(before_) ? "r+b" : "wb");
        if (opened == nullptr) return sentence(path, "cannot be written", last_error());
        if (!fs::is_regular_file(before_)) {
            device_ = opened;
            for_device_.assign(bytes.begin(), bytes.end());
            return {};
        }
        std::fclose(opened);
    }

    std::FILE* opened = part_.open(target_.parent_path());
    if (opened == nullptr) {
        why = last_error();
        const fs::path folder = target_.parent_path();
        if (!folder.empty() && !fs::exists(folder, ignored))
            return path + " cannot be written: there is no folder " + folder.string() + ".";
        return sentence(path, "cannot be written", why);
    }
    why = write_and_close(opened, bytes);
    if (!why && fs::exists(before_)) fs::permissions(part_.path(), before_.permissions(), ignored);
    return why ? sentence(path, "cannot be written", why) : std::string{};
}

std::string pending_file::finish()
{
    std::error_code why;
    if (device_ != nullptr)
        why = write_and_close(std::exchange(device_, nullptr), for_device_);
    else
        why = part_.move_to(target_);
    return why ? sentence(path_, "cannot be written", why) : std::string{};
}

file_set::file_set() = default;
file_set::~file_set() = default;

std::string file_set::add(const std::string& path, std::span<const unsigned char> bytes)
{
#ifdef SIGXFSZ
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is to be an error to report, not the end of the program
#endif
#ifdef SIGPIPE
    std::signal(SIGPIPE, SIG_IGN);  // likewise a reader that has gone
#endif
    pending_.push_back(std::make_unique<pending_file>());
    return pending_.back()->prepare(path, bytes);
}

std::string file_set::finish()
{
    std::stable_partition(pending_.begin(), pending_.end(), [](const auto& p) { return p->is_device(); });
    for (const auto& p : pending_)
        if (std::string trouble = p->finish(); !trouble.empty()) return trouble;
    pending_.clear();
    return {};
}

std::string write_atomically(const std::string& path, std::span<const unsigned char> bytes)
{
    file_set one;
    std::string trouble = one.add(path, bytes);
    return trouble.empty() ? one.finish() : trouble;
}

}  // namespace text_to_mesh
