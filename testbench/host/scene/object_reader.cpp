#include "testbench/host/scene/object_reader.h"

#include "datapath/units/shade_desc.h"
#include "testbench/host/files.h"

namespace repousse::host {
namespace {

constexpr double kWorldLimit = 1e6;  // world units; positions beyond lose the device's fraction

MeshSource read_mesh_source(const TomlValue& table, ReadContext& context) {
    TableReader reader(table, "object.mesh", context);
    MeshSource mesh;
    mesh.mark = reader.mark();
    mesh.turn_deg = reader.number("turn_deg", 0.0, -360.0, 360.0);
    mesh.translation = reader.vector3("translation", mesh.translation, -kWorldLimit, kWorldLimit);
    if (reader.has("file")) {
        mesh.kind = MeshKind::File;
        mesh.mark = reader.mark("file");
        const std::string file = reader.text("file", "");
        const std::string extension = extension_of(file);
        if (extension != ".obj" && extension != ".off" && extension != ".ply") {
            reader.fail("file", "mesh file \"" + file + "\" is of an unknown type",
                        "a name that ends in .obj, .off or .ply");
        }
        mesh.file = resolve_file(file, context.folder);
        if (mesh.file.empty()) {
            reader.fail("file", "mesh file \"" + file + "\" does not exist",
                        "a file beside the scene or below the working directory");
        }
        mesh.projection = static_cast<UvProjection>(
            reader.choice("projection", {"none", "planar", "spherical", "cylindrical"}, 0));
        reader.finish();
        return mesh;
    }
    reader.require("kind", "\"grid\", \"cylinder\" or \"icosphere\", or file = \"...\"");
    const int kind = reader.choice("kind", {"grid", "cylinder", "icosphere"}, 0);
    if (kind == 0) {
        mesh.kind = MeshKind::Grid;
        const std::vector<int> quads = reader.integers("quads", 2, 1, 4096);
        if (!quads.empty()) mesh.columns = quads[0], mesh.rows = quads[1];
        mesh.size = reader.vector2("size", {1.0, 1.0}, 1e-6, kWorldLimit);
    } else if (kind == 1) {
        mesh.kind = MeshKind::Cylinder;
        mesh.columns = reader.integer("segments", 12, 3, 4096);
        mesh.rows = reader.integer("rings", 4, 1, 4096);
        mesh.radius = reader.number("radius", 1.0, 1e-6, kWorldLimit);
        mesh.height = reader.number("height", 2.0, 1e-6, kWorldLimit);
    } else {
        mesh.kind = MeshKind::Icosphere;
        mesh.subdivisions = reader.integer("subdivisions", 2, 0, 8);
        mesh.radius = reader.number("radius", 1.0, 1e-6, kWorldLimit);
    }
    reader.finish();
    return mesh;
}

Material read_material(const TomlValue& table, ReadContext& context) {
    TableReader reader(table, "object.shade", context);
    Material material;
    material.mark = reader.mark();
    material.ambient = reader.vector3("ambient", material.ambient, 0.0, 1.0);
    material.diffuse = reader.vector3("diffuse", material.diffuse, 0.0, 1.0);
    material.specular = reader.vector3("specular", material.specular, 0.0, 1.0);
    material.shininess =
        reader.integer("shininess", material.shininess, 1, (1 << kShininessBits) - 1);
    material.two_sided = reader.boolean("two_sided", material.two_sided);
    reader.finish();
    return material;
}

}  // namespace

Object read_object(const TomlValue& table, int index, ReadContext& context) {
    TableReader reader(table, "object", context);
    Object object;
    object.mark = reader.mark();
    object.name = reader.text("name", "object" + std::to_string(index + 1));
    if (object.name.empty()) reader.fail("name", "object.name is empty", "a name");
    reader.require("mesh", "a table [object.mesh]");
    if (const TomlValue* mesh = reader.table("mesh"))
        object.mesh = read_mesh_source(*mesh, context);
    if (const TomlValue* map = reader.table("map")) object.map = read_map_source(*map, context);
    read_method(reader, object, context);
    if (const TomlValue* bump = reader.table("bump")) {
        object.bump = true;
        TableReader(*bump, "object.bump", context).finish();
    }
    if (const TomlValue* shade = reader.table("shade")) {
        object.shade = read_material(*shade, context);
    }
    reader.finish();
    return object;
}

}  // namespace repousse::host
