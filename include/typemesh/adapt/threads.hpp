// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/executor.hpp>
#include <typemesh/core/impl/attempt.hpp>

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <new>
#include <thread>

namespace typemesh::inline TYPEMESH_ABI {

/// An executor on std::thread, whose threads are started once and wait for work.
///
///     thread_pool pool{4};                    // three threads, and the one that calls run() is the fourth worker
///     pool.run(n, [&](std::size_t i, std::size_t worker) noexcept { ... });
///
/// Tasks are distributed one by one in ascending order, each to the next free worker, so tasks of unequal size keep all
/// workers busy. run() does not wait for a thread that is slow to wake up, because the other threads take its tasks.
/// run() allocates nothing. Several threads may call run(); their runs take turns.
///
/// If the system provides fewer threads, there are fewer workers, as workers() reports. In builds without exceptions,
/// std::thread ends the program instead.
class thread_pool {
public:
    /// `workers` = 0 means the number of threads that the machine can run at once.
    explicit thread_pool(std::size_t workers = 0) noexcept
    {
        if (workers == 0) workers = std::thread::hardware_concurrency();
        constexpr std::size_t most = 1024;
        if (workers > most) workers = most;
        if (workers > 1) threads_.reset(new (std::nothrow) std::thread[workers - 1]);
        if (threads_ == nullptr) return;
        while (count_ + 1 < workers && start(count_)) ++count_;
    }
    thread_pool(const thread_pool&) = delete;
    thread_pool& operator=(const thread_pool&) = delete;
    ~thread_pool()
    {
        {
            const std::lock_guard lock{state_};
            ending_ = true;
        }
        wake_.notify_all();
        for (std::size_t i = 0; i < count_; ++i) threads_[i].join();
    }

    [[nodiscard]] std::size_t workers() const noexcept { return count_ + 1; }

    /// See executor. The caller is worker 0.
    template <class Task>
    void run(std::size_t n, const Task& task) noexcept
    {
        static_assert(noexcept(task(n, n)), "typemesh: a task must be noexcept: nothing could catch what it throws");
        if (n == 0) return;
        run_tasks(n, &task, [](const void* what, std::size_t i, std::size_t worker) noexcept {
            (*static_cast<const Task*>(what))(i, worker);
        });
    }

private:
    using call = void (*)(const void* task, std::size_t i, std::size_t worker) noexcept;

    bool start(std::size_t i) noexcept
    {
        return detail::attempt([this, i] { threads_[i] = std::thread{[this, i]() noexcept { serve(i + 1); }}; });
    }

    void run_tasks(std::size_t n, const void* task, call how) noexcept
    {
        const std::lock_guard turn{turn_};
        {
            const std::lock_guard lock{state_};
            task_ = task;
            call_ = how;
            last_ = n;
            next_.store(0, std::memory_order_relaxed);
            ++run_;
            open_ = true;
        }
        if (n > 2)
            wake_.notify_all();
        else if (n == 2)
            wake_.notify_one();
        work(0);
        std::unique_lock lock{state_};
        open_ = false;  // threads that have not joined find no work
        done_.wait(lock, [&] { return busy_ == 0; });
    }

    /// The loop of a thread until the pool ends.
    void serve(std::size_t worker) noexcept
    {
        std::size_t seen = 0;
        std::unique_lock lock{state_};
        for (;;) {
            wake_.wait(lock, [&] { return ending_ || (open_ && run_ != seen); });
            if (ending_) return;
            seen = run_;
            ++busy_;
            lock.unlock();
            work(worker);
            lock.lock();
            if (--busy_ == 0 && !open_) done_.notify_one();
        }
    }

    void work(std::size_t worker) noexcept
    {
        for (;;) {
            const std::size_t i = next_.fetch_add(1, std::memory_order_relaxed);
            if (i >= last_) return;
            call_(task_, i, worker);
        }
    }

    std::unique_ptr<std::thread[]> threads_;
    std::size_t count_ = 0;
    std::mutex turn_;   // one run at a time
    std::mutex state_;  // guards all members below except next_; task_, call_ and last_ do not change during a run
    std::condition_variable wake_;
    std::condition_variable done_;
    const void* task_ = nullptr;
    call call_ = nullptr;
    std::size_t last_ = 0;
    std::size_t run_ = 0;
    std::size_t busy_ = 0;  // threads at work
    bool open_ = false;     // threads may join the run
    bool ending_ = false;
    std::atomic<std::size_t> next_{0};
};
static_assert(executor<thread_pool>);

/// A lock for data that threads share, such as a glyph cache: std::mutex with noexcept calls.
class mutex_lock {
public:
    void lock() noexcept { mutex_.lock(); }  // fails only if its own thread already holds it: never here
    void unlock() noexcept { mutex_.unlock(); }

private:
    std::mutex mutex_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
