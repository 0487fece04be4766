// SPDX-License-Identifier: MIT
//
// Draws letters that move, frame by frame, with the rasteriser of text_to_mesh: see make.sh.
//
//     moving wave|ring|score|breathe FONT FOLDER      FOLDER/00.ppm, 01.ppm, ...

#include "model.hpp"
#include "picture/picture.hpp"

#include <typemesh/adapt/harfbuzz_axis.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/morph/axis_morph.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

using namespace typemesh;

template <>
struct typemesh::vertex_traits<text_to_mesh::model_vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv;
    text_to_mesh::model_vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {{s.position.x, s.position.y, s.position.z}, {s.normal.x, s.normal.y, s.normal.z}, {s.uv.x, s.uv.y}};
    }
};

namespace {

constexpr double whole_turn = 6.283185307179586;
using plan_type = text_plan<bevelled>;

/// Letters stand around an upright axis.
struct ring {
    double turns;

    affine3 operator()(const letter_place& l) const noexcept
    {
        const double around = static_cast<double>(l.whole.extent.x) + 0.35, radius = around / whole_turn;
        const vec3 p = l.letter.pivot;
        const affine3 in_front = shifted({-p.x, 0.0f, static_cast<float>(radius)});
        return turned(l.frame.up, whole_turn * (static_cast<double>(p.x) / around + turns)) * in_front;
    }
};

/// As examples/15_rolling_score.cpp has it.
struct wheels {
    double score;

