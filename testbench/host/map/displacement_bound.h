#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "datapath/items.h"
#include "datapath/profile.h"
#include "testbench/host/map/height_map.h"

namespace repousse::host {

/// How much displacement there can be on a part of a map: what conservative clipping needs for a
/// base triangle (Gumhold and Huettner 3.2, d_max per object or per cell).
///
/// A pyramid of the least and the greatest height in blocks of 2^k x 2^k texels answers for any
/// box of texels exactly, in time proportional to the box's border.
class DisplacementBound {
public:
    /// `slack` (world units) is added to every answer; see stored_height_slack.
    explicit DisplacementBound(const HeightMap& map, double slack = 0.0);

    /// max |D| in world units of every height that can be read with texture coordinates (in
    /// texels) in a box, nearest or between texels, with a texel to spare for coordinates that
    /// were rounded. Periodic maps continue over their seams, the others at their borders.
    double operator()(glm::dvec2 low, glm::dvec2 high) const;

    /// The same for the box around a base triangle; `frac` fraction bits. Vertices inside it are
    /// between its corners, so their coordinates are in the box.
    double of_triangle(const std::array<Uv, 3>& corners, int frac) const;

    /// For the whole map.
    double whole() const;

private:
    struct Range {
        uint16_t least = 65535;
        uint16_t greatest = 0;

        void include(const Range& other) {
            least = other.least < least ? other.least : least;
            greatest = other.greatest > greatest ? other.greatest : greatest;
        }
    };
    struct Level {
        int width = 0;
        int height = 0;
        std::vector<Range> blocks;  // row-major

        const Range& at(int x, int y) const {
            return blocks[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                          static_cast<std::size_t>(x)];
        }
    };
    /// Texels, both ends included.
    struct Box {
        int x0, y0, x1, y1;
    };

    void collect(std::size_t level, int x, int y, const Box& box, Range& range) const;
    double displacement(const Range& range) const;

    bool wrap_;
    double low_, per_lsb_, slack_;
    std::vector<Level> levels_;  // 0: the texels themselves; the last: one block
};

/// What a profile's narrower heights may add to |D|: one LSB of the stored height.
double stored_height_slack(const Profile& profile, const HeightMap& map);

}  // namespace repousse::host
