#pragma once

#include <vector>

#include "datapath/profile.h"
#include "datapath/sweep_items.h"
#include "datapath/transaction.h"
#include "datapath/units/sweep_line.h"

namespace repousse {

/// A base triangle as it enters the sweep line: the input ports of the description.
struct SweepLineIn {
    SweepTriangle triangle;

    /// As words. Values are cut to the width of the profile's adders, which loses nothing: they
    /// count modulo that width.
    std::vector<Word> pack(const Profile& profile) const;

    /// The triangle back from its words. What never shows at the unit's outputs is left out: slots
    /// of corners but for the sweep coordinate, ids, the remeshing plane.
    static SweepLineIn unpack(const Word* words, const Profile& profile);
};

/// One beat of the sweep line's output: the output ports of the description.
struct SweepLineOut {
    SweepStep step;
    bool runaway = false;
    bool last = false;

    std::vector<Word> pack(const Profile& profile) const;
};

/// The width of vertex data as the unit sends them.
int sweep_data_width(const Profile& profile);

}  // namespace repousse
