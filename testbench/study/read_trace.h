#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "datapath/error.h"
#include "datapath/items.h"
#include "datapath/texel_port.h"
#include "datapath/units/triangle_stack.h"

namespace repousse::study {

/// Whether a context comes to a triangle before it comes to another one: base triangles in turn, of
/// each the parts in the order of the stack. A triangle comes before its own parts.
bool comes_before(const Path& a, const Path& b, StackOrder order);

/// The reads of one unit, as they come.
class ReadTrace final : public TexelPort {
public:
    void read(uint32_t address) override { addresses_.push_back(address); }

    /// What is read from now on belongs to the triangle at `path`.
    void begin(const Path& path) { parts_.push_back({path, addresses_.size()}); }

    /// The addresses as they came.
    const std::vector<uint32_t>& addresses() const { return addresses_; }

    /// The addresses in the order in which one context reads them. Every read must belong to a
    /// triangle; those of a triangle stay in the order in which they came.
    std::vector<uint32_t> in_order(StackOrder order) const;

private:
    struct Part {
        Path path;
        std::size_t from;
    };
    std::vector<uint32_t> addresses_;
    std::vector<Part> parts_;
};

/// What a unit reads in a scene, in architectural order: one list of addresses an object, since
/// every object has tables of its own and its caches begin empty.
struct UnitReads {
    std::string unit;
    std::vector<std::vector<uint32_t>> objects;

    uint64_t count() const;
};

/// The reads of a scene's map-reading units.
struct SceneReads {
    std::string scene;  ///< the file's name without folder and end
    bool adaptive = false;
    bool eager = false;
    std::string source;      ///< of the first object's map, in words
    uint64_t triangles = 0;  ///< that came out
    std::vector<UnitReads> units;
};

/// Runs a scene file's objects through the bare units with one context, bit-accurate, at the
/// scene's profile. `eager` says how the tests of adaptive objects run, whatever the scene asks
/// for. Errors: those of reading the scene, and settings that the profile cannot hold.
Result<SceneReads> scene_reads(const std::string& scene_file, bool eager);

}  // namespace repousse::study
