#include "testbench/cosim/sine_tables.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "datapath/numbers/sine.h"

namespace repousse::cosim {

std::string verilog_sine_tables() {
    constexpr int kWord = Sine::kFractionBits + 1;
    constexpr std::size_t kWordsPerLine = 9;
    const std::vector<int32_t> knots = sine_knots();
    std::string text = fmt::format(
        "    // Printed from datapath/numbers/sine.cpp: sines of 0 to a quarter turn, the last one "
        "first.\n    localparam [{}:0] SINE_KNOTS = {{",
        knots.size() * kWord - 1);
    for (std::size_t i = knots.size(); i-- > 0;) {
        if ((knots.size() - 1 - i) % kWordsPerLine == 0) text += "\n       ";
        text += fmt::format(" {}'h{:06x}{}", kWord, knots[i], i == 0 ? "" : ",");
    }
    return text + "\n    };\n";
}

}  // namespace repousse::cosim
