// SPDX-License-Identifier: MIT
#include "write_morph.hpp"

#include "byte_writer.hpp"
#include "part_colours.hpp"
#include "picture/srgb.hpp"
#include "report.hpp"
#include "well_formed.hpp"

#include <typemesh/adapt/harfbuzz_axis.hpp>
#include <typemesh/morph/axis_morph.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include <tiny_gltf.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <map>
#include <sstream>
#include <vector>

namespace text_to_mesh {
namespace {

struct morph_vertex {
    typemesh::vec3 position, normal;
};

}  // namespace
}  // namespace text_to_mesh

template <>
struct typemesh::vertex_traits<text_to_mesh::morph_vertex> {
    static constexpr auto wants = attribute::position | attribute::normal;
    text_to_mesh::morph_vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {s.position, s.normal};
    }
};

namespace text_to_mesh {
namespace {

constexpr double seconds = 2.0;  // from one end of the axis to the other

/// A glTF file that grows.
class morph_file {
public:
    explicit morph_file(const std::string& name)
    {
        file_.asset.version = "2.0";
        file_.asset.generator = "typemesh";
        tinygltf::Node root;
        root.name = name;
        file_.nodes.push_back(std::move(root));
        tinygltf::Scene scene;
        scene.name = name;
        scene.nodes.push_back(0);
        file_.scenes.push_back(std::move(scene));
        file_.defaultScene = 0;
        animation_.name = "along the axis";
    }

