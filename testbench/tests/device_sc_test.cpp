// The DisplacementUnit in platforms of other shapes: two devices at once, memory that takes its
// DMI pointers back, frames that are aborted. Each case elaborates in a child process.

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>

#include "testbench/tests/support/platform_draws.h"
#include "testbench/tests/support/platform_run.h"
#include "testbench/tests/support/profiles.h"
#include "tlm/memory/bus.h"
#include "tlm/memory/memory.h"
#include "tlm/platform/displacement_unit.h"
#include "tlm/platform/driver.h"

namespace repousse {
namespace {

using shell::Draw;
using Draws = std::vector<Draw>;

constexpr uint64_t kMemoryBytes = 1 << 20;  // of each device
constexpr uint64_t kDevices = uint64_t(1) << 40;
constexpr uint64_t kDeviceBytes = 4096;

sc_core::sc_time ns(double count) { return {count, sc_core::SC_NS}; }

/// Another master on the bus.
struct Poker : sc_core::sc_module {
    shell::MemoryPort port{"port"};
    std::function<void(Poker&)> script;

    explicit Poker(const sc_core::sc_module_name& name) : sc_module(name) { SC_THREAD(run); }
    SC_HAS_PROCESS(Poker);

    void run() {
        if (script) script(*this);
    }
    void set(uint32_t index, uint32_t word) {
        sc_core::sc_time delay;
        port.write(kDevices + 4 * uint64_t(index), &word, sizeof word, delay);
    }
    uint32_t get(uint32_t index) {
        sc_core::sc_time delay;
        uint32_t word = 0;
        port.read(kDevices + 4 * uint64_t(index), &word, sizeof word, delay);
        return word;
    }
};

/// A device with its driver and half of the memory.
struct Side {
    Side(const std::string& name, const DeviceConfig& config, uint64_t number, uint32_t capacity,
         shell::Bus& bus)
        : interrupt((name + "_interrupt").c_str()),
          device((name + "_device").c_str(), config),
          driver((name + "_driver").c_str(), {kDevices + number * kDeviceBytes,
                                              number * kMemoryBytes, kMemoryBytes, capacity}) {
        bus.map(kDevices + number * kDeviceBytes, kDeviceBytes);
        bus.targets.bind(device.registers);
        driver.port.socket.bind(bus.initiators);
        device.memory_port.socket.bind(bus.initiators);
        device.interrupt.bind(interrupt);
    }
    sc_core::sc_signal<bool> interrupt;
    shell::DisplacementUnit device;
    shell::Driver driver;
};

struct Bench {
    Bench(const DeviceConfig& config, uint32_t capacity = 64)
        : memory("memory", 2 * kMemoryBytes, ns(50)),
          poker("poker"),
          sides{std::make_unique<Side>("a", config, 0, capacity, mapped()),
                std::make_unique<Side>("b", config, 1, capacity, bus)} {
        poker.port.socket.bind(bus.initiators);
        tlm::tlm_global_quantum::instance().set(ns(200));
    }
    // The first target that is bound answers at the first range.
    shell::Bus& mapped() {
        bus.map(0, 2 * kMemoryBytes);
        bus.targets.bind(memory.socket);
        return bus;
    }
    void hear_interrupts() {
        for (auto& side : sides) side->driver.interrupt.bind(side->interrupt);
    }

