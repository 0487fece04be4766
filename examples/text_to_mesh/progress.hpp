// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace text_to_mesh {

/// Reports on standard error what a long text is waiting for.
///
///     on a terminal   one line, written over and over, gone at the end
///     else            nothing for two seconds, then one line per step, rarely one within a step
///
/// Must end, or clear(), before anything else is written to the terminal.
class progress {
public:
    progress();
    ~progress() { clear(); }
    progress(const progress&) = delete;
    progress& operator=(const progress&) = delete;

    /// What begins now: "building the letters".
    void begin(std::string step);
    /// How much of it has been done.
    void count(std::size_t done);
    void clear();

private:
    using clock = std::chrono::steady_clock;

    void show(std::size_t done);

    bool on_terminal_;
    bool shown_ = false;
    clock::time_point started_ = clock::now(), next_ = started_;
    std::string step_;
};

}  // namespace text_to_mesh
