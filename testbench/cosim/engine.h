#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "datapath/error.h"
#include "datapath/profile.h"
#include "datapath/unit_desc.h"
#include "tlm/engine.h"

namespace repousse::cosim {

/// A summed-area table and its shape: (width + 1) entries a row.
struct Table {
    int width = 0;
    int height = 0;
    std::vector<uint64_t> entries;
};

/// An engine's shared object, opened for as long as this exists; see tlm/engine.h.
class Engine {
public:
    /// Opens a shared object and checks that it is an engine of this interface's version, for this
    /// unit, with this many words. Only units with vector ports need the profile for that.
    static Result<Engine> open(const std::filesystem::path& path, const UnitDesc& desc,
                               const Profile& profile = {});

    const RepousseEngine& api() const { return *api_; }

private:
    Engine(std::shared_ptr<void> object, const RepousseEngine* api)
        : object_(std::move(object)), api_(api) {}

    std::shared_ptr<void> object_;
    const RepousseEngine* api_;
};

/// One simulated unit.
class EngineInstance {
public:
    explicit EngineInstance(const Engine& engine)
        : engine_(engine), instance_(engine.api().create(), engine.api().destroy) {}

    /// Loads registers and table; `table` (may be null) must stay alive.
    void configure(const std::vector<int64_t>& config, const Table* table, uint32_t latency);

    /// Runs a batch. Anything but kRepousseDone resets the unit.
    RepousseOutcome run(const RepousseBatch& batch);

    uint64_t cycle() const { return engine_.api().cycle(instance_.get()); }
    void reset() { engine_.api().reset(instance_.get()); }

private:
    Engine engine_;
    std::unique_ptr<void, void (*)(void*)> instance_;
};

/// What an outcome means, in words.
const char* outcome_text(RepousseOutcome outcome);

/// A batch with all paces full and no times, to be filled in; `out` has room for a beat an item.
RepousseBatch plain_batch(uint64_t count, const int64_t* in, int64_t* out);

}  // namespace repousse::cosim
