#include "tlm/platform/driver.h"

#include "tlm/records.h"

namespace repousse::shell {
namespace {

const char* reason(uint32_t error) {
    switch (error) {
        case kMissingUnit:
            return "a feature needs a unit that was not built";
        case kBadRegister:
            return "a register is out of its range";
        case kMemoryError:
            return "a memory access was answered with an error";
        case kStackOverflow:
            return "the triangle stack overflowed its proven bound";
        case kBadIndex:
            return "an index names no vertex";
        case kAborted:
            return "the frame was aborted";
        case kBadDescriptor:
            return "a base triangle's displacement or flags are out of range";
        default:
            return "no reason given";
    }
}

DrawOutput empty_output(const Draw& draw) {
    if (std::holds_alternative<SweepDraw<Fixed>>(draw)) return SweepMesh<Fixed>();
    return std::vector<OutputTriangle<Fixed>>();
}

}  // namespace

Driver::Driver(const sc_core::sc_module_name& name, const AddressMap& map)
    : sc_module(name), map_(map) {
    SC_THREAD(drive);
    dont_initialize();
    sensitive << start_event_;
}

void Driver::start(Span<const Draw> draws) {
    draws_ = draws;
    outputs_.clear();
    for (const Draw& draw : draws) outputs_.push_back(empty_output(draw));
    status_ = done();
    start_event_.notify(sc_core::SC_ZERO_TIME);
}

void Driver::drive() {
    while (true) {
        drive_all();
        sc_core::wait(start_event_);
    }
}

void Driver::drive_all() {
    port.clear();
    if (get(kId) != kIdValue) {
        status_ = Error{ErrorKind::Environment, "device", "does not answer with its ID", {}, {}};
    }
    set(kControl, uint32_t(kControlReset));
    set(kControl, uint32_t(kControlInterrupts));
    for (std::size_t i = 0; i < draws_.size() && status_.ok(); ++i) {
        if (!run(draws_[i], outputs_[i]) && status_.ok()) {
            status_ = Error{ErrorKind::Mismatch,
                            "draw " + std::to_string(i),
                            std::string("the device reports: ") + reason(get(kErrorCode)),
                            {},
                            {}};
        }
    }
}

bool Driver::run(const Draw& draw, DrawOutput& output) {
    upload(draw);
    std::visit([this](const auto& d) { program(d); }, draw);
    if (!port.ok()) {
        status_ = Error{ErrorKind::Environment, "memory", "an access failed", {}, {}};
        return false;
    }
    set(kDoorbell, uint32_t(kStart));
    while (true) {
        sc_core::wait(local_time_);
        local_time_ = sc_core::SC_ZERO_TIME;
        if (!interrupt.read()) sc_core::wait(interrupt.posedge_event());
        const uint32_t status = get(kStatus);
        set(kInterrupt, 1U);
        sc_core::wait(interrupt.negedge_event());
        std::visit([this](auto& o) { collect(o); }, output);
        if ((status & (kStatusRunaway | kStatusBadRef)) != 0) {
            status_ = Error{ErrorKind::Mismatch, "status", "the sweep line lost its way", {}, {}};
            return false;
        }
        if ((status & kStatusDone) != 0) return (status & kStatusError) == 0;
        set(kDoorbell, uint32_t(kDrained));
    }
}

template <class Record>
Span<const Record> Driver::output(uint64_t address, uint32_t count) {
    const void* records = port.view(address, count * sizeof(Record), local_time_);
    return {static_cast<const Record*>(records), count};
}

void Driver::collect(std::vector<OutputTriangle<Fixed>>& triangles) {
    const auto records = output<OutputRecord>(output_address_, get(kOutputCount));
    std::size_t next = triangles.size();
    triangles.resize(next + records.size());
    for (const OutputRecord& record : records) read_record(record, triangles[next++]);
}

void Driver::collect(SweepMesh<Fixed>& mesh) {
    mesh.append(output<FineRecord>(output_vertices_address_, get(kOutputVertexCount)));
    mesh.append(output<FineTriangleRecord>(output_address_, get(kOutputCount)));
}

void Driver::set(uint32_t index, uint32_t word) {
    port.write(map_.device + 4 * uint64_t(index), &word, sizeof word, local_time_);
}

void Driver::set(uint32_t index, const Vec3<int32_t>& v) {
    set(index, v.x);
    set(index + 1, v.y);
    set(index + 2, v.z);
}

void Driver::set(uint32_t index, const Colour<int32_t>& c) {
    set(index, c.red);
    set(index + 1, c.green);
    set(index + 2, c.blue);
}

void Driver::set_address(Register low, uint64_t address) {
    set(low, static_cast<uint32_t>(address));
    set(low + 1, static_cast<uint32_t>(address >> 32));
}

uint32_t Driver::get(uint32_t index) {
    uint32_t word = 0;
    port.read(map_.device + 4 * uint64_t(index), &word, sizeof word, local_time_);
    return word;
}

}  // namespace repousse::shell
