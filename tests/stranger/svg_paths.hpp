// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/outline/outline_source.hpp>

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace stranger {

/// Drawings as the `d` of SVG's <path>, y down. Glyph i is path i. All commands except arcs, for which there is no call.
/// Written only from the comments on outline_source and outline_sink.
class svg_paths {
public:
    svg_paths(double size, std::vector<std::string> paths) : size_{size}, paths_{std::move(paths)} {}

    double units_per_em() noexcept { return size_; }
    typemesh::fill_rule fill() noexcept { return typemesh::fill_rule::even_odd; }

    template <typemesh::outline_sink Sink>
    typemesh::error outline(typemesh::glyph_id id, Sink& sink) noexcept
    {
        if (id >= paths_.size()) return typemesh::error::unknown_glyph;
        reader<Sink> r{paths_[id].c_str(), size_, sink};
        return r.run() ? typemesh::error{} : typemesh::error{typemesh::error::bad_outline};
    }

private:
    using point = typemesh::point;

    template <class Sink>
    struct reader {
        const char* next;
        double size;
        Sink& sink;
        point at = {}, start = {}, control = {};

        bool run() noexcept
        {
            char command = 0, before = 0;
            for (;;) {
                skip();
                if (*next == '\0') return true;
                if ((*next >= 'a' && *next <= 'z') || (*next >= 'A' && *next <= 'Z'))
                    command = *next++;
                else if (command == 'M' || command == 'm')  // more numbers after a move are lines
                    command = command == 'M' ? 'L' : 'l';
                if (!draw(command, before)) return false;
                before = command;
            }
        }

    private:
        void skip() noexcept
        {
            while (*next == ' ' || *next == ',' || *next == '\n' || *next == '\t') ++next;
        }
        bool number(double& value) noexcept
        {
            skip();
            char* end = nullptr;
            value = std::strtod(next, &end);
            const bool read = end != next;
            next = end;
            return read;
        }
        bool place(point& p, bool relative) noexcept
        {
            if (!number(p.x) || !number(p.y)) return false;
            if (relative) p = at + p;
            return true;
        }
        [[nodiscard]] point up(point p) const noexcept { return {p.x, size - p.y}; }

        bool draw(char command, char before) noexcept
        {
            const bool relative = command >= 'a';
            const char what = relative ? static_cast<char>(command - 'a' + 'A') : command;
            const char last = before >= 'a' ? static_cast<char>(before - 'a' + 'A') : before;
            point a = at + (at - control), b, p = at;  // a: the control point mirrored, for S and T
            switch (what) {
            case 'Z': sink.close(); return at = control = start, true;
            case 'M': {
                if (!place(p, relative)) return false;
                sink.move(up(p));
                start = p;
                break;
            }
            case 'L':
            case 'H':
            case 'V': {
                double value = 0.0;
                if (what == 'L' ? !place(p, relative) : !number(value)) return false;
                if (what == 'H') p.x = value + (relative ? at.x : 0.0);
                if (what == 'V') p.y = value + (relative ? at.y : 0.0);
                sink.line(up(p));
                break;
            }
            case 'Q':
            case 'T': {
                if (what == 'T' && last != 'Q' && last != 'T') a = at;
                if ((what == 'Q' && !place(a, relative)) || !place(p, relative)) return false;
                sink.quadratic(up(a), up(p));
                return control = a, at = p, true;
            }
            case 'C':
            case 'S': {
                if (what == 'S' && last != 'C' && last != 'S') a = at;
                if ((what == 'C' && !place(a, relative)) || !place(b, relative) || !place(p, relative)) return false;
                sink.cubic(up(a), up(b), up(p));
                return control = b, at = p, true;
            }
            default: return false;
            }
            return at = control = p, true;
        }
    };

    double size_;
    std::vector<std::string> paths_;
};
static_assert(typemesh::outline_source<svg_paths>);

}  // namespace stranger
