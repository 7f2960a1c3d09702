#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "datapath/map_view.h"
#include "datapath/pipelines/adaptive_counters.h"
#include "datapath/span.h"
#include "tlm/batch_time.h"
#include "tlm/config/device_config.h"
#include "tlm/memory/memory_port.h"
#include "tlm/platform/frame_registers.h"
#include "tlm/records.h"
#include "tlm/units/bump.h"
#include "tlm/units/displace.h"
#include "tlm/units/shade.h"
#include "tlm/units/vertex_transform.h"

namespace repousse::shell {

/// The units that frames of both kinds use.
struct SharedUnits {
    explicit SharedUnits(const DeviceConfig& config)
        : displace(config.has_displace() ? std::make_unique<Displace>("displace", config.profile)
                                         : nullptr),
          bump(config.has_bump() ? std::make_unique<Bump>("bump", config.profile) : nullptr),
          vertex_transform(config.has_vertex_transform() ? std::make_unique<VertexTransform>(
                                                               "vertex_transform", config.profile)
                                                         : nullptr),
          shade(config.has_displace() && config.shade
                    ? std::make_unique<Shade>("shade", config.profile)
                    : nullptr) {}

    /// For a frame that wants colours, or does not.
    void configure_shade(const FrameRegisters& frame) {
        if (!shade) return;
        if (frame.has(kUseShade)) {
            shade->configure(frame.shade(), frame.has(kUseBump));
        } else {
            shade->disable();
        }
    }

    // Null where the configuration goes without.
    std::unique_ptr<Displace> displace;
    std::unique_ptr<Bump> bump;
    std::unique_ptr<VertexTransform> vertex_transform;
    std::unique_ptr<Shade> shade;
};

/// What the device does for the frame that runs in it: memory, output, time.
class FrameHost {
public:
    virtual const FrameRegisters& frame() const = 0;

    /// `count` elements at the address in a register pair, valid until `elapse` says otherwise.
    template <class T>
    Span<const T> table(Register low, std::size_t count) {
        return {static_cast<const T*>(view(frame().address(low), count * sizeof(T))), count};
    }

    /// False once an access was answered with an error.
    virtual bool memory_ok() const = 0;

    /// Write what is finished; wait for the driver whenever an output buffer is full.
    virtual void write(Span<const OutputRecord> triangles) = 0;
    virtual void write(Span<const FineTriangleRecord> triangles) = 0;
    virtual void write(Span<const FineRecord> vertices) = 0;

    /// Lets time pass. False: the frame is aborted. Tables may move: `FramePath::bind` is called.
    virtual bool elapse(uint64_t cycles) = 0;

protected:
    ~FrameHost() = default;
    virtual const void* view(uint64_t address, uint64_t bytes) = 0;
};

/// One method of making triangles: its units, joined to chains, and how a frame goes through them.
class FramePath {
public:
    virtual ~FramePath() = default;

    /// Runs a frame to its end.
    virtual FrameError run() = 0;

    /// Fetches pointers to the tables of the frame that runs; again whenever memory takes them
    /// back.
    virtual FrameError bind() = 0;

    /// The state after power-on.
    virtual void reset() = 0;

    /// Busy cycles of all units, summed over the frames.
    virtual const BusyTable& busy() const = 0;

    /// Status bits of its units.
    virtual uint32_t status() const { return 0; }
};

}  // namespace repousse::shell
