#include "tlm/records.h"

namespace repousse::shell {
namespace {

constexpr uint32_t kCoordinateMask = (1 << 14) - 1;

std::array<int32_t, 3> words_of(const Vec3<int32_t>& v) { return {v.x, v.y, v.z}; }
Vec3<int32_t> vector_of(const std::array<int32_t, 3>& w) { return {w[0], w[1], w[2]}; }

int16_t sign_extended(uint32_t bits) {
    return static_cast<int16_t>(static_cast<int32_t>(bits << 18) >> 18);
}

}  // namespace

uint32_t pack_name(const VertexName& name) {
    return static_cast<uint32_t>(name.kind) << 30 | uint32_t(name.part) << 28 |
           (static_cast<uint32_t>(name.a) & kCoordinateMask) << 14 |
           (static_cast<uint32_t>(name.b) & kCoordinateMask);
}

VertexName unpack_name(uint32_t word) {
    return {static_cast<NameKind>(word >> 30), static_cast<uint8_t>(word >> 28 & 3),
            sign_extended(word >> 14 & kCoordinateMask), sign_extended(word & kCoordinateMask)};
}

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
        record.corners[k] = {
            {v.uv.x, v.uv.y}, words_of(v.displaced), words_of(v.displaced_normal), v.generation};
    }
    return record;
}

OutputRecord::Corner corner_of(const SweepOutputVertex<Fixed>& v) {
    return {
        {v.uv.x, v.uv.y}, words_of(v.displaced), words_of(v.displaced_normal), pack_name(v.name)};
}

OutputRecord::Corner corner_of(const FineVertex<Fixed>& v) {
    return {
        {v.uv.x, v.uv.y}, words_of(v.displaced), words_of(v.displaced_normal), pack_name(v.name)};
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
                               static_cast<uint8_t>(c.tag)};
    }
}

void read_record(const OutputRecord& record, SweepOutput<Fixed>& triangle) {
    triangle.base = record.base;
    for (std::size_t k = 0; k < 3; ++k) {
        const OutputRecord::Corner& c = record.corners[k];
        triangle.corners[k] = {unpack_name(c.tag),
                               {c.uv[0], c.uv[1]},
                               vector_of(c.displaced),
                               vector_of(c.displaced_normal)};
    }
}

}  // namespace repousse::shell
