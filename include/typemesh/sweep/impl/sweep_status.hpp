// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/workspace.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The items that a sweep line crosses, bottom to top: a linked list while it is short, a skip list once it is long.
///
///     lane 2   head ------------------------------> 7 -----------------> head
///     lane 1   head ----------> 4 ----------------> 7 ------> 1 -------> head
///     items    0 ---> 3 ------> 4 ---> 9 ---> 2 --> 7 ------> 1 --> 8 -> 0
///
/// Items are numbers from 1 that the sweep assigns; 0 marks both ends of the list. Items that exist when the first lane
/// opens get no tower. There are at most `lanes_from` of them, so a search still takes O(log n) steps. Tower heights
/// come from a generator with a fixed seed: equal input takes equal steps.
/// From  W. Pugh, Skip lists: a probabilistic alternative to balanced trees (1990)
class sweep_status {
    static constexpr std::uint32_t lanes_from = 16;  ///< items without a lane; 8 to 48 are equally fast
    static constexpr std::uint32_t max_lanes = 11;   ///< every fourth item rises to the next: 4^11 items

    struct place {
        std::uint32_t link[2];  // below, above
        std::uint32_t tower;    // its highest stop; 0: none
    };
    struct stop {
        std::uint32_t item;
        std::uint32_t link[2];
        std::uint32_t down;  // the same item's stop one lane lower; 0: none
    };

public:
    /// Takes memory for the items 1 to `max_items`, about 18 bytes per item. False if out of memory.
    [[nodiscard]] bool open(workspace::scope& scratch, std::size_t max_items) noexcept
    {
        places_ = scratch.take<place>(max_items + 1);
        if (places_ == nullptr) return false;
        places_[0] = {{0, 0}, 0};
        if (max_items <= lanes_from) return true;
        stop_count_ = max_lanes + 1 + static_cast<std::uint32_t>(max_items / 3);
        stops_ = scratch.take<stop>(stop_count_);
        if (stops_ == nullptr) return false;
        for (std::uint32_t lane = 1; lane <= max_lanes; ++lane) stops_[lane] = {0, {lane, lane}, lane - 1};
        next_stop_ = max_lanes + 1;
        return true;
    }

    [[nodiscard]] std::uint32_t size() const noexcept { return size_; }
    [[nodiscard]] std::uint32_t below(std::uint32_t item) const noexcept { return places_[item].link[0]; }
    [[nodiscard]] std::uint32_t above(std::uint32_t item) const noexcept { return places_[item].link[1]; }
    /// side 0: below, 1: above.
    [[nodiscard]] std::uint32_t neighbour(std::uint32_t item, std::uint32_t side) const noexcept
    {
        return places_[item].link[side];
    }

    /// The last item for which `lies_below(item)` is true, or 0. It must be true for a first part of the items and
    /// false for the rest; otherwise the result is some item for which it is true, but false for the next.
    /// lies_below(0) is false.
    template <class LiesBelow>
    [[nodiscard]] std::uint32_t last_below(const LiesBelow& lies_below) noexcept
    {
        std::uint32_t item = 0;
        if (lanes_ != 0) {
            std::uint32_t at = lanes_;
            for (std::uint32_t lane = lanes_;; --lane) {
                while (lies_below(stops_[stops_[at].link[1]].item)) at = stops_[at].link[1];
                found_[lane] = at;
                if (lane == 1) break;
                at = stops_[at].down;
            }
            item = stops_[at].item;
        }
        for (std::uint32_t next = places_[item].link[1]; lies_below(next); next = places_[item].link[1]) item = next;
        return item;
    }

    /// Inserts `item` right above `under`. `under` is the result of the last search, or was inserted right above it.
    void insert_above(std::uint32_t under, std::uint32_t item) noexcept
    {
        const std::uint32_t over = places_[under].link[1];
        places_[item] = {{under, over}, 0};
        places_[under].link[1] = item;
        places_[over].link[0] = item;
        if (++size_ > lanes_from) raise(item);
    }

    void erase(std::uint32_t item) noexcept
    {
        const place p = places_[item];
        places_[p.link[0]].link[1] = p.link[1];
        places_[p.link[1]].link[0] = p.link[0];
        for (std::uint32_t s = p.tower; s != 0;) {
            const stop gone = stops_[s];
            stops_[gone.link[0]].link[1] = gone.link[1];
            stops_[gone.link[1]].link[0] = gone.link[0];
            stops_[s].link[0] = free_stop_;
            free_stop_ = s;
            s = gone.down;
        }
        --size_;
    }

private:
    void raise(std::uint32_t item) noexcept
    {
        random_ ^= random_ << 13;  // xorshift: G. Marsaglia, Xorshift RNGs (2003)
        random_ ^= random_ >> 17;
        random_ ^= random_ << 5;
        const std::uint32_t height = static_cast<std::uint32_t>(std::countr_zero(random_ | 1u << (2 * max_lanes))) / 2;
        std::uint32_t down = 0;
        for (std::uint32_t lane = 1; lane <= height; ++lane) {
            std::uint32_t s = free_stop_;
            if (s != 0)
                free_stop_ = stops_[s].link[0];
            else if (next_stop_ < stop_count_)
                s = next_stop_++;
            else
                break;                                        // an item without a tower only takes longer to find
            if (lane > lanes_) found_[lanes_ = lane] = lane;  // the new lane's head
            const std::uint32_t before = found_[lane], after = stops_[before].link[1];
            stops_[s] = {item, {before, after}, down};
            stops_[before].link[1] = s;
            stops_[after].link[0] = s;
            found_[lane] = s;  // so that a second item can be inserted after the same search
            places_[item].tower = down = s;
        }
    }

    place* places_ = nullptr;
    stop* stops_ = nullptr;  // 1 to max_lanes: the heads
    std::uint32_t stop_count_ = 0;
    std::uint32_t next_stop_ = 0;
    std::uint32_t free_stop_ = 0;
    std::uint32_t size_ = 0;
    std::uint32_t lanes_ = 0;
    std::uint32_t random_ = 0x9E37'79B9u;
    std::uint32_t found_[max_lanes + 1] = {};
};

}  // namespace typemesh::inline TYPEMESH_ABI
