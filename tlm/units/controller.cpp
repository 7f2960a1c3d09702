#include "tlm/units/controller.h"

namespace repousse::shell {

Controller::Controller(const sc_core::sc_module_name& name, const Profile& profile)
    : sc_module(name), unit_(profile), triangles_(kBatchBases) {
    items_.reserve(kBatchBases);
    new_vertices_.reserve(3 * kBatchBases);
    new_corners_.reserve(3 * kBatchBases);
}

Controller::Outcome Controller::run(const Frame& frame) {
    unit_.configure(frame.vertex_count, frame.use_bump);
    table_.resize(frame.vertex_count);
    known_.assign(frame.vertex_count, false);
    Outcome outcome = Outcome::Done;
    for (uint32_t next = 0; next < frame.triangle_count && outcome == Outcome::Done;) {
        const uint32_t first = next;
        outcome = gather(frame, next);
        BatchTime time;
        time.stage(kControllerDesc, next - first);
        transform_new(time);
        if (!items_.empty()) {
            BaseBatch batch{items_, {triangles_.data(), items_.size()}};
            out->put(batch, time);
        }
        if (!frame.elapse(time)) outcome = Outcome::Aborted;
    }
    return outcome;
}

// Reads up to a batch of descriptors, with the vertices that they name for the first time.
Controller::Outcome Controller::gather(const Frame& frame, uint32_t& next) {
    items_.clear();
    new_vertices_.clear();
    new_corners_.clear();
    for (std::size_t n = 0; n < kBatchBases && next < frame.triangle_count; ++n) {
        const SweepRecord& record = frame.base(next++);
        if (record.max_displacement < 0 || record.flags > kDirect) return Outcome::BadDescriptor;
        const OrderToken token = unit_(record.vertices, record.flags == kDirect);
        if (unit_.bad_index()) return Outcome::BadIndex;
        if (token.route == Route::Displaced && out.size() == 0) return Outcome::MissingUnit;
        order->expect(token);
        if (token.route == Route::Direct) {
            send_direct(frame, token, record);
            continue;
        }
        BaseItem item;
        item.base = token.base;
        item.max_displacement = record.max_displacement;
        for (std::size_t k = 0; k < 3; ++k) {
            const uint32_t i = record.vertices[k];
            item.corners[k] = &table_[i];
            if (known_[i]) continue;
            known_[i] = true;
            new_vertices_.push_back(vertex_of(frame.vertex(i)));
            new_corners_.emplace_back().corner.id = i;
        }
        items_.push_back(item);
    }
    return Outcome::Done;
}

void Controller::send_direct(const Frame& frame, const OrderToken& token,
                             const SweepRecord& record) {
    DirectTriangle triangle{};
    triangle.base = token.base;
    for (uint8_t k = 0; k < 3; ++k) {
        const Vertex<Fixed> vertex = vertex_of(frame.vertex(record.vertices[k]));
        triangle.corners[k] = unit_.undisplaced(vertex, k);
    }
    order->push_direct(triangle);
}

void Controller::transform_new(BatchTime& time) {
    if (new_vertices_.empty()) return;
    CornerBatch batch{new_vertices_, new_corners_};
    corners_out->put(batch, time);
    for (const GridVertex& corner : new_corners_) table_[corner.corner.id] = corner;
}

}  // namespace repousse::shell
