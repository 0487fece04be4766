// SPDX-License-Identifier: MIT
//
// What the peers' meshes are worth: the same measure for all, typemesh among them, by the font's own curves.
//
//     judge [ascii] FILE.meshes...          a row "judged" for each file (see ../README.md); of ASCII alone, if asked for
//
// characters   of the set, those that the font has
// lost         those that the peer does not mesh
// wrong area   the triangles of a cap cover another area than the non-zero rule fills, by more than 1 % and what its chords explain
// open         an edge is not run through as often in one direction as in the other, points within 2e-6 em being one
// flipped      a triangle of a cap looks to the other side and is higher than 1e-6 em
// wrong        any of these
// chord        the largest distance of a boundary edge of a cap from the font's curves, in em; of edges on curves; the largest is of
//              meshes that are not wrong otherwise
// Triangles and vertices are sums over the characters. Of bevelled meshes only open edges are counted.

#include "glyph_curves.hpp"
#include "mesh_file.hpp"
#include "peer_program.hpp"

#include <map>

namespace {

using peers::place;
using corners = std::array<std::uint32_t, 3>;
using edges = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

/// A mesh whose points at one place are one.
struct welded_mesh {
    std::vector<std::array<double, 3>> points;
    std::vector<corners> triangles;

    explicit welded_mesh(const peers::mesh& m)
    {
        std::vector<std::uint32_t> number;
        for (std::size_t i = 0; i < m.points.size(); i += 3)
            number.push_back(weld({m.points[i], m.points[i + 1], m.points[i + 2]}));
        for (std::size_t i = 0; i + 2 < m.corners.size(); i += 3) {
            const corners t{number[m.corners[i]], number[m.corners[i + 1]], number[m.corners[i + 2]]};
            if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles.push_back(t);
        }
    }

    [[nodiscard]] bool is_open() const
    {
        edges balance;
        for (const corners& t : triangles)
            for (std::size_t i = 0, j = 2; i < 3; j = i++) balance[std::minmax(t[j], t[i])] += t[j] < t[i] ? 1 : -1;
        return std::any_of(balance.begin(), balance.end(), [](const auto& e) { return e.second != 0; });
    }

private:
    std::uint32_t weld(std::array<double, 3> p)
    {
        constexpr double near_by = 2e-6, cell = 4e-6;
        std::array<long, 3> at;
        for (std::size_t i = 0; i < 3; ++i) at[i] = long(std::floor(p[i] / cell));
        for (long x = -1; x <= 1; ++x)
            for (long y = -1; y <= 1; ++y)
                for (long z = -1; z <= 1; ++z) {
                    const auto found = cells_.find({at[0] + x, at[1] + y, at[2] + z});
                    if (found == cells_.end()) continue;
                    const auto& q = points[found->second];
                    if (std::abs(p[0] - q[0]) < near_by && std::abs(p[1] - q[1]) < near_by &&
                        std::abs(p[2] - q[2]) < near_by)
                        return found->second;
                }
        points.push_back(p);
        return cells_[at] = std::uint32_t(points.size() - 1);
    }

    std::map<std::array<long, 3>, std::uint32_t> cells_;
};

/// One of the two flat faces of a solid.
struct cap {
    double area = 0;
    double turned = 0;  ///< area of triangles, by their direction
    bool flipped = false;
    std::vector<std::pair<place, place>> boundary;

