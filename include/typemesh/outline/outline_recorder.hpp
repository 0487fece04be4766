// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/outline/outline_sink.hpp>
#include <typemesh/outline/outline_source.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// A sink that stores an outline as curves (core/outline.hpp). It is the first step of every mesh.
///
/// Curves of length zero are dropped, and so are contours without a curve; the bounds do not include them. Open
/// contours are closed with a line. After the first error all further calls are ignored; finish() returns it.
class outline_recorder {
public:
    /// Starts recording into `out`, which is emptied first and must outlive the recorder. At most `most` curves are
    /// recorded.
    explicit outline_recorder(outline& out, std::uint32_t most = 0xFFFF'FFFFu) noexcept : out_{out}, most_{most}
    {
        out_.clear();
    }

    void move(point p) noexcept
    {
        close();
        start_ = current_ = p;
        open_ = true;
        bounds_before_ = out_.bounds;
        note(p);
    }
    void line(point p) noexcept
    {
        if (!note(p)) return;
        if (!(p == current_)) keep(curve::from(current_, p));
        current_ = p;
    }
    void quadratic(point control, point p) noexcept
    {
        if (!note(control) || !note(p)) return;
        if (!(control == current_ && p == current_)) keep(curve::from(typemesh::quadratic{current_, control, p}));
        current_ = p;
    }
    void cubic(point control1, point control2, point p) noexcept
    {
        if (!note(control1) || !note(control2) || !note(p)) return;
        if (!(control1 == current_ && control2 == current_ && p == current_))
            keep(curve::from(typemesh::cubic{current_, control1, control2, p}));
        current_ = p;
    }
    void close() noexcept
    {
        if (!open_) return;
        if (!(current_ == start_)) line(start_);
        open_ = false;
        if (error_) return;
        const auto end = static_cast<std::uint32_t>(out_.curves.size());
        const std::uint32_t begin = out_.starts.empty() ? 0u : out_.starts.back();
        if (end == begin) {
            out_.bounds = bounds_before_;
            return;
        }
        if (out_.starts.empty() && !out_.starts.push_back(0))
            error_ = error::out_of_memory;
        else if (!out_.starts.push_back(end))
            error_ = error::out_of_memory;
    }

    /// Closes the last contour and returns the first error: error::outline_not_finite, error::bad_outline (a contour
    /// does not begin with move), error::too_many_points, error::out_of_memory, error::too_large, or none.
    error finish() noexcept
    {
        close();
        return error_;
    }

private:
    bool note(point p) noexcept
    {
        const bool good = !error_ && open_ && is_finite(p.x) && is_finite(p.y);
        if (good)
            out_.bounds.add(p);
        else if (!error_)
            error_ = open_ ? error::outline_not_finite : error::bad_outline;
        return good;
    }
    void keep(const curve& c) noexcept
    {
        if (out_.curves.size() == most_)
            error_ = most_ < 0xFFFF'FFFFu ? error{error::too_many_points, most_} : error::too_large;
        else if (!out_.curves.push_back(c))
            error_ = error::out_of_memory;
    }

    outline& out_;
    std::uint32_t most_;
    point start_;
    point current_;
    box bounds_before_;  // the bounds of the contours before the current one
    bool open_ = false;
    error error_;
};

static_assert(outline_sink<outline_recorder>);

/// Reads one glyph of a source, with its fill rule, into `out`. This is the whole stage in one call.
///
///     most    the maximum number of curves of the glyph
///
/// Fails with the source's error (error::unknown_glyph, ...), otherwise like finish(); `out` is then meaningless.
template <outline_source Source>
result<void> record(Source& source, glyph_id id, outline& out, std::uint32_t most = 0xFFFF'FFFFu) noexcept
{
    outline_recorder recorder{out, most};
    if (error e = source.outline(id, recorder)) return e;
    out.rule = source.fill();
    return recorder.finish();
}

}  // namespace typemesh::inline TYPEMESH_ABI
