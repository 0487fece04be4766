// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/workspace.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// An event at a point that the sweep did not know when it began.
struct event {
    std::int64_t place;     ///< the point's sweep_place()
    std::uint32_t segment;  ///< a segment that starts there, or no_number
    std::uint32_t slot;     ///< a slot in the status whose edge may end there; 0: none
};

/// Events ordered by place, the first one at the top: a binary heap of fixed capacity.
class event_queue {
public:
    /// False if out of memory, or if `room` exceeds 32-bit numbers.
    [[nodiscard]] bool open(workspace::scope& scratch, std::size_t room) noexcept
    {
        if (room >= 0xFFFF'FFFFu) return false;
        events_ = scratch.take<event>(room + 1);
        if (events_ == nullptr) return false;
        room_ = static_cast<std::uint32_t>(room);
        size_ = 0;
        events_[0].place = nowhere;
        return true;
    }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
    /// The place of the first event; beyond all points if there is none.
    [[nodiscard]] std::int64_t first_place() const noexcept { return events_[0].place; }
    [[nodiscard]] std::uint32_t room() const noexcept { return room_ - size_; }
    [[nodiscard]] const event& top() const noexcept { return events_[0]; }

    /// Precondition: free capacity.
    void push(const event& e) noexcept
    {
        std::uint32_t i = size_++;
        for (; i != 0 && e.place < events_[(i - 1) / 2].place; i = (i - 1) / 2) events_[i] = events_[(i - 1) / 2];
        events_[i] = e;
    }

    void pop() noexcept
    {
        const event last = events_[--size_];
        if (size_ == 0) {
            events_[0].place = nowhere;
            return;
        }
        std::uint32_t i = 0;
        for (std::uint32_t child = 1; child < size_; child = 2 * i + 1) {
            if (child + 1 < size_ && events_[child + 1].place < events_[child].place) ++child;
            if (last.place <= events_[child].place) break;
            events_[i] = events_[child];
            i = child;
        }
        events_[i] = last;
    }

private:
    static constexpr std::int64_t nowhere = (std::numeric_limits<std::int64_t>::max)();

    event* events_ = nullptr;
    std::uint32_t size_ = 0;
    std::uint32_t room_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
