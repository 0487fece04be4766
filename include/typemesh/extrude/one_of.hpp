// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/option_hash.hpp>
#include <typemesh/core/policy_key.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/wall_segments.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// The plan data of the chosen solid. Stored as bytes, it is as large as that solid's own data.
template <class... Solids>
class one_of_data {
public:
    /// Finds the data of the chosen solid while it is written.
    class view {
        friend class one_of_data;

    public:
        template <std::size_t Choice>
        [[nodiscard]] auto of() const noexcept
        {
            using data = std::tuple_element_t<Choice, all_data>;
            return live_ != nullptr ? std::get<Choice>(*live_).read() : data::read_from(stored_);
        }

    private:
        const std::tuple<plan_data_of<Solids>...>* live_ = nullptr;  // the live data; null if the data are stored
        const std::byte* stored_ = nullptr;
    };

    explicit one_of_data(memory source = heap()) noexcept : all_{plan_data_of<Solids>{source}...} {}

    template <std::size_t Choice>
    [[nodiscard]] auto& become() noexcept
    {
        choice_ = Choice;
        return std::get<Choice>(all_);
    }
    void clear() noexcept
    {
        std::apply([](auto&... data) noexcept { (data.clear(), ...); }, all_);
    }
    [[nodiscard]] view read() const noexcept
    {
        view now;
        now.live_ = &all_;
        return now;
    }

    // --- as bytes: see plan_arrays

    [[nodiscard]] std::size_t bytes() const noexcept
    {
        std::size_t size = 0;
        chosen([&size](const auto& data) noexcept { size = data.bytes(); });
        return size;
    }
    void copy_to(std::byte* block) const noexcept
    {
        chosen([block](const auto& data) noexcept { data.copy_to(block); });
    }
    [[nodiscard]] static view read_from(const std::byte* block) noexcept
    {
        view then;
        then.stored_ = block;
        return then;
    }

private:
    using all_data = std::tuple<plan_data_of<Solids>...>;

    template <class What>
    void chosen(const What& what) const noexcept
    {
        std::apply(
            [&](const auto&... data) noexcept {
                std::size_t number = 0;
                ((number++ == choice_ ? what(data) : void()), ...);
            },
            all_);
    }

    all_data all_;
    std::size_t choice_ = 0;
};

}  // namespace detail

/// One of several extruders, chosen at run time:
///
///     text_mesher<one_of<flat, extruded<>, bevelled>> mesher{font};       // flat so far
///     mesher.solid() = bevelled{.width = 0.03f};
///
/// It has the parts of all its extruders; the parts that the chosen extruder does not make are empty. The choice is
/// evaluated once per glyph and part, not per vertex. A glyph_cache distinguishes the choices.
template <extruder... Solids>
class one_of {
    static_assert(sizeof...(Solids) != 0, "typemesh: one_of needs at least one solid");
    template <class Solid>
    static constexpr int times = (0 + ... + int{std::same_as<Solid, Solids>});
    static_assert(((times<Solids> == 1) && ...), "typemesh: one_of names each type of solid once");

public:
    static constexpr std::size_t part_count = (std::max)({part_count_of<Solids>...});
    /// Whether all its solids accept points inside the region.
    static constexpr bool writes_inner_points = (takes_inner_points<Solids> && ...);
    using plan_data = detail::one_of_data<Solids...>;
    using solid = solid_with<plan_data>;

    /// The first extruder, with its default options.
    one_of() noexcept = default;
    template <class Solid>
        requires(times<Solid> == 1)
    one_of(Solid chosen) noexcept : choice_{std::in_place_type<Solid>, std::move(chosen)}
    {
    }

    /// The index of the chosen extruder in the template arguments.
    [[nodiscard]] std::size_t index() const noexcept { return choice_.index(); }
    /// The chosen extruder, for changing its options; null if it has another type.
    template <class Solid>
        requires(times<Solid> == 1)
    [[nodiscard]] Solid* get() noexcept
    {
        return std::get_if<Solid>(&choice_);
    }

    /// The number of segments of the chosen extruder's walls; 1 if they cannot be divided.
    [[nodiscard]] std::uint32_t wall_segments() const noexcept
    {
        return visit([](auto, const auto& how) noexcept { return segments_of(how); });
    }
    /// Changes this number, if the walls can be divided.
    void set_wall_segments(std::uint32_t segments) noexcept
    {
        visit([segments](auto, auto& how) noexcept { set_segments(how, segments); });
    }

    // --- an extruder: see extruder.hpp

    [[nodiscard]] option_bits cache_key() const noexcept
        requires(cacheable_policy<Solids> && ...)
    {
        option_hash all;
        visit([&all](auto, const auto& how) noexcept { all.add_key_of(how); });
        return {all.first, all.second, std::uint64_t{index()}};
    }

    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan(const region& r, plan_data& data, Caps& caps) const noexcept
    {
        return visit(
            [&](auto at, const auto& how) noexcept { return plan_solid(how, r, data.template become<at>(), caps); });
    }

