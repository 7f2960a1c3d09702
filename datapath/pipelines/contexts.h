#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "datapath/items.h"
#include "datapath/span.h"
#include "datapath/units/split.h"
#include "datapath/units/triangle_stack.h"

namespace repousse {

/// What the device keeps of a corner of a finished triangle.
template <class P>
struct OutputVertex {
    Uv uv;
    Vec3<typename P::Value> displaced;
    Vec3<typename P::Value> displaced_normal;  ///< zero unless the scene asks for `bump`
    Colour<typename P::Value> colour;          ///< zero unless it asks for `shade`
    uint8_t generation = 0;
};

/// A finished triangle.
template <class P>
struct OutputTriangle {
    std::array<OutputVertex<P>, 3> corners;
    Path path;
};

/// The tessellator's contexts: each works on one base triangle at a time, depth first on its own
/// stack, and gives at most one triangle to a batch. What a triangle turns into does not depend on
/// the others in the batch, so any number of contexts gives the same values; finished triangles
/// leave in architectural order, by base triangle and then by the order of the stack.
template <class P>
class Contexts {
public:
    Contexts(int count, StackOrder order, int cap)
        : contexts_(static_cast<std::size_t>(count), Context{{order, cap}, {}}) {}

    /// Fills `batch` with at most one triangle a context. Idle contexts first take the next base
    /// triangle: `fetch(Triangle<P>&)` writes it and says whether there was one.
    template <class Fetch>
    std::size_t gather(Span<Triangle<P>> batch, Fetch&& fetch) {
        std::size_t n = 0;
        for (uint32_t c = 0; c < contexts_.size() && n < batch.size(); ++c) {
            Context& context = contexts_[c];
            if (context.stack.empty()) {
                if (!fetch(batch[n])) continue;
                context.base = next_base_++;
                batch[n].path = Path{context.base, 0, {}};
                pending_.push_back({take_buffer(), false});
            } else {
                context.stack.pop(batch[n]);
            }
            in_batch_.push_back(c);
            ++n;
        }
        return n;
    }

    /// Takes back what the i-th triangle of the last batch turned into; to be called for each,
    /// in order. False if a stack's bound was broken.
    bool scatter(std::size_t i, const Triangle<P>& triangle, const Children<P>& children) {
        Context& context = contexts_[in_batch_[i]];
        Pending& pending = pending_[context.base - first_pending_];
        if (children.count == 0) {
            const auto& [a, b, c] = triangle.corners;
            pending.triangles.push_back({{output(a), output(b), output(c)}, triangle.path});
        }
        bool fits = true;
        for (int k = 0; k < children.count; ++k) {
            fits = context.stack.push(children.triangles[static_cast<std::size_t>(k)]) && fits;
        }
        pending.done = context.stack.empty();
        return fits;
    }

    /// Ends a batch: hands every finished base triangle's output to `emit(Span<const
    /// OutputTriangle<P>>)` as soon as all base triangles before it are out.
    template <class Emit>
    void flush(Emit&& emit) {
        in_batch_.clear();
        while (!pending_.empty() && pending_.front().done) {
            std::vector<OutputTriangle<P>>& triangles = pending_.front().triangles;
            emit(Span<const OutputTriangle<P>>(triangles));
            triangles.clear();
            spare_.push_back(std::move(triangles));
            pending_.pop_front();
            ++first_pending_;
        }
    }

    /// Most triangles that ever waited in one context's stack.
    std::size_t peak() const {
        std::size_t most = 0;
        for (const Context& context : contexts_) {
            most = context.stack.peak() > most ? context.stack.peak() : most;
        }
        return most;
    }

private:
    struct Context {
        TriangleStack<P> stack;
        uint32_t base;
    };
    struct Pending {
        std::vector<OutputTriangle<P>> triangles;
        bool done;
    };

    static OutputVertex<P> output(const Vertex<P>& v) {
        return {v.uv, v.displaced, v.displaced_normal, v.colour, v.generation};
    }

    std::vector<OutputTriangle<P>> take_buffer() {
        if (spare_.empty()) return {};
        std::vector<OutputTriangle<P>> buffer = std::move(spare_.back());
        spare_.pop_back();
        return buffer;
    }

    std::vector<Context> contexts_;
    std::vector<uint32_t> in_batch_;  // context of the i-th triangle of the batch
    std::deque<Pending> pending_;     // output of base triangles first_pending_, +1, ...
    std::vector<std::vector<OutputTriangle<P>>> spare_;
    uint32_t next_base_ = 0;
    uint32_t first_pending_ = 0;
};

}  // namespace repousse