    cap(const welded_mesh& m, double height)
    {
        const auto flat = [&](std::uint32_t i) { return place{m.points[i][0], m.points[i][1]}; };
        const auto is_here = [&](std::uint32_t i) { return std::abs(m.points[i][2] - height) < 1e-4; };
        std::vector<std::pair<double, double>> areas;  // and longest sides
        edges uses;
        for (const corners& t : m.triangles) {
            if (!is_here(t[0]) || !is_here(t[1]) || !is_here(t[2])) continue;
            const place a = flat(t[1]) - flat(t[0]), b = flat(t[2]) - flat(t[0]);
            const double twice = a.x * b.y - a.y * b.x;
            areas.push_back({twice / 2, std::max({length(a), length(b), length(a - b)})});
            area += std::abs(twice) / 2, turned += twice / 2;
            for (std::size_t i = 0, j = 2; i < 3; j = i++) ++uses[std::minmax(t[j], t[i])];
        }
        for (const auto& [half, side] : areas) flipped = flipped || (turned > 0 ? -half : half) * 2 > 1e-6 * side;
        for (const auto& [edge, times] : uses)
            if (times == 1) boundary.push_back({flat(edge.first), flat(edge.second)});
    }
};

struct verdict {
    std::size_t characters = 0, lost = 0, area = 0, open = 0, flipped = 0, wrong = 0, triangles = 0, vertices = 0;
    std::vector<double> chords;
    double largest = 0;
};

/// How far each boundary edge of a cap is from the curves; edges on straight lines are left out.
std::vector<double> chord_errors(const cap& c, const peers::glyph_curves& curves)
{
    std::vector<double> errors;
    for (const auto& [a, b] : c.boundary) {
        double worst = 0;
        bool curved = false;
        for (int i = 0; i <= 8; ++i) {
            const auto nearest = curves.to(a + i / 8.0 * (b - a));
            worst = std::max(worst, nearest.distance);
            curved = curved || nearest.curved;
        }
        if (curved) errors.push_back(worst);
    }
    return errors;
}

void judge(const peers::mesh& given, peers::glyph_curves& curves, bool solid_only, verdict& v)
{
    const welded_mesh m(given);
    const bool open = m.is_open();
    v.open += open;
    v.triangles += given.triangles(), v.vertices += given.vertices();
    if (solid_only) {
        v.wrong += open;
        return;
    }
    double low = 1e30, high = -1e30;
    for (const auto& p : m.points) low = std::min(low, p[2]), high = std::max(high, p[2]);
    const cap front(m, high), back(m, low);
    curves.make_cells();
    std::vector<double> chords = chord_errors(front, curves);
    std::sort(chords.begin(), chords.end());
    const double usual = chords.empty() ? 0 : chords[chords.size() * 9 / 10], truth = curves.area();
    const double explained = 0.01 * truth + 2.0 / 3 * usual * curves.outline_length();
    const bool area = std::abs(front.area - truth) > explained || std::abs(back.area - truth) > explained;
    const bool flipped = front.flipped || back.flipped;
    v.area += area, v.flipped += flipped, v.wrong += area || flipped || open;
    v.chords.insert(v.chords.end(), chords.begin(), chords.end());
    if (!area && !flipped && !open && !chords.empty()) v.largest = std::max(v.largest, chords.back());
}

/// Peers measure their letters in sizes of their own and put them elsewhere: brings a mesh to where the outline is.
class fitting {
public:
    fitting(const peers::mesh_file& all, const peers::outline_font& font)
    {
        for (const auto& g : all.glyphs) {
            const auto [low, high] = box(g.mesh);
            if (g.character != 'H' || !(high.y > low.y)) continue;  // all straight: its height is exact
            const peers::glyph_curves c = font.curves_of(g.character);
            const double ratio = (c.high().y - c.low().y) / (high.y - low.y);
            if (std::abs(ratio - 1) > 0.03) scale_ = ratio;  // less is hinting
        }
    }

    void operator()(peers::mesh& m, const peers::glyph_curves& c) const
    {
        for (std::size_t i = 0; i < m.points.size(); ++i) m.points[i] = float(scale_ * double(m.points[i]));
        const auto [low, high] = box(m);
        const place off = 0.5 * (c.low() + c.high() - low - high);
        if (length(off) < 0.03) return;
        for (std::size_t i = 0; i < m.points.size(); i += 3) {
            m.points[i] += float(off.x);
            m.points[i + 1] += float(off.y);
        }
    }

private:
    static std::pair<place, place> box(const peers::mesh& m)
    {
        place low{1e30, 1e30}, high{-1e30, -1e30};
        for (const std::uint32_t c : m.corners) {
            const place p{double(m.points[3 * c]), double(m.points[3 * c + 1])};
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
        return {low, high};
    }

    double scale_ = 1;
};

bool judge_file(const char* path, bool ascii)
{
    peers::mesh_file all;
    if (!all.read(path)) return false;
    const peers::outline_font font(all.font);
    const fitting fit(all, font);
    std::map<std::uint32_t, peers::mesh*> meshes;
    for (auto& g : all.glyphs) meshes[g.character] = &g.mesh;
    verdict v;
    for (const std::uint32_t c : peers::judged_characters()) {
        if (ascii && c > 0x7E) break;
        peers::glyph_curves curves = font.curves_of(c);
        if (curves.pieces.empty()) continue;
        ++v.characters;
        const auto found = meshes.find(c);
        if (found == meshes.end() || found->second->corners.empty()) {
            ++v.lost, ++v.wrong;
            continue;
        }
        fit(*found->second, curves);
        judge(*found->second, curves, all.setting.find("bevelled") != std::string::npos, v);
    }
    std::sort(v.chords.begin(), v.chords.end());
    const double usual = v.chords.empty() ? 0 : v.chords[v.chords.size() * 9 / 10];
    const std::string font_file = all.font.substr(all.font.rfind('/') + 1);
    std::printf("judged\t%s\t%s\t%s\t%zu\t%zu\t%zu\t%zu\t%zu\t%zu\t", all.peer.c_str(), all.setting.c_str(),
                font_file.c_str(), v.characters, v.lost, v.area, v.open, v.flipped, v.wrong);
    v.chords.empty() ? std::printf("-\t-") : std::printf("%.3g\t%.3g", usual, v.largest);
    std::printf("\t%zu\t%zu\n", v.triangles, v.vertices);
    std::fflush(stdout);
    return true;
}

}  // namespace

int main(int argc, char** argv)
{
    const bool ascii = argc > 1 && std::strcmp(argv[1], "ascii") == 0;
    std::printf(
        "columns\tjudged\tpeer\tsetting\tfont\tcharacters\tlost\tarea\topen\tflipped\twrong\tchord_p90_em\tchord_"
        "largest_em\t"
        "triangles\tvertices\n");
    for (int i = ascii ? 2 : 1; i < argc; ++i)
        if (!judge_file(argv[i], ascii)) std::printf("skipped\t%s\tits meshes are not whole\n", argv[i]);
}
