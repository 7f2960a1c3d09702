#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "datapath/error.h"
#include "datapath/pipelines/adaptive_counters.h"
#include "datapath/pipelines/contexts.h"
#include "datapath/pipelines/draw.h"
#include "tlm/config/device_config.h"

namespace repousse::shell {

/// What a run of the platform left behind.
struct PlatformResult {
    std::vector<std::vector<OutputTriangle<Fixed>>> triangles; ///< a list for each draw
    AdaptiveCounters counters;
    uint64_t cycles = 0;         ///< of the device
    double simulated_ns = 0;     ///< upload and driver included
};

/// Choices of the platform around the device.
struct PlatformOptions {
    uint32_t output_capacity = 1 << 14; ///< triangles in the output buffer
    bool allow_dmi = true;              ///< of the memory
    double memory_latency_ns = 50.0;    ///< a transaction
    double quantum_ns = 10000.0;        ///< of temporal decoupling
};

/// Our own platform: a driver and the device on a bus, with a memory that is just large enough.
/// Builds it, runs the draws at level lt and takes the results out. One elaboration a process, as
/// the SystemC kernel demands: a second call is refused.
Result<PlatformResult> run_platform(const DeviceConfig& config,
                                    const std::vector<AdaptiveDraw<Fixed>>& draws,
                                    const PlatformOptions& options = {});

}  // namespace repousse::shell
