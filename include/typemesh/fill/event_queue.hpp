// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/workspace.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Something that a sweep will meet at a point that it did not know before.
struct event {
    std::int64_t place;     ///< of the point, as sweep_place()
    std::uint32_t segment;  ///< that starts there, or no_number
    std::uint32_t slot;     ///< in the status, of an edge that may end there; 0: none
};

/// Events by place, the first one on top: a binary heap of fixed room.
class event_queue {
public:
    /// False when there is no memory, or more room is asked for than 32-bit numbers hold.
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
    /// Of the first event; behind all points when there is none.
    [[nodiscard]] std::int64_t first_place() const noexcept { return events_[0].place; }
    [[nodiscard]] std::uint32_t room() const noexcept { return room_ - size_; }
    [[nodiscard]] const event& top() const noexcept { return events_[0]; }

    /// Needs room.
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
