#include "tlm/records.h"

namespace repousse::shell {
namespace {

std::array<int32_t, 3> words_of(const Vec3<int32_t>& v) { return {v.x, v.y, v.z}; }
std::array<int32_t, 3> words_of(const Colour<int32_t>& c) { return {c.red, c.green, c.blue}; }
Vec3<int32_t> vector_of(const std::array<int32_t, 3>& w) { return {w[0], w[1], w[2]}; }

}  // namespace

VertexRecord record_of(const Vertex<Fixed>& v) {
    return {{v.uv.x, v.uv.y},
            words_of(v.position),
            words_of(v.normal),
            words_of(v.tangent),
            v.handedness};
}

SweepRecord record_of(const SweepBase<Fixed>& base) {
    return {base.vertices, base.max_displacement, base.direct ? uint32_t(kDirect) : 0};
}

OutputRecord record_of(const OutputTriangle<Fixed>& triangle) {
    OutputRecord record;
    record.base = triangle.path.base;
    record.depth = triangle.path.depth;
    record.digits = triangle.path.digits;
    for (std::size_t k = 0; k < 3; ++k) {
        const OutputVertex<Fixed>& v = triangle.corners[k];
        record.corners[k] = {{v.uv.x, v.uv.y},
                             words_of(v.displaced),
                             words_of(v.displaced_normal),
                             words_of(v.colour),
                             v.generation};
    }
    return record;
}

Vertex<Fixed> vertex_of(const VertexRecord& r) {
    Vertex<Fixed> v;
    v.uv = {r.uv[0], r.uv[1]};
    v.position = vector_of(r.position);
    v.normal = vector_of(r.normal);
    v.tangent = vector_of(r.tangent);
    v.handedness = r.handedness < 0 ? -1 : 1;
    return v;
}

void read_record(const OutputRecord& record, OutputTriangle<Fixed>& triangle) {
    triangle.path = {record.base, static_cast<uint8_t>(record.depth), record.digits};
    for (std::size_t k = 0; k < 3; ++k) {
        const OutputRecord::Corner& c = record.corners[k];
        triangle.corners[k] = {{c.uv[0], c.uv[1]},
                               vector_of(c.displaced),
                               vector_of(c.displaced_normal),
                               {c.colour[0], c.colour[1], c.colour[2]},
                               static_cast<uint8_t>(c.generation)};
    }
}

}  // namespace repousse::shell
