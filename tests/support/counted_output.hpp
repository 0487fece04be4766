// SPDX-License-Identifier: MIT
#pragma once

// Output that checks how it is written: every element once, in ascending order within its subrange, and none outside.

#include "support/mesh_laws.hpp"

#include <typemesh/vertex/ranged_sink.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace test {

struct counted_output {
    std::vector<full_vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<std::uint8_t> vertex_writes, index_writes;

    void expect(typemesh::mesh_size size)
    {
        vertices.assign(size.vertices, {});
        indices.assign(size.indices(), 0);
        vertex_writes.assign(size.vertices, 0);
        index_writes.assign(size.indices(), 0);
    }
    [[nodiscard]] bool each_once() const
    {
        for (const auto* all : {&vertex_writes, &index_writes})
            for (const std::uint8_t n : *all)
                if (n != 1) return false;
        return true;
    }
};

/// A sink of a subrange: counts writes, and those that would fall outside.
class counted_segment {
public:
    static constexpr auto wants = typemesh::vertex_traits<full_vertex>::wants;

    counted_segment(counted_output& to, typemesh::mesh_range range) noexcept
        : to_{&to},
          vertex_{range.first_vertex},
          vertices_end_{vertex_ + range.vertex_count},
          index_{range.first_index},
          indices_end_{index_ + range.index_count}
    {
    }
    typemesh::error begin(typemesh::mesh_size) noexcept { return {}; }
    void vertex(const typemesh::surface_point<wants>& s) noexcept
    {
        if (vertex_ >= vertices_end_) std::abort();
        to_->vertices[vertex_] = typemesh::vertex_traits<full_vertex>{}(s);
        ++to_->vertex_writes[vertex_++];
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
    {
        if (index_ + 3 > indices_end_) std::abort();
        for (const std::uint32_t i : {a, b, c}) {
            to_->indices[index_] = i;
            ++to_->index_writes[index_++];
        }
    }
    void end() noexcept {}

private:
    counted_output* to_;
    std::size_t vertex_, vertices_end_, index_, indices_end_;
};

/// The sink itself, as the concepts' comments describe it.
class counted_sink {
public:
    static constexpr auto wants = counted_segment::wants;

    explicit counted_sink(counted_output& to) noexcept : to_{&to}, all_{to, {}} {}

    typemesh::error begin(typemesh::mesh_size exact) noexcept
    {
        to_->expect(exact);
        all_ = {*to_, {0, static_cast<std::uint32_t>(exact.vertices), 0, static_cast<std::uint32_t>(exact.indices())}};
        return {};
    }
    typemesh::error begin_chunks(typemesh::mesh_size exact, std::uint32_t) noexcept { return begin(exact); }
    [[nodiscard]] counted_segment subrange(typemesh::mesh_range range) const noexcept { return {*to_, range}; }
    void vertex(const typemesh::surface_point<wants>& s) noexcept { all_.vertex(s); }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept { all_.triangle(a, b, c); }
    void end() noexcept {}

private:
    counted_output* to_;
    counted_segment all_;
};
static_assert(typemesh::chunked_sink<counted_sink>);

}  // namespace test
