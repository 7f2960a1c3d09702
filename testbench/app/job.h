#pragma once

#include <functional>
#include <string>
#include <vector>

#include "datapath/error.h"
#include "datapath/profile.h"
#include "testbench/host/draw.h"
#include "testbench/host/map/height_map.h"
#include "testbench/host/mesh/mesh.h"
#include "testbench/host/mesh/mesh_check.h"
#include "testbench/host/scene/scene.h"
#include "tlm/config/device_config.h"

namespace repousse::app {

/// An object of the scene with its files read.
struct LoadedObject {
    const host::Object* object = nullptr;
    host::Mesh mesh;
    host::HeightMap map;
    host::MeshDiagnosis diagnosis;
};

/// A scene that is ready to run: read, validated, and reduced to the device it needs.
struct Job {
    host::Scene scene;
    std::string profile_name;
    Profile profile;
    std::vector<LoadedObject> objects;
    DeviceConfig needed;             ///< what the scene calls for
    DeviceConfig device;             ///< what is built: that, or more on request
    std::vector<std::string> notes;  ///< what a user should know but need not mend

    /// How object i is tessellated; it refers to this job.
    host::DrawInputs inputs(std::size_t i) const;
};

/// Says what goes on while files are read.
using Progress = std::function<void(const std::string&)>;

/// Reads a scene and everything it names. `profile` overrides the scene's choice if not empty.
/// Errors name the scene line. The job must not be moved once `inputs` was called.
Result<Job> load_job(const std::string& scene_file, const std::string& profile,
                     const Progress& progress);

/// Why the scene needs a unit, or does without: for `info` and the report.
struct UnitReason {
    std::string_view unit;
    bool built = false;
    std::string why;
};
std::vector<UnitReason> explain_units(const Job& job);

}  // namespace repousse::app
