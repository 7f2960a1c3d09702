#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "datapath/error.h"
#include "datapath/profile.h"
#include "testbench/host/map/height_map.h"
#include "testbench/host/mesh/mesh.h"
#include "testbench/host/scene/scene.h"
#include "testbench/host/view/render_mesh.h"

namespace repousse::study {

/// What an object turned into.
struct RunSurface {
    host::RenderMesh view;           ///< every vertex once, in world units
    std::size_t base_triangles = 0;  ///< of the base mesh
    std::size_t whole = 0;           ///< base triangles that are one triangle still
    std::size_t rejected = 0;        ///< base triangles without output: not visible
    uint64_t displaced = 0;          ///< vertices that `displace` made
    uint64_t texel_reads = 0;        ///< texels that it read for them

    std::size_t triangles() const { return view.triangles.size(); }
    std::size_t vertices() const { return view.positions.size(); }
};

/// A scene, loaded once and run through the bare units at the default profile, bit-accurate, as
/// often as a study alters it: the same triangles as `repousse sim` makes.
class SceneRun {
public:
    /// Reads a scene file and the meshes and maps it names; image files are refused.
    static Result<SceneRun> open(const std::string& scene_file);

    /// The same for a scene that is read already.
    static Result<SceneRun> load(host::Scene scene);

    /// The scene. Camera, viewport and the settings of methods may be altered between runs; what
    /// meshes and maps are made of has no effect any more.
    host::Scene scene;

    /// An object's displacement map; may be altered between runs.
    host::HeightMap& map(std::size_t object) { return maps_[object]; }
    const host::HeightMap& map(std::size_t object) const { return maps_[object]; }

    /// An object's base mesh.
    const host::Mesh& mesh(std::size_t object) const { return meshes_[object]; }

    /// What an object's map is read from: its file's name without folders, or what stands in for
    /// an absent one.
    std::string source(std::size_t object) const;

    /// Runs an object under the scene's camera. Errors: settings that the profile cannot hold.
    Result<RunSurface> run(std::size_t object) const;

private:
    Profile profile_;
    std::vector<host::Mesh> meshes_;
    std::vector<host::HeightMap> maps_;
};

}  // namespace repousse::study
