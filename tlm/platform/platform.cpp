#include "tlm/platform/platform.h"

#include <algorithm>
#include <systemc>
#include <tlm>

#include "datapath/pipelines/adaptive.h"
#include "tlm/memory/bus.h"
#include "tlm/memory/memory.h"
#include "tlm/platform/displacement_unit.h"
#include "tlm/platform/driver.h"

namespace repousse::shell {
namespace {

// The registers lie above any memory that 40 address bits reach.
constexpr uint64_t kDeviceBase = uint64_t(1) << 40;
constexpr uint64_t kDeviceSize = uint64_t(4) * kRegisterCount;

}  // namespace

struct Platform::Modules {
    Modules(const DeviceConfig& config, const AddressMap& map, const PlatformOptions& options)
        : memory("memory", map.memory_bytes,
                 sc_core::sc_time(options.memory_latency_ns, sc_core::SC_NS), options.allow_dmi),
          device("device", config),
          driver("driver", map) {
        bus.map(map.memory, map.memory_bytes);
        bus.map(map.device, kDeviceSize);
        bus.targets.bind(memory.socket);
        bus.targets.bind(device.registers);
        driver.port.socket.bind(bus.initiators);
        device.memory_port.socket.bind(bus.initiators);
        device.interrupt.bind(interrupt);
        driver.interrupt.bind(interrupt);
    }

    sc_core::sc_signal<bool> interrupt{"interrupt"};
    Bus bus{"bus"};
    Memory memory;
    DisplacementUnit device;
    Driver driver;
};

Platform::Platform(std::unique_ptr<Modules> modules) : modules_(std::move(modules)) {}
Platform::Platform(Platform&&) noexcept = default;
Platform::~Platform() = default;

Result<Platform> Platform::create(const DeviceConfig& config, const std::vector<Draw>& largest,
                                  const PlatformOptions& options) {
    if (sc_core::sc_get_status() != sc_core::SC_ELABORATION) {
        return Error{ErrorKind::Environment,
                     {},
                     "a second platform in one process",
                     "one elaboration a process, as the SystemC kernel demands",
                     {}};
    }
    if (config.contexts < 1 || config.contexts > static_cast<int>(kBatchTriangles)) {
        return Error{ErrorKind::Input,
                     "contexts",
                     std::to_string(config.contexts) + " is out of range",
                     "1 to " + std::to_string(kBatchTriangles),
                     {}};
    }
    AddressMap map;
    map.device = kDeviceBase;
    map.output_capacity = options.output_capacity;
    for (const Draw& draw : largest) {
        map.memory_bytes = std::max(map.memory_bytes, buffer_bytes(draw, options.output_capacity));
    }
    tlm::tlm_global_quantum::instance().set(sc_core::sc_time(options.quantum_ns, sc_core::SC_NS));
    return Platform(std::make_unique<Modules>(config, map, options));
}

// The kernel returns when nothing is left to happen: the driver has everything and sleeps.
Result<PlatformResult> Platform::run(const std::vector<Draw>& draws) {
    const sc_core::sc_time start(sc_core::sc_time_stamp());
    modules_->driver.start(draws);
    sc_core::sc_start();
    if (!modules_->driver.status()) return modules_->driver.status().error();
    PlatformResult result;
    result.outputs = modules_->driver.take_outputs();
    result.counters = modules_->device.counters();
    result.cycles = modules_->device.cycles();
    const BusyTable busy = modules_->device.busy();
    result.busy.assign(busy.rows().begin(), busy.rows().end());
    result.simulated_ns = (sc_core::sc_time_stamp() - start).to_seconds() * 1e9;
    return result;
}

}  // namespace repousse::shell