    [[nodiscard]] height_range heights() const noexcept
    {
        return visit([](auto, const auto& how) noexcept { return how.heights(); });
    }
    [[nodiscard]] height_range heights(const solid& s) const noexcept
        requires(has_heights<Solids> || ...)
    {
        return visit([&s](auto at, const auto& how) noexcept { return heights_of(how, of<at>(s)); });
    }
    /// The name of the chosen extruder's option that is at fault if the heights cannot be written.
    [[nodiscard]] const char* heights_name() const noexcept
    {
        return visit([](auto, const auto& how) noexcept { return heights_name_of(how); });
    }
    /// See extruder.hpp.
    [[nodiscard]] bool plans_in_place() const noexcept
    {
        return visit([](auto, const auto& how) noexcept { return typemesh::plans_in_place(how); });
    }
    /// See extruder.hpp.
    [[nodiscard]] bool measures_in_em() const noexcept
    {
        return visit([](auto, const auto& how) noexcept { return typemesh::measures_in_em(how); });
    }
    /// See extruder.hpp.
    [[nodiscard]] error refused_text(const box& text) const noexcept
        requires(refuses_texts<Solids> || ...)
    {
        return visit([&text]<class Solid>(auto, const Solid& how) noexcept {
            if constexpr (refuses_texts<Solid>)
                return how.refused_text(text);
            else
                return error{};
        });
    }
    /// Whether the triangles of the chosen extruder are not the region's own.
    [[nodiscard]] bool has_own_caps() const noexcept
    {
        return visit([](auto, const auto& how) noexcept { return typemesh::has_own_caps(how); });
    }
    template <class Put>
    void seen_from_front(const solid& s, Put&& put) const noexcept
        requires(has_front_triangles<Solids> || ...)
    {
        visit([&](auto at, const auto& how) noexcept { each_seen_from_front(how, of<at>(s), put); });
    }
    /// The chosen extruder's outline, or the region's.
    [[nodiscard]] solid_outline outline(const solid& s) const noexcept
        requires(has_outline<Solids> || ...)
    {
        return visit([&s]<class Solid>(auto at, const Solid& how) noexcept {
            if constexpr (has_outline<Solid>)
                return how.outline(of<at>(s));
            else
                return solid_outline{s.points, s.starts};
        });
    }
    /// The number of hard edges that the chosen extruder counts; 0 if it does not count hard edges.
    [[nodiscard]] std::uint64_t hard_edges(const solid& s) const noexcept
        requires(has_hard_edges<Solids> || ...)
    {
        return visit([&s]<class Solid>(auto at, const Solid& how) noexcept -> std::uint64_t {
            if constexpr (has_hard_edges<Solid>)
                return how.hard_edges(of<at>(s));
            else
                return 0;
        });
    }
    [[nodiscard]] bool refit(const solid& s) noexcept
        requires(refitting_extruder<Solids> || ...)
    {
        return visit([&s]<class Solid>(auto at, Solid& how) noexcept {
            if constexpr (refitting_extruder<Solid>)
                return how.refit(of<at>(s));
            else
                return false;
        });
    }

    template <attribute Wants, class Put>
    void vertices(part p, const solid& s, const placement& at, Put&& put) const noexcept
    {
        visit([&]<class Solid>(auto number, const Solid& how) noexcept {
            if (makes<Solid>(p)) how.template vertices<Wants>(p, of<number>(s), at, put);
        });
    }
    template <class Put>
    void triangles(part p, const solid& s, const first_vertices& first, Put&& put) const noexcept
    {
        visit([&]<class Solid>(auto number, const Solid& how) noexcept {
            if (makes<Solid>(p)) how.triangles(p, of<number>(s), first, put);
        });
    }

private:
    template <class Solid>
    static constexpr bool makes(part p) noexcept
    {
        return static_cast<std::size_t>(p) < part_count_of<Solid>;
    }
    /// The solid, with the type that the chosen extruder needs.
    template <std::size_t Choice>
    static auto of(const solid& s) noexcept
    {
        using chosen = std::tuple_element_t<Choice, std::tuple<Solids...>>;
        return solid_of<chosen>{s, s.data.template of<Choice>()};
    }

    /// Calls what(the index of the chosen extruder as a type, the chosen extruder).
    template <std::size_t Choice = 0, class What>
    auto visit(const What& what) const noexcept
    {
        if constexpr (Choice + 1 < sizeof...(Solids))
            if (index() != Choice) return visit<Choice + 1>(what);
        return what(std::integral_constant<std::size_t, Choice>{}, *std::get_if<Choice>(&choice_));
    }
    template <std::size_t Choice = 0, class What>
    auto visit(const What& what) noexcept
    {
        if constexpr (Choice + 1 < sizeof...(Solids))
            if (index() != Choice) return visit<Choice + 1>(what);
        return what(std::integral_constant<std::size_t, Choice>{}, *std::get_if<Choice>(&choice_));
    }

    std::variant<Solids...> choice_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
