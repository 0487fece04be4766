// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/arc.hpp>
#include <typemesh/bend/arch.hpp>
#include <typemesh/bend/flag.hpp>
#include <typemesh/bend/on_cylinder.hpp>
#include <typemesh/bend/on_sphere.hpp>
#include <typemesh/bend/perspective.hpp>
#include <typemesh/bend/taper.hpp>
#include <typemesh/bend/twist.hpp>
#include <typemesh/bend/wave.hpp>

#include <string>
#include <string_view>
#include <variant>

namespace text_to_mesh {

/// A deformation that is chosen at run time.
struct chosen_bend {
    std::variant<typemesh::on_cylinder, typemesh::on_sphere, typemesh::twist, typemesh::taper,
                 typemesh::displaced<typemesh::wave>>
        of;

    double middle = 0.0;  ///< the place along the text that is x = 0 for the deformation, in em

    [[nodiscard]] typemesh::deformed_point operator()(const typemesh::double3& p) const noexcept
    {
        auto bent = std::visit([q = moved(p)](const auto& d) noexcept { return d(q); }, of);
        bent.at.x += middle;
        return bent;
    }
    [[nodiscard]] typemesh::bend_bounds bend(const typemesh::box3& b) const noexcept
    {
        return std::visit([c = moved(b)](const auto& d) noexcept { return d.bend(c); }, of);
    }
    [[nodiscard]] typemesh::error refused_options() const noexcept
    {
        return std::visit([](const auto& d) noexcept { return d.refused_options(); }, of);
    }
    [[nodiscard]] typemesh::error refused_text(const typemesh::box3& text) const noexcept
    {
        return std::visit([t = moved(text)](const auto& d) noexcept { return typemesh::refused_text(d, t); }, of);
    }

private:
    [[nodiscard]] typemesh::double3 moved(const typemesh::double3& p) const noexcept
    {
        return {p.x - middle, p.y, p.z};
    }
    [[nodiscard]] typemesh::box3 moved(const typemesh::box3& b) const noexcept { return {moved(b.low), moved(b.high)}; }
};

/// A warp in the plane that is chosen at run time; none with monostate.
using chosen_warp = std::variant<std::monostate, typemesh::arc, typemesh::arch, typemesh::flag, typemesh::perspective>;

/// "cylinder:2", "wave:0.1,2" into `out`; "arc:90", "flag:0.2,0" into `warp`. Gives an empty string, or what is wrong:
/// "must ...".
[[nodiscard]] std::string read_bend(std::string_view written, chosen_bend& out, chosen_warp& warp);

}  // namespace text_to_mesh
