// SPDX-License-Identifier: MIT
#include "write_3mf.hpp"

#ifdef TEXT_TO_MESH_LIB3MF

#include "byte_writer.hpp"
#include "part_colours.hpp"
#include "well_formed.hpp"

#include <Model/COM/NMR_DLLInterfaces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace text_to_mesh {
namespace {

/// One of lib3mf's objects, let go at the end.
template <class T>
struct held {
    T* object = nullptr;

    held() = default;
    held(const held&) = delete;
    held& operator=(const held&) = delete;
    ~held()
    {
        if (object != nullptr) NMR::lib3mf_release(object);
    }
};

/// The file in memory. lib3mf goes back to write the sizes of what it has packed.
struct memory_file {
    std::vector<unsigned char> bytes;
    std::size_t at = 0;

    /// Both give 0, as lib3mf wants.
    static DWORD write(BYTE* data, DWORD count, void* file)
    {
        auto& to = *static_cast<memory_file*>(file);
        to.bytes.resize((std::max)(to.bytes.size(), to.at + count));
        if (count != 0) std::memcpy(to.bytes.data() + to.at, data, count);
        to.at += count;
        return 0;
    }
    static DWORD seek(ULONG64 place, void* file)
    {
        static_cast<memory_file*>(file)->at = static_cast<std::size_t>(place);
        return 0;
    }
};

/// The materials, one per part, and which of them each triangle has. An object whose triangles have some must have a
/// default too.
bool paint(NMR::PLib3MFModel* file, NMR::PLib3MFModelMeshObject* object, const model& mesh)
{
    held<NMR::PLib3MFModelBaseMaterial> materials;
    held<NMR::PLib3MFPropertyHandler> properties;
    DWORD group = 0;
    if (NMR::lib3mf_model_addbasematerialgroup(file, &materials.object) != LIB3MF_OK ||
        NMR::lib3mf_basematerial_getresourceid(materials.object, &group) != LIB3MF_OK ||
        NMR::lib3mf_meshobject_createpropertyhandler(object, &properties.object) != LIB3MF_OK)
        return false;
    std::vector<DWORD> groups(mesh.indices.size() / 3, group), numbers(groups.size());
    for (const model::part& part : mesh.parts) {
        const rgb_colour colour = colour_of(part);
        const auto& rgb = colour.rgb;
        DWORD number = 0;
        if (NMR::lib3mf_basematerial_addmaterialutf8(materials.object, part.name.c_str(), rgb[0], rgb[1], rgb[2],
                                                     &number) != LIB3MF_OK ||
            NMR::lib3mf_basematerial_setdisplaycolorrgba(materials.object, number, rgb[0], rgb[1], rgb[2],
                                                         colour.alpha) != LIB3MF_OK)
            return false;
        std::fill_n(numbers.begin() + static_cast<std::ptrdiff_t>(part.first_index / 3), part.index_count / 3, number);
    }
    held<NMR::PLib3MFDefaultPropertyHandler> usual;
    return NMR::lib3mf_propertyhandler_setbasematerialarray(properties.object, groups.data(), numbers.data()) ==
               LIB3MF_OK &&
           NMR::lib3mf_object_createdefaultpropertyhandler(object, &usual.object) == LIB3MF_OK &&
           NMR::lib3mf_defaultpropertyhandler_setbasematerial(usual.object, group, 0) == LIB3MF_OK;
}

/// A coordinate as lib3mf writes it, in millionths of the file's unit.
std::int64_t written(float coordinate, double units) { return std::llround(double{coordinate} * units * 1e6); }

/// True where the six decimals that lib3mf writes keep the solid solid: it has a depth, and no two places become one.
/// `units` per millimetre.
bool holds(const model& mesh, double units)
{
    struct place {
        std::array<std::int64_t, 3> written;
        std::array<float, 3> exact;
    };
    std::vector<place> places;
    places.reserve(mesh.vertices.size());
    for (const model_vertex& v : mesh.vertices) {
        const auto& [x, y, z] = v.position;
        places.push_back({{written(x, units), written(y, units), written(z, units)}, {x, y, z}});
    }
    std::sort(places.begin(), places.end(), [](const place& a, const place& b) { return a.written < b.written; });
    for (std::size_t i = 1; i < places.size(); ++i)
        if (places[i].written == places[i - 1].written && places[i].exact != places[i - 1].exact) return false;
    return std::any_of(places.begin(), places.end(),
                       [&](const place& p) { return p.written[2] != places[0].written[2]; });
}

/// Millimetres unless only micrometres, a thousand of them, have the digits; 0 where these have not either.
double units_to_a_millimetre(const model& mesh)
{
    for (const double units : {1.0, 1000.0})
        if (holds(mesh, units)) return units;
    return 0.0;
}

/// One of a model's named solids, as a model of its own.
model solid_of(const model& mesh, unsigned solid)
{
    constexpr std::uint32_t none = 0xFFFF'FFFFu;
    model made;
    std::vector<std::uint32_t> number(mesh.vertices.size(), none);
    for (const model::part& part : mesh.parts) {
        if (part.solid != solid) continue;
        made.parts.push_back(part);
        made.parts.back().first_index = made.indices.size();
        for (std::size_t i = part.first_index; i < part.first_index + part.index_count; ++i) {
            std::uint32_t& n = number[mesh.indices[i]];
            if (n == none) {
                n = static_cast<std::uint32_t>(made.vertices.size());
                made.vertices.push_back(mesh.vertices[mesh.indices[i]]);
            }
            made.indices.push_back(n);
        }
    }
    return made;
}

/// Adds a mesh to a file.
bool add_mesh(NMR::PLib3MFModel* file, const model& mesh, double units, const std::string& name,
              held<NMR::PLib3MFModelMeshObject>& object)
{
    static_assert(sizeof(NMR::MODELMESHVERTEX) == 12 && sizeof(NMR::MODELMESHTRIANGLE) == 12);
    std::vector<NMR::MODELMESHVERTEX> vertices(mesh.vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        float at[3];
        for (std::size_t c = 0; c < 3; ++c) at[c] = static_cast<float>(double{mesh.vertices[i].position[c]} * units);
        std::memcpy(&vertices[i], at, sizeof vertices[i]);
    }
    std::vector<NMR::MODELMESHTRIANGLE> triangles(mesh.indices.size() / 3);
    if (!triangles.empty()) std::memcpy(triangles.data(), mesh.indices.data(), triangles.size() * sizeof triangles[0]);

    if (NMR::lib3mf_model_addmeshobject(file, &object.object) != LIB3MF_OK) return false;
    if (NMR::lib3mf_object_setnameutf8(object.object, name.c_str()) != LIB3MF_OK) return false;
    if (NMR::lib3mf_meshobject_setgeometry(object.object, vertices.data(), static_cast<DWORD>(vertices.size()),
                                           triangles.data(), static_cast<DWORD>(triangles.size())) != LIB3MF_OK)
        return false;
    return mesh.parts.empty() || paint(file, object.object, mesh);
}

/// Adds the named solids of a model, as the components of one object, which slicers read as its parts.
bool add_solids(NMR::PLib3MFModel* file, const model& mesh, double units, const std::string& name)
{
    held<NMR::PLib3MFModelComponentsObject> whole;
    held<NMR::PLib3MFModelBuildItem> item;
    std::vector<held<NMR::PLib3MFModelMeshObject>> objects(mesh.solid_names.size());
    std::vector<held<NMR::PLib3MFModelComponent>> components(objects.size());
    for (std::size_t k = 0; k < objects.size(); ++k)
        if (!add_mesh(file, solid_of(mesh, static_cast<unsigned>(k)), units, mesh.solid_names[k], objects[k]))
            return false;
    if (NMR::lib3mf_model_addcomponentsobject(file, &whole.object) != LIB3MF_OK ||
        NMR::lib3mf_object_setnameutf8(whole.object, name.c_str()) != LIB3MF_OK)
        return false;
    for (std::size_t k = 0; k < objects.size(); ++k)
        if (NMR::lib3mf_componentsobject_addcomponent(whole.object, objects[k].object, nullptr,
                                                      &components[k].object) != LIB3MF_OK)
            return false;
    return NMR::lib3mf_model_addbuilditem(file, whole.object, nullptr, &item.object) == LIB3MF_OK;
}

bool make(const model& mesh, double units, memory_file& out)
{
    held<NMR::PLib3MFModel> file;
    held<NMR::PLib3MFModelMeshObject> object;
    held<NMR::PLib3MFModelBuildItem> item;
    held<NMR::PLib3MFModelWriter> writer;
    const std::string name = mesh.name.empty() ? "text" : well_formed(one_line(mesh.name));
    if (NMR::lib3mf_createmodel(&file.object) != LIB3MF_OK) return false;
    const auto unit = units == 1.0 ? NMR::MODELUNIT_MILLIMETER : NMR::MODELUNIT_MICROMETER;
    if (NMR::lib3mf_model_setunit(file.object, unit) != LIB3MF_OK) return false;
    if (!mesh.solid_names.empty()) {
        if (!add_solids(file.object, mesh, units, name)) return false;
    } else if (!add_mesh(file.object, mesh, units, name, object) ||
               NMR::lib3mf_model_addbuilditem(file.object, object.object, nullptr, &item.object) != LIB3MF_OK) {
        return false;
    }
    if (NMR::lib3mf_model_querywriter(file.object, "3mf", &writer.object) != LIB3MF_OK) return false;
    return NMR::lib3mf_writer_writetocallback(writer.object, reinterpret_cast<void*>(&memory_file::write),
                                              reinterpret_cast<void*>(&memory_file::seek), &out) == LIB3MF_OK;
}

}  // namespace

std::string write_3mf(const model& mesh, const std::string& path, file_set& files)
{
    memory_file file;
    const double units = mesh.vertices.empty() ? 1.0 : units_to_a_millimetre(mesh);
    if (units == 0.0)
        return path +
               " cannot be written: --depth or --size is too small for the digits of a 3MF file (six decimals of a "
               "micrometre).";
    if (!make(mesh, units, file)) return path + " cannot be written: lib3mf refused the mesh.";
    return files.add(path, file.bytes);
}

}  // namespace text_to_mesh

#else

namespace text_to_mesh {

std::string write_3mf(const model&, const std::string& path, file_set&)
{
    return path +
           " cannot be written: this program was built without lib3mf (Debian: lib3mf-dev); choose another format.";
}

}  // namespace text_to_mesh

#endif
