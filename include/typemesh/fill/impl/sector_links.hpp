// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/fill/impl/arrangement.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Links the boundary of the filled area through a point: `next` of an incoming segment is the outgoing segment with
/// the interior between them. Counter-clockwise around the point, the interior follows every outgoing segment.
///
///     ::::: out      in :::::      in, then out, on either side
///     ------------p----------
class sector_links {
public:
    explicit sector_links(segment* segments) noexcept : segments_{segments} {}

    /// Adds a segment. Order: counter-clockwise, first the segments that start in the point from bottom to top, then
    /// those that end there from top to bottom.
    void take(std::uint32_t i, bool starts) noexcept
    {
        const std::int32_t interior = segments_[i].interior;
        if (interior == 0) return;
        if (last_goes_out_) segments_[i].next = last_;
        last_ = i;
        last_goes_out_ = (interior > 0) == starts;
        if (first_ == no_number) {
            first_ = i;
            first_goes_out_ = last_goes_out_;
        }
        out_count_ += last_goes_out_;
    }

    /// Call after the last segment. True if the boundary passes through the point more than once.
    [[nodiscard]] bool close() noexcept
    {
        if (last_goes_out_ && !first_goes_out_) segments_[first_].next = last_;
        return out_count_ > 1;
    }

private:
    segment* segments_;
    std::uint32_t first_ = no_number, last_ = no_number, out_count_ = 0;
    bool first_goes_out_ = false, last_goes_out_ = false;
};

/// Links through a point where only two segments, in this order, both start or both end. Returns the result of close().
[[nodiscard]] inline bool link_two(segment* segments, std::uint32_t first, std::uint32_t second, bool start) noexcept
{
    sector_links links{segments};
    links.take(first, start);
    links.take(second, start);
    return links.close();
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
