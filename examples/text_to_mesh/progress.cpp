// SPDX-License-Identifier: MIT
#include "progress.hpp"

#include <cstdio>
#include <utility>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace text_to_mesh {
namespace {

bool stderr_is_a_terminal()
{
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(STDERR_FILENO) != 0;
#endif
}

}  // namespace

progress::progress() : on_terminal_{stderr_is_a_terminal()} {}

void progress::begin(std::string step)
{
    step_ = std::move(step);
    if (on_terminal_ || clock::now() - started_ >= std::chrono::seconds{2}) show(0);
}

void progress::count(std::size_t done)
{
    const auto now = clock::now();
    if (now < next_ || (!on_terminal_ && now - started_ < std::chrono::seconds{2})) return;
    show(done);
}

void progress::show(std::size_t done)
{
    const auto now = clock::now();
    const std::string line = "text_to_mesh: " + step_ + (done > 0 ? ": " + std::to_string(done) : "") + " ...";
    if (on_terminal_) {
        std::fprintf(stderr, "\r%s\033[K", line.c_str());
        std::fflush(stderr);
        next_ = now + std::chrono::milliseconds{100};
    } else {
        std::fprintf(stderr, "%s\n", line.c_str());
        next_ = now + (now - started_);  // each wait as long as all before
    }
    shown_ = true;
}

void progress::clear()
{
    if (on_terminal_ && shown_) std::fputs("\r\033[K", stderr);
    shown_ = false;
}

}  // namespace text_to_mesh
