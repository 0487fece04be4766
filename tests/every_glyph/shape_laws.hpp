// SPDX-License-Identifier: MIT
#pragma once

// Laws of the bevels, the bolder and the hollow letters of one random outline.

#include "fuzz/offsets.hpp"
#include "support/emboldened.hpp"
#include "support/random_outlines.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace test {

/// The findings about one outline, or about several.
struct shape_findings {
    std::size_t shapes = 0, solids = 0;
    std::size_t narrowed = 0;    ///< edges that moved less than wanted, because more was not proven
    std::size_t to_nothing = 0;  ///< bevels among them less than a hundredth as wide
    std::size_t refused = 0;     ///< moved edges that cross at every distance
    std::string wrong;           ///< the first law that is broken, and by what, or nothing

    void add(const shape_findings& f)
    {
        shapes += f.shapes, solids += f.solids, narrowed += f.narrowed, to_nothing += f.to_nothing;
        refused += f.refused;
        if (wrong.empty()) wrong = f.wrong;
    }
};

/// Five solids of the outline of a seed.
class shape_laws {
public:
    explicit shape_laws(std::uint64_t seed) : d_{seed + 77'777}, shape_{seed}
    {
        using namespace typemesh;
        static constexpr double tolerances[] = {0.02, 0.005, 0.00125, 1.0 / 3000.0, 0.0001};
        const double tolerance = tolerances[d_.roll(5)];
        if (!shape_.is_usable()) return;
        from_.made = region_of(from_.caps, shape_.curves, shape_.units_per_em, tolerance);
        if (from_.made.points().empty()) return;
        from_.em = em_of(from_.made);
        found_.shapes = 1;
        examine();
    }
    [[nodiscard]] const shape_findings& found() const { return found_; }

private:
    float distance()
    {
        static constexpr double widths[] = {0.0003, 0.005, 0.02, 0.1, 0.3};
        return static_cast<float>(widths[d_.roll(5)] * (0.5 + d_.fraction()));
    }

    void examine()
    {
        using namespace typemesh;
        static constexpr float limits[] = {1.0f, 1.5f, 2.0f, 4.0f};
        const float limit = limits[d_.roll(4)];
        const auto joins = d_.roll(2) != 0 ? bevel_joins::round : bevel_joins::bevelled;
        bevelled bevel{.width = distance(), .bevel_depth = 0.05f, .joins = joins, .mitre_limit = limit};
        bevel.profile = round_profile(1 + static_cast<std::uint32_t>(d_.roll(5)));
        examine(bevel, "bevel");
        const float by = distance();
        examine(test::emboldened<>{.by = d_.roll(2) != 0 ? by : -by, .joins = joins, .mitre_limit = limit},
                "emboldened");
        const auto place = static_cast<outline_place>(d_.roll(3));
        examine(outlined<extruded<>, extruded<>>{.width = by, .place = place, .joins = joins, .mitre_limit = limit},
                "outlined");
        examine(outlined<bevelled>{.width = by, .place = place, .joins = joins, .mitre_limit = limit, .ring = bevel},
                "outlined, bevelled");
        bevel.outward = true;
        examine(bevel, "outward bevel");
    }

    template <class Extruder>
    void examine(const Extruder& how, const char* name)
    {
        using namespace typemesh;
        fuzz::offset_laws::made_solid<Extruder> s;
        const std::string wrong = s.make(how, from_);
        ++found_.solids;
        if (!wrong.empty() && found_.wrong.empty())
            found_.wrong = std::string{shape_.kind} + ", " + name + ": " + wrong;
        found_.refused += s.failed == error::edges_not_moved || s.failed == error::crossing_contours;
        if (!s.exists) return;
        found_.narrowed += s.plan.narrowed;
        if constexpr (requires {
                          how.width;
                          s.data.swept;
                      })
            found_.to_nothing += s.data.swept.levels.back() < 0.01 * double(how.width) * from_.em;
    }

    dice d_;
    random_outline shape_;
    fuzz::solid_laws::drawn_region from_;
    shape_findings found_;
};

}  // namespace test