    /// Vectors of three floats; with their bounds, as positions need them.
    int add_vectors(const std::vector<morph_vertex>& from, bool normals)
    {
        std::vector<double> low(3, 1e300), high(3, -1e300);
        const int view = begin_view(TINYGLTF_TARGET_ARRAY_BUFFER);
        for (const morph_vertex& v : from) {
            const typemesh::vec3& p = normals ? v.normal : v.position;
            const float all[] = {p.x, p.y, p.z};
            for (std::size_t k = 0; k < 3; ++k) {
                bytes_.f32(all[k]);
                low[k] = (std::min)(low[k], double{all[k]});
                high[k] = (std::max)(high[k], double{all[k]});
            }
        }
        const int made = end_view(view, from.size(), TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3);
        if (!normals) bound(made, low, high);
        return made;
    }
    int add_indices(const std::vector<std::uint32_t>& from, const typemesh::mesh_range& range)
    {
        const int view = begin_view(TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
        for (std::uint32_t i = 0; i < range.index_count; ++i) bytes_.u32(from[range.first_index + i]);
        return end_view(view, range.index_count, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR);
    }
    int add_numbers(const std::vector<float>& from, int type, bool bounded)
    {
        const int view = begin_view(0);
        for (const float f : from) bytes_.f32(f);
        const std::size_t width = type == TINYGLTF_TYPE_VEC3 ? 3 : 1;
        const int made = end_view(view, from.size() / width, TINYGLTF_COMPONENT_TYPE_FLOAT, type);
        if (bounded) bound(made, {double{from.front()}}, {double{from.back()}});
        return made;
    }

    int material(const std::string& name)
    {
        for (std::size_t i = 0; i < file_.materials.size(); ++i)
            if (file_.materials[i].name == name) return static_cast<int>(i);
        tinygltf::Material made;
        made.name = name;
        const auto colour = to_linear(colour_of(model::part{name, 0, 0}).rgb);
        made.pbrMetallicRoughness.baseColorFactor = {double{colour.x}, double{colour.y}, double{colour.z}, 1.0};
        made.pbrMetallicRoughness.metallicFactor = 0.0;
        made.pbrMetallicRoughness.roughnessFactor = 0.45;
        file_.materials.push_back(std::move(made));
        return static_cast<int>(file_.materials.size()) - 1;
    }

    void animate(int node, const char* path, const char* interpolation, int times, int values)
    {
        tinygltf::AnimationSampler sampler;
        sampler.input = times;
        sampler.output = values;
        sampler.interpolation = interpolation;
        animation_.samplers.push_back(std::move(sampler));
        tinygltf::AnimationChannel channel;
        channel.sampler = static_cast<int>(animation_.samplers.size()) - 1;
        channel.target_node = node;
        channel.target_path = path;
        animation_.channels.push_back(std::move(channel));
    }

    int add_node(tinygltf::Mesh mesh, bool shown)
    {
        tinygltf::Node node;
        node.name = mesh.name;
        node.mesh = static_cast<int>(file_.meshes.size());
        if (!shown) node.scale = {0.0, 0.0, 0.0};
        file_.meshes.push_back(std::move(mesh));
        file_.nodes.push_back(std::move(node));
        const int made = static_cast<int>(file_.nodes.size()) - 1;
        file_.nodes[0].children.push_back(made);
        return made;
    }

    /// The bytes of the file; empty if the library refuses it.
    std::string finish()
    {
        tinygltf::Buffer buffer;
        buffer.data = bytes_.take();
        file_.buffers.push_back(std::move(buffer));
        if (!animation_.channels.empty()) file_.animations.push_back(std::move(animation_));
        std::ostringstream stream;
        tinygltf::TinyGLTF writer;
        if (!writer.WriteGltfSceneToStream(&file_, stream, false, true) || !stream) return {};
        return stream.str();
    }

private:
    int begin_view(int target)
    {
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = bytes_.bytes().size();
        view.target = target;
        file_.bufferViews.push_back(std::move(view));
        return static_cast<int>(file_.bufferViews.size()) - 1;
    }
    int end_view(int view, std::size_t count, int component, int type)
    {
        tinygltf::BufferView& v = file_.bufferViews[static_cast<std::size_t>(view)];
        v.byteLength = bytes_.bytes().size() - v.byteOffset;
        tinygltf::Accessor accessor;
        accessor.bufferView = view;
        accessor.count = count;
        accessor.componentType = component;
        accessor.type = type;
        file_.accessors.push_back(std::move(accessor));
        return static_cast<int>(file_.accessors.size()) - 1;
    }
    void bound(int accessor, const std::vector<double>& low, const std::vector<double>& high)
    {
        tinygltf::Accessor& a = file_.accessors[static_cast<std::size_t>(accessor)];
        a.minValues = low;
        a.maxValues = high;
    }

    tinygltf::Model file_;
    tinygltf::Animation animation_;
    byte_writer bytes_;
};

/// The time at which the animation passes a coordinate on its way there.
float time_of(typemesh::axis_coordinate c, typemesh::axis_coordinate first, typemesh::axis_coordinate last)
{
    return static_cast<float>(seconds * static_cast<double>(c - first) / static_cast<double>(last - first));
}

/// One section: its mesh, its node, its share of the animation.
typemesh::result<void> add_section(morph_file& file, typemesh::morph_plan& plan, std::size_t s, double usual)
{
    using namespace typemesh;
    static constexpr const char* names[] = {"front", "back", "side"};
    const auto keys = plan.keys(s);
    std::vector<morph_vertex> vertices;
    std::vector<std::uint32_t> indices, none;
    if (const auto done = plan.write_base(s, into(vertices, indices)); !done) return done.error();
    tinygltf::Mesh mesh;
    mesh.name = "section_" + std::to_string(s);
    const int position = file.add_vectors(vertices, false), normal = file.add_vectors(vertices, true);
    std::vector<std::map<std::string, int>> targets;
    tinygltf::Value::Array target_names;
    for (std::size_t k = 1; k < keys.size(); ++k) {
        if (const auto done = plan.write_target(s, k, into(vertices, none)); !done) return done.error();
        targets.push_back(
            {{"POSITION", file.add_vectors(vertices, false)}, {"NORMAL", file.add_vectors(vertices, true)}});
        char name[32];
        std::snprintf(name, sizeof name, "%g", static_cast<double>(keys[k]) / 16384.0);
        target_names.emplace_back(std::string{name});
    }
    for (std::size_t p = 0; p < 3; ++p) {
        const mesh_range range = plan.range(s, static_cast<part>(p));
        if (range.index_count == 0) continue;
        tinygltf::Primitive primitive;
        primitive.mode = TINYGLTF_MODE_TRIANGLES;
        primitive.attributes = {{"POSITION", position}, {"NORMAL", normal}};
        primitive.indices = file.add_indices(indices, range);
        primitive.material = file.material(names[p]);
        primitive.targets = targets;
        mesh.primitives.push_back(std::move(primitive));
    }
    const bool shown = plan.section_at(usual) == s;
    if (!targets.empty()) {
        std::vector<float> weights(targets.size());
        if (shown)
            if (const auto done = plan.weights(usual, weights); !done) return done.error();
        mesh.weights.assign(weights.begin(), weights.end());
        mesh.extras =
            tinygltf::Value{tinygltf::Value::Object{{"targetNames", tinygltf::Value{std::move(target_names)}}}};
    }
    const int node = file.add_node(std::move(mesh), shown);

    const axis_coordinate first = plan.keys(0)[0], last = plan.keys(plan.section_count() - 1).back();
    const auto both_ways = [&](std::vector<float> times) {  // to the end of the axis, and back
        const std::vector<float> there = times;
        for (auto t = there.rbegin(); t != there.rend(); ++t)
            if (const float back = static_cast<float>(2.0 * seconds) - *t; back > times.back()) times.push_back(back);
        return times;
    };
    if (!targets.empty()) {
        std::vector<float> times, values;
        for (const axis_coordinate c : keys) times.push_back(time_of(c, first, last));
        times = both_ways(times);
        for (std::size_t i = 0; i < times.size(); ++i) {
            const std::size_t key = i < keys.size() ? i : times.size() - 1 - i;
            for (std::size_t k = 1; k < keys.size(); ++k) values.push_back(k == key ? 1.0f : 0.0f);
        }
        file.animate(node, "weights", "LINEAR", file.add_numbers(times, TINYGLTF_TYPE_SCALAR, true),
                     file.add_numbers(values, TINYGLTF_TYPE_SCALAR, false));
    }
    if (plan.section_count() > 1) {
        std::vector<float> times{0.0f}, values;
        for (std::size_t k = 0; k < plan.section_count(); ++k)
            if (k > 0) times.push_back(time_of(plan.keys(k)[0], first, last));
        const std::size_t there = times.size();
        for (std::size_t k = there; k-- > 1;) times.push_back(static_cast<float>(2.0 * seconds) - times[k]);
        for (std::size_t i = 0; i < times.size(); ++i) {
            const std::size_t shows = i < there ? i : 2 * there - 2 - i;
            for (int axis = 0; axis < 3; ++axis) values.push_back(shows == s ? 1.0f : 0.0f);
        }
        file.animate(node, "scale", "STEP", file.add_numbers(times, TINYGLTF_TYPE_SCALAR, true),
                     file.add_numbers(values, TINYGLTF_TYPE_VEC3, false));
    }
    return {};
}

}  // namespace

std::string write_morph(const options& o, const typemesh::harfbuzz_font& font, file_set& files, std::string& said)
{
    using namespace typemesh;
    char tag[5] = {};
    o.morph.axis.copy(tag, 4);
    auto axis = harfbuzz_axis::open(font, tag);
    if (!axis) return "--morph: " + in_words(axis.error());
    axis_morph morph{*axis};
    morph_options how;
    how.from = o.morph.from;
    how.to = o.morph.to;
    how.tolerance = o.tolerance;
    how.size = o.size;
    how.depth = o.depth;
    how.crease_degrees = o.crease.value_or(15.0f);
    how.shape = {.direction = o.direction, .language = o.language, .script = o.script, .features = o.features};
    how.shape.letter_spacing = o.letter_spacing;
    how.layout = o.lines;
    auto plan = morph.plan(text_view{o.text}, how);
    if (!plan && plan.error() == error::bad_option && std::string{plan.error().option} == "from")
        return "--morph: that part of the axis is empty: its ends are " + std::to_string(axis->low()) + " and " +
               std::to_string(axis->high()) + ".";
    if (!plan) return in_words(plan.error());

    const morph_report& r = plan->report();
    const auto warn = [&o](std::uint32_t count, const char* what) {
        if (count != 0) std::fprintf(stderr, "%s%u %s\n", o.who.c_str(), count, what);
    };
    warn(r.missing, "characters are missing in the font.");
    warn(r.refused, "letters are not drawn in a part of the axis, because their contours cross there.");
    if (o.strict && r.missing + r.refused != 0) return "--strict: nothing is written.";

    morph_file file{o.text.empty() ? std::string{"text"} : well_formed(o.text)};
    const double usual = axis->coordinate(axis->usual());
    std::uint64_t triangles = 0, drawn = 0;
    std::size_t targets = 0;
    for (std::size_t s = 0; s < plan->section_count(); ++s) {
        if (plan->size(s).triangles == 0) continue;
        if (const auto done = add_section(file, *plan, s, usual); !done) return in_words(done.error());
        triangles = (std::max)(triangles, plan->size(s).triangles);
        targets += plan->keys(s).size() - 1;
        ++drawn;
    }
    if (drawn == 0) return "the text is blank: nothing is written.";
    const std::string bytes = file.finish();
    if (bytes.empty()) return o.output + " cannot be written: the glTF library refused the mesh.";
    said = o.output + ": " + std::to_string(triangles) + " triangles, " + std::to_string(targets) + " targets in " +
           std::to_string(drawn) + (drawn == 1 ? " section" : " sections") + "; " + std::to_string(r.letters) +
           " letters, " + std::to_string(r.overlapping) + " of overlapping solids, " + std::to_string(r.split) +
           " split, " + std::to_string(r.refused) + " refused";
    return files.add(o.output, {reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
}

}  // namespace text_to_mesh
