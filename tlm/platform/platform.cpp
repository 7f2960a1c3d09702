#include "tlm/platform/platform.h"

#include <algorithm>

#include <systemc>
#include <tlm>

#include "tlm/memory/bus.h"
#include "tlm/memory/memory.h"
#include "tlm/platform/displacement_unit.h"
#include "tlm/platform/driver.h"

namespace repousse::shell {
namespace {

// The registers lie above any memory that 40 address bits reach.
constexpr uint64_t kDeviceBase = uint64_t(1) << 40;
constexpr uint64_t kDeviceSize = 4 * kRegisterCount;

class Platform : public sc_core::sc_module {
public:
    Platform(const sc_core::sc_module_name& name, const DeviceConfig& config,
             const std::vector<AdaptiveDraw<Fixed>>& draws, const AddressMap& map,
             const PlatformOptions& options)
        : sc_module(name),
          bus("bus"),
          memory("memory", map.memory_bytes,
                 sc_core::sc_time(options.memory_latency_ns, sc_core::SC_NS), options.allow_dmi),
          device("device", config),
          driver("driver", map, draws) {
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
    Bus bus;
    Memory memory;
    DisplacementUnit device;
    Driver driver;
};

}  // namespace

Result<PlatformResult> run_platform(const DeviceConfig& config,
                                    const std::vector<AdaptiveDraw<Fixed>>& draws,
                                    const PlatformOptions& options) {
    if (sc_core::sc_get_status() != sc_core::SC_ELABORATION) {
        return Error{ErrorKind::Environment, {}, "a second platform in one process", 
                     "one elaboration a process, as the SystemC kernel demands", {}};
    }
    AddressMap map;
    map.device = kDeviceBase;
    map.output_capacity = options.output_capacity;
    for (const AdaptiveDraw<Fixed>& draw : draws) {
        map.memory_bytes = std::max(map.memory_bytes, buffer_bytes(draw, options.output_capacity));
    }
    tlm::tlm_global_quantum::instance().set(sc_core::sc_time(options.quantum_ns, sc_core::SC_NS));
    Platform platform("platform", config, draws, map, options);
    sc_core::sc_start();

    if (!platform.driver.status()) return platform.driver.status().error();
    PlatformResult result;
    for (const Driver::Output& output : platform.driver.outputs()) {
        result.triangles.push_back(output.triangles);
    }
    result.counters = platform.device.counters();
    result.cycles = platform.device.cycles();
    result.simulated_ns = sc_core::sc_time_stamp().to_seconds() * 1e9;
    return result;
}

}  // namespace repousse::shell
