// SPDX-License-Identifier: MIT
#pragma once

// std::mutex for a glyph_cache that several threads share. In a header of its own, so that programs without threads
// need not parse <mutex>.

#include <mutex>

namespace typemesh {

/// The lock of a glyph_cache<mutex_lock>.
class mutex_lock {
public:
    void lock() noexcept { mutex_.lock(); }  // fails only for a mutex that its own thread holds already: never here
    void unlock() noexcept { mutex_.unlock(); }

private:
    std::mutex mutex_;
};

}  // namespace typemesh
