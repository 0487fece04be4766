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

    [[nodiscard]] typemesh::deformed_point operator()(const typemesh::double3& p) const noexcept
    {
        return std::visit([&p](const auto& d) noexcept { return d(p); }, of);
    }
    [[nodiscard]] typemesh::bend_bounds bend(const typemesh::box3& b) const noexcept
    {
        return std::visit([&b](const auto& d) noexcept { return d.bend(b); }, of);
    }
    [[nodiscard]] typemesh::error refused_options() const noexcept
    {
        return std::visit([](const auto& d) noexcept { return d.refused_options(); }, of);
    }
    [[nodiscard]] typemesh::error refused_text(const typemesh::box3& text) const noexcept
    {
        return std::visit([&text](const auto& d) noexcept { return typemesh::refused_text(d, text); }, of);
    }
};

/// A warp in the plane that is chosen at run time; none with monostate.
using chosen_warp = std::variant<std::monostate, typemesh::arc, typemesh::arch, typemesh::flag, typemesh::perspective>;

/// "cylinder:2", "wave:0.1,2" into `out`; "arc:90", "flag:0.2,0" into `warp`. Gives an empty string, or what is wrong:
/// "must ...".
[[nodiscard]] std::string read_bend(std::string_view written, chosen_bend& out, chosen_warp& warp);

}  // namespace text_to_mesh
