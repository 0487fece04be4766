// SPDX-License-Identifier: MIT
#include "part_files.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <string>
#include <system_error>
#include <utility>

#ifndef _WIN32
#include <unistd.h>
#endif

namespace text_to_mesh {
namespace {

namespace fs = std::filesystem;

#ifdef _WIN32

class held_signals {};
int add_name(const fs::path&) { return -1; }
void remove_name(int) {}

#else

constexpr int max_names = 16;
const char* volatile names[max_names];  // what a signal removes; null: none

extern "C" void remove_parts(int signal)
{
    for (int i = 0; i < max_names; ++i)
        if (const char* const name = names[i]) unlink(name);
    std::signal(signal, SIG_DFL);
    raise(signal);  // comes when this one has returned
}

constexpr int ending[] = {SIGINT, SIGTERM, SIGHUP};

/// While it lives no such signal comes.
class held_signals {
public:
    held_signals()
    {
        sigset_t all;
        sigemptyset(&all);
        for (const int s : ending) sigaddset(&all, s);
        sigprocmask(SIG_BLOCK, &all, &before_);
    }
    held_signals(const held_signals&) = delete;
    held_signals& operator=(const held_signals&) = delete;
    ~held_signals() { sigprocmask(SIG_SETMASK, &before_, nullptr); }

private:
    sigset_t before_;
};

void catch_signals()
{
    for (const int s : ending) {
        struct sigaction now = {};
        if (sigaction(s, nullptr, &now) != 0 || now.sa_handler != SIG_DFL) continue;  // nohup has SIGHUP ignored
        now.sa_handler = remove_parts;
        sigaction(s, &now, nullptr);
    }
}

int add_name(const fs::path& path)
{
    catch_signals();
    for (int i = 0; i < max_names; ++i) {
        if (names[i] != nullptr) continue;
        names[i] = path.c_str();
        return i;
    }
    return -1;
}

void remove_name(int slot)
{
    if (slot >= 0) names[slot] = nullptr;
}

#endif

}  // namespace

std::FILE* part_file::open(const fs::path& folder)
{
    discard();
    const auto start = std::chrono::steady_clock::now().time_since_epoch().count();
    for (int attempt = 0; attempt < 100; ++attempt) {
        path_ = folder / (".text_to_mesh-" + std::to_string(start + attempt) + ".part");
        [[maybe_unused]] const held_signals held;
        errno = 0;
        std::FILE* const file = std::fopen(path_.string().c_str(), "wbx");
        if (file != nullptr) {
            slot_ = add_name(path_);
            return file;
        }
        if (errno != EEXIST) break;
    }
    path_.clear();
    return nullptr;
}

std::error_code part_file::move_to(const fs::path& target)
{
    [[maybe_unused]] const held_signals held;
    std::error_code why;
    fs::rename(path_, target, why);
    if (why) return why;
    remove_name(std::exchange(slot_, -1));
    path_.clear();
    return {};
}

void part_file::discard()
{
    [[maybe_unused]] const held_signals held;
    std::error_code ignored;
    if (!path_.empty()) fs::remove(path_, ignored);
    remove_name(std::exchange(slot_, -1));
    path_.clear();
}

}  // namespace text_to_mesh
