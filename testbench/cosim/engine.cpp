#include "testbench/cosim/engine.h"

#include <dlfcn.h>

#include <string>

#include "testbench/cosim/parameters.h"

namespace repousse::cosim {

Result<Engine> Engine::open(const std::filesystem::path& path, const UnitDesc& desc,
                            const Profile& profile) {
    const auto refuse = [&path](std::string what, std::string expected) {
        return Error{ErrorKind::Environment, path.string(), std::move(what), std::move(expected),
                     "rebuild it with: repousse cosim"};
    };
    // RTLD_LOCAL: two engines may hold two versions of the same simulator.
    const std::shared_ptr<void> object(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL), [](void* p) {
        if (p != nullptr) dlclose(p);
    });
    if (object == nullptr) return refuse(dlerror(), "a shared object");
    const auto function =
        reinterpret_cast<RepousseEngineFunction>(dlsym(object.get(), "repousse_engine"));
    if (function == nullptr) return refuse("no function repousse_engine", "an engine");
    const RepousseEngine* api = function();
    if (api->abi != kRepousseEngineAbi) {
        return refuse("engine interface " + std::to_string(api->abi),
                      std::to_string(kRepousseEngineAbi));
    }
    if (api->unit != desc.name) {
        return refuse("an engine of " + std::string(api->unit), std::string(desc.name));
    }
    if (api->configs != port_words(desc, PortKind::Config, profile).size() ||
        api->inputs != port_words(desc, PortKind::Input, profile).size() ||
        api->outputs != port_words(desc, PortKind::Output, profile).size() ||
        api->last != last_word(desc, profile)) {
        return refuse("other ports than the unit's description", std::string(desc.name) + "'s");
    }
    return Engine(object, api);
}

void EngineInstance::configure(const std::vector<int64_t>& config, const Table* table,
                               uint32_t latency) {
    RepousseTable memory{};
    if (table != nullptr) {
        memory = {table->entries.data(), table->entries.size(),
                  static_cast<uint64_t>(table->width) + 1, latency};
    }
    engine_.api().configure(instance_.get(), config.data(), &memory);
}

RepousseOutcome EngineInstance::run(const RepousseBatch& batch) {
    const auto outcome = static_cast<RepousseOutcome>(engine_.api().run(instance_.get(), &batch));
    if (outcome != kRepousseDone) reset();
    return outcome;
}

const char* outcome_text(RepousseOutcome outcome) {
    switch (outcome) {
        case kRepousseDone:
            return "done";
        case kRepousseStuck:
            return "the unit is stuck: nothing moved for 100,000 cycles";
        case kRepousseUnstable:
            return "a valid was withdrawn, or its data changed, while stalled";
        case kRepousseAddress:
            return "a read outside the table";
        case kRepousseRefused:
            return "the unit refused an answer of its read port";
        case kRepousseExcess:
            return "more beats came out than the transactions have";
    }
    return "an unknown outcome";
}

RepousseBatch plain_batch(uint64_t count, const int64_t* in, int64_t* out) {
    RepousseBatch batch{};
    batch.count = batch.capacity = count;
    batch.in = in;
    batch.out = out;
    batch.source = batch.sink = batch.requests = batch.responses = {100, 1};
    return batch;
}

}  // namespace repousse::cosim