    affine3 operator()(const letter_place& l) const noexcept
    {
        const double digit = l.index - l.word.first;
        double below = std::fmod(digit - turn(l.words - 1 - l.letter.word) + 20.0, 10.0);
        if (below > 5.0) below -= 10.0;
        constexpr float radius = 1.4f;
        if (std::fabs(below) > 1.8) return hidden_at({0.8f * static_cast<float>(l.letter.word), 0.0f, -radius});
        const affine3 on_wheel = shifted({0.8f * static_cast<float>(l.letter.word) - l.letter.pivot.x,
                                          -l.letter.pivot.y, radius - l.letter.pivot.z});
        return shifted({0.0f, 0.0f, -radius}) * turned(l.frame.right, whole_turn * 0.1 * below) * on_wheel;
    }
    [[nodiscard]] double turn(std::uint32_t wheel) const noexcept
    {
        double gone = score;
        for (std::uint32_t i = 0; i < wheel; ++i) {
            const double tens = std::floor(gone / 10.0), over = gone - 10.0 * tens - 9.0;
            gone = tens + (over > 0.0 ? over : 0.0);
        }
        return std::fmod(gone, 10.0);
    }
};

std::string file_of(const std::string& folder, int frame)
{
    return folder + "/" + (frame < 10 ? "0" : "") + std::to_string(frame) + ".ppm";
}

/// A mesh, in a view that holds a box.
bool draw_mesh(text_to_mesh::model& mesh, const bounds3& box, float yaw, float pitch, const std::string& file)
{
    for (unsigned corner = 0; corner < 8; ++corner) {  // triangles without area hold the view
        const auto number = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back({{(corner & 1) != 0 ? box.high.x : box.low.x, (corner & 2) != 0 ? box.high.y : box.low.y,
                                  (corner & 4) != 0 ? box.high.z : box.low.z},
                                 {0.0f, 0.0f, 1.0f},
                                 {0.0f, 0.0f}});
        for (int i = 0; i < 3; ++i) mesh.indices.push_back(number);
        mesh.parts.back().index_count += 3;
    }
    text_to_mesh::picture_options look;
    look.width = 640;
    look.height = 300;
    look.yaw = yaw;
    look.pitch = pitch;
    int width = 0, height = 0;
    const auto pixels = text_to_mesh::draw(mesh, {}, look, width, height);
    std::FILE* out = std::fopen(file.c_str(), "wb");
    if (out == nullptr) return false;
    std::fprintf(out, "P6 %d %d 255\n", width, height);
    std::fwrite(pixels.data(), 1, pixels.size(), out);
    return std::fclose(out) == 0;
}

/// The frame of a plan whose letters move, in a view that holds a box.
template <class Motion>
bool draw_frame(const plan_type& plan, const Motion& motion, const bounds3& box, float yaw, float pitch,
                const std::string& file)
{
    text_to_mesh::model mesh;
    constexpr const char* names[] = {"front", "back", "side", "front_bevel", "back_bevel"};
    if (!plan.write(into(mesh.vertices, mesh.indices), motion)) return false;
    for (const part p : plan.parts())
        mesh.parts.push_back({names[static_cast<std::size_t>(p)], plan.range(p).first_index, plan.range(p).index_count});
    return draw_mesh(mesh, box, yaw, pitch, file);
}

/// All frames: motion_at(0) to motion_at(1), the latter not drawn.
template <class At>
bool draw_frames(const plan_type& plan, int frames, float yaw, float pitch, const std::string& folder, const At& motion_at)
{
    bounds3 box = plan.moved_bounds(motion_at(0.0));
    for (int i = 1; i < frames; ++i) {
        const bounds3 one = plan.moved_bounds(motion_at(static_cast<double>(i) / frames));
        box.add(one.low);
        box.add(one.high);
    }
    for (int i = 0; i < frames; ++i) {
        const std::string file = file_of(folder, i);
        if (!draw_frame(plan, motion_at(static_cast<double>(i) / frames), box, yaw, pitch, file)) return false;
    }
    return true;
}

/// A word whose weight grows and falls, with the same triangles throughout.
bool draw_breath(harfbuzz_font& font, int frames, const std::string& folder)
{
    auto weight = harfbuzz_axis::open(font, "wght");
    if (!weight) return false;
    axis_morph morph{*weight};
    auto plan = morph.plan("breathe", {.tolerance = 1.0 / 400.0, .depth = 0.16f});
    if (!plan) return false;
    std::vector<text_to_mesh::model> meshes(static_cast<std::size_t>(frames));
    bounds3 box;
    for (int i = 0; i < frames; ++i) {
        text_to_mesh::model& mesh = meshes[static_cast<std::size_t>(i)];
        const double breath = 0.5 - 0.5 * std::cos(whole_turn * i / frames);
        const double at = weight->coordinate(weight->low() + breath * (weight->high() - weight->low()));
        const auto make = [](const surface_point<attribute::position | attribute::normal>& v) noexcept {
            return text_to_mesh::model_vertex{{v.position.x, v.position.y, v.position.z}, {v.normal.x, v.normal.y, v.normal.z}, {}};
        };
        if (!plan->write_at(at, into(mesh.vertices, mesh.indices, make))) return false;
        mesh.parts.push_back({"front", 0, static_cast<std::uint32_t>(mesh.indices.size())});
        float low = 1e9f, high = -1e9f;
        for (const auto& v : mesh.vertices) low = (std::min)(low, v.position[0]), high = (std::max)(high, v.position[0]);
        for (auto& v : mesh.vertices) {
            v.position[0] -= 0.5f * (low + high);
            box.add({v.position[0], v.position[1], v.position[2]});
        }
    }
    for (int i = 0; i < frames; ++i)
        if (!draw_mesh(meshes[static_cast<std::size_t>(i)], box, -18.0f, 8.0f, file_of(folder, i))) return false;
    return true;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 4) return std::puts("usage: moving wave|ring|score|breathe FONT FOLDER"), 2;
    const std::string_view what = argv[1];
    const std::string folder = argv[3];
    auto font = harfbuzz_font::open(argv[2]);
    if (!font) return std::puts(font.error().message()), 1;
    if (what == "breathe") return draw_breath(*font, 30, folder) ? 0 : 1;
    text_mesher mesher{*font, bevelled{.width = 0.02f, .profile = round_profile()}};
    const std::string_view text = what == "wave"   ? "letters that wave"
                                  : what == "ring" ? "round and round and round and "
                                                   : "0123456789 0123456789 0123456789 0123456789";
    auto plan = mesher.plan(text, {.tolerance = 1.0 / 400.0});
    if (!plan) return std::puts(plan.error().message()), 1;
    const bool score = what == "score";
    if (auto found = plan->find_letters(text, {.pivot = score ? letter_pivot::centre : letter_pivot::baseline}); !found)
        return std::puts(found.error().message()), 1;
    bool done = false;
    if (what == "wave")
        done = draw_frames(*plan, 24, -18.0f, 10.0f, folder,
                           [](double t) { return letter_wave{.height = 0.16f, .letters = 9.0, .time = t}; });
    if (what == "ring") done = draw_frames(*plan, 30, 0.0f, 16.0f, folder, [](double t) { return ring{t / 3.0}; });
    if (score)
        done = draw_frames(*plan, 40, -16.0f, 6.0f, folder, [](double t) {
            const double eased = t < 0.8 ? 0.5 - 0.5 * std::cos(whole_turn * 0.5 * t / 0.8) : 1.0;
            return wheels{1990.0 + 11.0 * eased};
        });
    return done ? 0 : 1;
}
