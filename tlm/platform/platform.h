#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "datapath/error.h"
#include "datapath/pipelines/adaptive_counters.h"
#include "tlm/batch_time.h"
#include "tlm/config/device_config.h"
#include "tlm/platform/driver.h"

namespace repousse::shell {

/// What a run of the platform left behind.
struct PlatformResult {
    std::vector<DrawOutput> outputs;   ///< one for each draw
    std::vector<CounterRow> counters;  ///< of this run
    uint64_t cycles = 0;               ///< of the device, in this run
    std::vector<UnitBusy> busy;        ///< cycles by unit
    double simulated_ns = 0;           ///< upload and driver included
};

/// Choices of the platform around the device.
struct PlatformOptions {
    uint32_t output_capacity = 1 << 12;  ///< triangles, and fine vertices, in an output buffer
    bool allow_dmi = true;               ///< of the memory
    double memory_latency_ns = 50.0;     ///< a transaction
    double quantum_ns = 10000.0;         ///< of temporal decoupling
};

/// Our own platform: a driver and the device on a bus with a memory, at level lt.
///
/// The SystemC kernel elaborates once a process, so a process has one platform; it may run any
/// number of times. Each run starts with the device's reset, so runs do not know of each other.
class Platform {
public:
    /// Elaborates. `largest` sizes the memory: every draw that will be run must fit what these
    /// draws need. Refused if the kernel has already started.
    static Result<Platform> create(const DeviceConfig& config, const std::vector<Draw>& largest,
                                   const PlatformOptions& options = {});
    Platform(Platform&&) noexcept;
    ~Platform();

    /// Plays the draws one after the other.
    Result<PlatformResult> run(const std::vector<Draw>& draws);

private:
    struct Modules;
    explicit Platform(std::unique_ptr<Modules> modules);

    std::unique_ptr<Modules> modules_;
};

}  // namespace repousse::shell
