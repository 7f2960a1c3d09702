#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "datapath/sweep_items.h"
#include "datapath/transaction.h"
#include "datapath/units/strip.h"
#include "datapath/units/strip_desc.h"

namespace repousse {

/// A command as it stands on a port.
inline Word pack(const StripCommand& command) {
    return static_cast<Word>(command.op) << 4 | Word{command.place} << 2 |
           static_cast<Word>(command.keep);
}
inline StripCommand unpack_strip_command(Word word) {
    return {static_cast<StripOp>(word >> 4 & 3), static_cast<uint8_t>(word >> 2 & 3),
            static_cast<StripKeep>(word & 3)};
}

/// One step as it enters the unit, with its new vertices by their numbers: the input ports of the
/// description.
struct StripIn {
    bool flush = false;
    StripStep step;
    std::array<uint32_t, 4> vertices{};

    std::array<Word, 12> pack() const {
        const auto& c = step.commands;
        return {flush,
                step.init,
                step.flip,
                step.count,
                repousse::pack(c[0]),
                repousse::pack(c[1]),
                repousse::pack(c[2]),
                repousse::pack(c[3]),
                vertices[0],
                vertices[1],
                vertices[2],
                vertices[3]};
    }
    static StripIn unpack(const Word* w) {
        StripIn in;
        in.flush = w[0] != 0;
        in.step.init = w[1] != 0;
        in.step.flip = w[2] != 0;
        in.step.count = static_cast<uint8_t>(w[3]);
        for (std::size_t i = 0; i < 4; ++i) {
            in.step.commands[i] = unpack_strip_command(w[4 + i]);
            in.vertices[i] = static_cast<uint32_t>(w[8 + i]);
        }
        return in;
    }
};
static_assert(ports_are(kStripDesc, PortKind::Input,
                        {"flush", "init", "flip", "count", "command0", "command1", "command2",
                         "command3", "vertex0", "vertex1", "vertex2", "vertex3"}));
static_assert(ports_are(kStripDesc, PortKind::Config, {}));

/// What the unit answers to a step: the output ports. Vertices of triangles that were not made are
/// undefined on the ports and 0 here.
struct StripOut {
    StripTriangles<uint32_t> made;
    bool bad_ref = false;

    std::array<Word, 8> pack() const {
        std::array<Word, 8> words = {made.count, bad_ref};
        for (std::size_t i = 0; i < made.count; ++i) {
            for (std::size_t k = 0; k < 3; ++k) words[2 + 3 * i + k] = made.triangles[i][k];
        }
        return words;
    }
};
static_assert(ports_are(kStripDesc, PortKind::Output,
                        {"triangles", "bad_ref", "a0", "b0", "c0", "a1", "b1", "c1"}));

}  // namespace repousse
