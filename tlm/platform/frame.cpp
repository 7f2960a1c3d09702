// The frame of the DisplacementUnit: from the doorbell to the interrupt.

#include <algorithm>

#include "tlm/platform/displacement_unit.h"

namespace repousse::shell {

void DisplacementUnit::raise(uint32_t status) {
    status_ = status;
    interrupt_level_ = (file_[kControl] & kControlInterrupts) != 0;
    interrupt_event_.notify(sc_core::SC_ZERO_TIME);
}

void DisplacementUnit::run_frames() {
    while (true) {
        wait(start_event_);
        quantum_.reset();
        output_count_ = output_vertex_count_ = 0;
        const FrameError error = run_frame();
        quantum_.sync();
        error_ = error;
        raise(error == kNoError ? kStatusDone : kStatusDone | kStatusError);
    }
}

FramePath* DisplacementUnit::path() const {
    if (frame_.has(kSweep)) return sweep_.get();
    return adaptive_.get();
}

FrameError DisplacementUnit::run_frame() {
    FramePath* const path = this->path();
    if (path == nullptr) return kMissingUnit;
    if (!frame_.plausible()) return kBadRegister;
    memory_port.moved();
    const FrameError error = path->run();
    return memory_port.ok() ? error : kMemoryError;
}

const void* DisplacementUnit::view(uint64_t address, uint64_t bytes) {
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    const void* at = memory_port.view(address, bytes, delay);
    quantum_.inc(delay);
    return at;
}

// A full buffer stops the frame until the host has emptied all, so any buffer is large enough.
template <class Record>
void DisplacementUnit::write(Span<const Record> records, Register low, Register capacity,
                             uint32_t& count) {
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    while (!records.empty()) {
        if (count == frame_[capacity]) wait_until_drained();
        if (abort_) return;
        const std::size_t n = std::min(records.size(), std::size_t(frame_[capacity] - count));
        memory_port.write(frame_.address(low) + count * sizeof(Record), records.data(),
                          n * sizeof(Record), delay);
        count += static_cast<uint32_t>(n);
        records = records.subspan(n, records.size() - n);
    }
    quantum_.inc(delay);
}

void DisplacementUnit::write(Span<const OutputRecord> triangles) {
    write(triangles, kOutputLo, kOutputCapacity, output_count_);
}

void DisplacementUnit::write(Span<const FineTriangleRecord> triangles) {
    write(triangles, kOutputLo, kOutputCapacity, output_count_);
}

void DisplacementUnit::write(Span<const FineRecord> vertices) {
    write(vertices, kOutputVerticesLo, kOutputVertexCapacity, output_vertex_count_);
}

void DisplacementUnit::wait_until_drained() {
    quantum_.sync();
    if (abort_) return;
    raise(kStatusBusy | kStatusOutputFull);
    wait(drained_event_);
    status_ = kStatusBusy;
    if (!abort_) output_count_ = output_vertex_count_ = 0;
}

bool DisplacementUnit::elapse(uint64_t cycles) {
    cycles_ += cycles;
    quantum_.inc(static_cast<double>(cycles) * clock_period_);
    if (quantum_.need_sync()) quantum_.sync();
    if (memory_port.moved()) path()->bind();
    return !abort_;
}

}  // namespace repousse::shell