    shell::Bus bus{"bus"};
    shell::Memory memory;
    Poker poker;
    std::unique_ptr<Side> sides[2];
};

bool gives(Side& side, const Profile& profile, const Draws& draws) {
    const test::Expected expected = test::bare_loops(profile, draws);
    const std::vector<shell::DrawOutput> found = side.driver.take_outputs();
    bool equal = side.driver.status().ok() && found.size() == draws.size();
    for (std::size_t i = 0; equal && i < draws.size(); ++i) {
        equal = test::same(found[i], expected.outputs[i]);
    }
    return equal && test::same_counters(side.device.counters(), expected.counters);
}

struct Work {
    Profile profile = test::profile_with("default", {});
    Draws sweep = {test::with_direct_ones(test::sweep_draw(profile, true, 2), 20)};
    Draws adaptive = {test::adaptive_draw(profile)};
    Draws both = {adaptive[0], sweep[0]};
    DeviceConfig config = test::config_for(profile, both);
};

TEST(Device, TwoAtOnceDoNotKnowOfEachOther) {
    EXPECT_EXIT(
        {
            const Work work;
            Bench bench(work.config);
            bench.hear_interrupts();
            bench.sides[0]->driver.start(work.both);
            bench.sides[1]->driver.start(work.sweep);
            sc_core::sc_start();
            std::exit(gives(*bench.sides[0], work.profile, work.both) &&
                              gives(*bench.sides[1], work.profile, work.sweep)
                          ? 0
                          : 1);
        },
        testing::ExitedWithCode(0), "");
}

// Tables are asked for again in the middle of a frame.
TEST(Device, SurvivesDmiPointersTakenBack) {
    EXPECT_EXIT(
        {
            const Work work;
            Bench bench(work.config);
            bench.hear_interrupts();
            bench.poker.script = [&](Poker&) {
                for (int i = 0; i < 2000; ++i) {
                    sc_core::wait(ns(100));
                    bench.memory.invalidate();
                }
            };
            bench.sides[0]->driver.start(work.both);
            sc_core::sc_start();
            std::exit(gives(*bench.sides[0], work.profile, work.both) ? 0 : 1);
        },
        testing::ExitedWithCode(0), "");
}

// 0: an aborted frame said so, and the next run was as ever.
int abort_after(const Draws& draws, double after_ns) {
    const Work work;
    Bench bench(work.config);
    bench.hear_interrupts();
    bench.poker.script = [&](Poker& poker) {
        sc_core::wait(ns(after_ns));
        poker.set(shell::kControl, shell::kControlInterrupts | shell::kControlAbort);
    };
    shell::Driver& driver = bench.sides[0]->driver;
    driver.start(draws);
    sc_core::sc_start();
    const bool aborted = !driver.status() && driver.status().error().message().find(
                                                 "the frame was aborted") != std::string::npos;
    driver.start(draws);
    sc_core::sc_start();
    return aborted && gives(*bench.sides[0], work.profile, draws) ? 0 : 1;
}

TEST(Device, AbortEndsAFrameAndNothingOfItStays) {
    const Work work;
    for (const double after_ns : {15000., 16000., 18000.}) {
        EXPECT_EXIT(std::exit(abort_after(work.sweep, after_ns)), testing::ExitedWithCode(0), "");
        EXPECT_EXIT(std::exit(abort_after(work.adaptive, after_ns)), testing::ExitedWithCode(0),
                    "");
    }
}

// Nobody takes the output: only an abort ends the frame.
int abort_full_buffer(const Draws& draws) {
    const Work work;
    Bench bench(work.config, 3);
    sc_core::sc_signal<bool> never("never");
    for (auto& side : bench.sides) side->driver.interrupt.bind(never);
    uint32_t before = 0, after = 0, reason = 0;
    bench.poker.script = [&](Poker& poker) {
        sc_core::wait(ns(1e6));
        before = poker.get(shell::kStatus);
        poker.set(shell::kControl, shell::kControlReset);  // ignored while busy
        poker.set(shell::kControl, shell::kControlAbort);
        sc_core::wait(ns(1e6));
        after = poker.get(shell::kStatus);
        reason = poker.get(shell::kErrorCode);
    };
    bench.sides[0]->driver.start(draws);
    sc_core::sc_start();
    return before == (shell::kStatusBusy | shell::kStatusOutputFull) &&
                   after == (shell::kStatusDone | shell::kStatusError) && reason == shell::kAborted
               ? 0
               : 1;
}

TEST(Device, AbortEndsAFrameThatWaitsForItsOutput) {
    const Work work;
    EXPECT_EXIT(std::exit(abort_full_buffer(work.sweep)), testing::ExitedWithCode(0), "");
    EXPECT_EXIT(std::exit(abort_full_buffer(work.adaptive)), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace repousse
