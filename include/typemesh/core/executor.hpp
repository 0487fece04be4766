// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <concepts>
#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// A task that does nothing: the concept `executor` is checked with it.
struct ignore_tasks {
    constexpr void operator()(std::size_t, std::size_t) const noexcept {}
};

/// Runs tasks in one or several threads: the caller's job system, or thread_pool (adapt/threads.hpp). The library
/// itself starts no threads.
///
///     x.workers()       the maximum number of tasks at a time, at least 1; constant for the life of x
///     x.run(n, task)    calls task(i, worker) once for each i < n, in any order, worker < workers(), and returns when
///                       all calls have returned; n may be 0
///
/// The compiler checks the signatures. The author guarantees the rest. Within one run(), two calls with equal worker
/// numbers never overlap, so only one thread at a time uses a worker's state. The tasks see everything written before
/// run(), and afterwards the caller sees everything that they wrote. Tasks are noexcept, may be called through a const
/// reference, and do not call run() of their own executor.
template <class X>
concept executor = requires(X& x, std::size_t n, const ignore_tasks& task) {
    { x.workers() } noexcept -> std::convertible_to<std::size_t>;
    { x.run(n, task) } noexcept;
};

/// The executor without threads. Its one worker is the caller, and tasks run in ascending order.
struct one_worker {
    [[nodiscard]] static constexpr std::size_t workers() noexcept { return 1; }

    template <class Task>
    static constexpr void run(std::size_t n, const Task& task) noexcept
    {
        for (std::size_t i = 0; i < n; ++i) task(i, std::size_t{0});
    }
};
static_assert(executor<one_worker>);

}  // namespace typemesh::inline TYPEMESH_ABI
