#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "datapath/numbers/functions.h"
#include "datapath/numbers/vector_clones.h"
#include "datapath/span.h"
#include "datapath/sweep_items.h"

namespace repousse {

/// Most vertices in one batch: a step of the sweep line makes four at most, one as a rule.
inline constexpr std::size_t kFineVertices = kFunctionBatch;

/// One signal of a batch.
template <class V>
using FineArray = std::array<V, kFineVertices>;

/// Vectors of a batch, one array a component.
template <class V>
struct FineVectors {
    FineArray<V> x, y, z;

    Vec3<V> operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
    void set(std::size_t i, const Vec3<V>& v) {
        x[i] = v.x;
        y[i] = v.y;
        z[i] = v.z;
    }
};

/// Two batches of vectors as a policy's functions take them.
template <class P>
typename P::Columns columns(const FineVectors<typename P::Value>& from,
                            FineVectors<typename P::Value>& to) {
    return {{from.x.data(), from.y.data(), from.z.data()}, {to.x.data(), to.y.data(), to.z.data()}};
}

/// Equal steps of the sweep line, one after the other, as a batch holds them: their vertices are
/// apart, in their order.
struct SweepRun {
    StripStep strip;
    uint8_t vertex_count = 0;  ///< that a step makes: one for each of its `New` commands
    uint32_t times = 1;
};

/// Most runs in a batch.
inline constexpr std::size_t kBatchRuns = 64;

inline uint64_t step_count(Span<const SweepRun> runs) {
    uint64_t steps = 0;
    for (const SweepRun& run : runs) steps += run.times;
    return steps;
}

/// Vertices as they leave the sweep line.
template <class V>
struct SweptVertices {
    std::size_t size = 0;
    FineArray<VertexName> names;
    std::array<FineArray<V>, kSweepComponents> data;  ///< still multiplied by c

    /// Adds a vertex: its name, and data that mean nothing behind the components of its triangle.
    void push_back(const VertexName& name, const std::array<V, kSweepComponents>& from) {
        const std::size_t at = size++;
        names[at] = name;
        REPOUSSE_UNROLLED
        for (std::size_t k = 0; k < kSweepComponents; ++k) data[k][at] = from[k];
    }
};

/// Vertices of the fine mesh on their way from the sweep line to the stripping unit, in the order
/// in which it made them. One array a signal, so that the arithmetic of all vertices goes side by
/// side through vector registers. The units behind the sweep line add to it one after the other;
/// what no unit of the draw has made stays as it was, so a draw starts with all of it zero.
template <class P>
struct FineVertices : SweptVertices<typename P::Value> {
    using V = typename P::Value;

    // Behind `perspective`.
    FineArray<int32_t> u, v;        ///< texels
    FineVectors<V> position;        ///< on the base surface
    FineVectors<V> normal;          ///< normalised after interpolation (equation 1)
    FineVectors<V> tangent;         ///< normalised; only with bump
    FineArray<int32_t> handedness;  ///< +1 or -1: the bitangent is handedness * (N x T)

    FineArray<LevelRead> reads;  ///< of the displacement map; only with filter levels

    FineVectors<V> displaced;         ///< P' = P + D N, behind `displace`
    FineVectors<V> displaced_normal;  ///< N', behind `bump`
    FineArray<V> red, green, blue;    ///< the colour, behind `shade`

    Uv uv(std::size_t i) const { return {u[i], v[i]}; }

    /// A vertex as it leaves.
    SweepOutputVertex<P> output(std::size_t i) const {
        return {
            this->names[i], uv(i), displaced[i], displaced_normal[i], {red[i], green[i], blue[i]}};
    }
};

}  // namespace repousse
