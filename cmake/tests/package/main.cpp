// A platform of somebody else: the displacement unit beside a memory and a processor of its own.
// One triangle of a flat map is split on its three edges, so four triangles come back.

#include <cstdio>
#include <cstring>
#include <vector>

#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>
#include <systemc>
#include <tlm>

#include "tlm/config/profile_reader.h"
#include "tlm/platform/displacement_unit.h"

namespace device = repousse::shell;

// Any TLM-2.0 target will do; one that grants DMI pointers is faster.
struct Ram : sc_core::sc_module {
    tlm_utils::simple_target_socket<Ram> socket{"socket"};
    std::vector<unsigned char> bytes = std::vector<unsigned char>(1 << 16);

    explicit Ram(const sc_core::sc_module_name& name) : sc_module(name) {
        socket.register_b_transport(this, &Ram::b_transport);
    }
    void b_transport(tlm::tlm_generic_payload& trans, sc_core::sc_time& delay) {
        delay += sc_core::sc_time(50, sc_core::SC_NS);
        unsigned char* at = bytes.data() + trans.get_address();
        if (trans.is_write()) std::memcpy(at, trans.get_data_ptr(), trans.get_data_length());
        if (trans.is_read()) std::memcpy(trans.get_data_ptr(), at, trans.get_data_length());
        trans.set_response_status(tlm::TLM_OK_RESPONSE);
    }
};

// Plays the driver: buffers, registers, doorbell, interrupt.
struct Processor : sc_core::sc_module {
    tlm_utils::simple_initiator_socket<Processor> socket{"socket"};
    sc_core::sc_in<bool> interrupt{"interrupt"};
    Ram& ram;
    bool passed = false;

    Processor(const sc_core::sc_module_name& name, Ram& memory) : sc_module(name), ram(memory) {
        SC_THREAD(run);
    }
    SC_HAS_PROCESS(Processor);

    uint32_t access(tlm::tlm_command command, uint32_t index, uint32_t word) {
        tlm::tlm_generic_payload trans;
        sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
        trans.set_command(command);
        trans.set_address(4 * index);
        trans.set_data_ptr(reinterpret_cast<unsigned char*>(&word));
        trans.set_data_length(4);
        trans.set_streaming_width(4);
        socket->b_transport(trans, delay);
        wait(delay);
        return word;
    }
    void set(uint32_t index, uint32_t word) { access(tlm::TLM_WRITE_COMMAND, index, word); }
    uint32_t get(uint32_t index) { return access(tlm::TLM_READ_COMMAND, index, 0); }

    void run() {
        // In the formats of the profile "default": uv s14.8, position s15.16, normal s1.14.
        constexpr int32_t kTexel = 1 << 8, kUnit = 1 << 16, kOne = 1 << 14;
        const device::VertexRecord vertices[] = {
            {{0, 0}, {0, 0, 0}, {0, 0, kOne}, {kOne, 0, 0}, 1},
            {{4 * kTexel, 0}, {kUnit, 0, 0}, {0, 0, kOne}, {kOne, 0, 0}, 1},
            {{0, 4 * kTexel}, {0, kUnit, 0}, {0, 0, kOne}, {kOne, 0, 0}, 1}};
        const uint32_t indices[] = {0, 1, 2};
        const std::vector<uint16_t> heights(4 * 4, 65535);
        constexpr uint32_t kVertices = 0x0, kIndices = 0x100, kHeights = 0x200, kOutput = 0x400;
        std::memcpy(&ram.bytes[kVertices], vertices, sizeof vertices);
        std::memcpy(&ram.bytes[kIndices], indices, sizeof indices);
        std::memcpy(&ram.bytes[kHeights], heights.data(), 2 * heights.size());

        set(device::kControl, 2);   // reset: every register is 0
        set(device::kControl, 1);   // interrupts
        set(device::kFeatures, 0);  // no test but the texel test: split down to the cap
        set(device::kCap, 1);
        set(device::kMapWidth, 4);
        set(device::kMapHeight, 4);
        set(device::kScaleMantissa, 1 << 23);  // D = h * 2^23 * 2^-39: one world unit
        set(device::kScaleExponent, 39);
        set(device::kVertexCount, 3);
        set(device::kTriangleCount, 1);
        set(device::kOutputCapacity, 64);
        set(device::kVerticesLo, kVertices);
        set(device::kIndicesLo, kIndices);
        set(device::kHeightsLo, kHeights);
        set(device::kOutputLo, kOutput);
        set(device::kDoorbell, device::kStart);
        if (!interrupt.read()) wait(interrupt.posedge_event());

        const uint32_t triangles = get(device::kOutputCount);
        device::OutputRecord first;
        std::memcpy(&first, &ram.bytes[kOutput], sizeof first);
        const int32_t z = first.corners[0].displaced[2];
        passed = get(device::kId) == device::kIdValue &&
                 get(device::kStatus) == device::kStatusDone && triangles == 4 && z == 65535;
        std::printf("%u triangles in %u cycles, z = %g\n", triangles, get(device::kCyclesLo),
                    double(z) / kUnit);
        set(device::kInterrupt, 1);
    }
};

int sc_main(int, char*[]) {
    const auto profile = repousse::shipped_profile("default");
    if (!profile) return 1;
    repousse::DeviceConfig config;
    config.profile = *profile;
    config.adaptive = true;

    sc_core::sc_signal<bool> interrupt{"interrupt"};
    device::DisplacementUnit unit("unit", config);
    Ram ram("ram");
    Processor processor("processor", ram);
    processor.socket.bind(unit.registers);
    unit.memory_port.socket.bind(ram.socket);
    unit.interrupt.bind(interrupt);
    processor.interrupt.bind(interrupt);

    sc_core::sc_start();
    return processor.passed ? 0 : 1;
}
