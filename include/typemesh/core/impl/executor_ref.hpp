// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/executor.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// Refers to an executor of any type, which must outlive it. It is itself an executor.
class executor_ref {
public:
    template <executor Executor>
        requires(!std::same_as<Executor, executor_ref>)
    executor_ref(Executor& workers) noexcept : workers_{&workers}, does_{&calls_of<Executor>}
    {
    }

    [[nodiscard]] std::size_t workers() const noexcept { return does_->workers(workers_); }

    template <class Task>
    void run(std::size_t n, const Task& task) const noexcept
    {
        does_->run(workers_, n, {&task, [](const void* what, std::size_t i, std::size_t worker) noexcept {
                                     (*static_cast<const Task*>(what))(i, worker);
                                 }});
    }

private:
    struct task_ref {
        const void* task;
        void (*call)(const void* task, std::size_t i, std::size_t worker) noexcept;

        void operator()(std::size_t i, std::size_t worker) const noexcept { call(task, i, worker); }
    };
    struct calls {
        std::size_t (*workers)(void* workers) noexcept;
        void (*run)(void* workers, std::size_t n, task_ref task) noexcept;
    };
    template <executor Executor>
    static constexpr calls calls_of = {
        [](void* workers) noexcept -> std::size_t { return static_cast<Executor*>(workers)->workers(); },
        [](void* workers, std::size_t n, task_ref task) noexcept { static_cast<Executor*>(workers)->run(n, task); }};

    void* workers_;
    const calls* does_;
};
static_assert(executor<executor_ref>);

}  // namespace typemesh::inline TYPEMESH_ABI
