// SPDX-License-Identifier: MIT
#include "mesh_facts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <utility>
#include <vector>

namespace text_to_mesh {
namespace {

using place = double[3];

/// Six times the volume between a triangle and a point.
double volume_below(const float* a, const float* b, const float* c, const float* from)
{
    place u, v, w;
    for (std::size_t i = 0; i < 3; ++i) {
        u[i] = double{a[i]} - double{from[i]};
        v[i] = double{b[i]} - double{from[i]};
        w[i] = double{c[i]} - double{from[i]};
    }
    return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

double volume_of(const model& mesh, std::size_t first_index, std::size_t count)
{
    if (count == 0) return 0.0;
    const auto at = [&](std::size_t i) { return mesh.vertices[mesh.indices[i]].position; };
    double sum = 0.0;
    for (std::size_t i = first_index; i + 2 < first_index + count; i += 3)
        sum += volume_below(at(i), at(i + 1), at(i + 2), at(first_index));
    return sum / 6.0;
}

/// A solid of one letter, wherever it stands.
mesh_facts facts_of(const model& mesh, const model::letter& l)
{
    mesh_facts f;
    for (std::size_t i = l.first_vertex; i < l.first_vertex + l.vertex_count; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double at = mesh.vertices[i].position[k];
            f.low[k] = i == l.first_vertex ? at : std::min(f.low[k], at);
            f.high[k] = i == l.first_vertex ? at : std::max(f.high[k], at);
        }
    }
    std::size_t first = mesh.indices.size(), last = 0;
    for (std::size_t p = l.first_part; p < l.first_part + l.part_count; ++p) {
        first = std::min(first, mesh.parts[p].first_index);
        last = std::max(last, mesh.parts[p].first_index + mesh.parts[p].index_count);
    }
    if (first < last) f.volume = volume_of(mesh, first, last - first);
    return f;
}

std::string written(const char* form, double value)
{
    char digits[64];
    std::snprintf(digits, sizeof digits, form, value);
    return digits;
}

/// A number of bounds: what is nothing but the rounding of the others is 0.
double clean(const mesh_facts& f, double value)
{
    double most = 0.0;
    for (std::size_t k = 0; k < 3; ++k) most = std::max(most, f.high[k] - f.low[k]);
    return std::fabs(value) < 1e-7 * most ? 0.0 : value;
}

}  // namespace

mesh_facts facts_of(const model& mesh)
{
    if (mesh.letters.empty()) {
        mesh_facts all = facts_of(mesh, {"", 0, mesh.vertices.size(), 0, mesh.parts.size()});
        all.volume = volume_of(mesh, 0, mesh.indices.size());
        return all;
    }
    std::vector<mesh_facts> letters;
    for (const model::letter& l : mesh.letters) letters.push_back(facts_of(mesh, l));
    mesh_facts all;
    for (const model::place& p : mesh.places) {
        const mesh_facts& l = letters[p.letter];
        const double c = p.right[0], s = p.right[1];
        const auto reach = [](double by, double low, double high) {
            return std::pair{std::min(by * low, by * high), std::max(by * low, by * high)};
        };
        const auto [x0, x1] = reach(c, l.low[0], l.high[0]);  // the box of the turned box
        const auto [x2, x3] = reach(-s, l.low[1], l.high[1]);
        const auto [y0, y1] = reach(s, l.low[0], l.high[0]);
        const auto [y2, y3] = reach(c, l.low[1], l.high[1]);
        const double lows[] = {x0 + x2, y0 + y2, l.low[2]}, highs[] = {x1 + x3, y1 + y3, l.high[2]};
        for (std::size_t k = 0; k < 3; ++k) {
            const double at = p.at[k], low = lows[k] + at, high = highs[k] + at;
            all.low[k] = &p == mesh.places.data() ? low : std::min(all.low[k], low);
            all.high[k] = &p == mesh.places.data() ? high : std::max(all.high[k], high);
        }
        all.volume += l.volume;
    }
    return all;
}

std::string size_in_words(const mesh_facts& facts, bool printed)
{
    std::string words;
    for (std::size_t k = 0; k < 3; ++k) words += (k > 0 ? " x " : "") + written("%.4g", facts.high[k] - facts.low[k]);
    return words + (printed ? " mm" : "");
}

std::string in_json(const mesh_facts& facts, bool printed)
{
    const auto three = [&](auto value) {
        std::string list;
        for (std::size_t k = 0; k < 3; ++k) list += (k > 0 ? "," : "[") + written("%.7g", value(k));
        return list + "]";
    };
    return ",\"bounds\":{\"low\":" + three([&](std::size_t k) { return clean(facts, facts.low[k]); }) +
           ",\"high\":" + three([&](std::size_t k) { return clean(facts, facts.high[k]); }) +
           "},\"size\":" + three([&](std::size_t k) { return facts.high[k] - facts.low[k]; }) + ",\"unit\":\"" +
           (printed ? "mm" : "unit") + "\",\"volume\":" + written("%.7g", facts.volume);
}

}  // namespace text_to_mesh
