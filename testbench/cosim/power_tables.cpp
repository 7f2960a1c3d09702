#include "testbench/cosim/power_tables.h"

#include <fmt/format.h>

#include <cstdint>
#include <functional>

#include "datapath/numbers/power.h"

namespace repousse::cosim {
namespace {

constexpr int kLogSizes = 5;  // as datapath/profile.cpp allows
constexpr int kExpSizes = 8;
constexpr std::size_t kWordsPerLine = 6;

/// One table as a concatenation, the last word first.
std::string table_text(const std::string& name, std::size_t count, int word_bits,
                       const std::function<uint64_t(std::size_t)>& word) {
    std::string text = fmt::format("\n    localparam [{}:0] {} = {{",
                                   static_cast<int>(count) * word_bits - 1, name);
    for (std::size_t i = count; i-- > 0;) {
        if ((count - 1 - i) % kWordsPerLine == 0) text += "\n       ";
        text += fmt::format(" {}'h{:0{}x}{}", word_bits, word(i), (word_bits + 3) / 4,
                            i == 0 ? "" : ",");
    }
    return text + "\n    };\n";
}

/// The choice among the tables of one function.
std::string choice_text(const std::string& name, int sizes) {
    std::string text = fmt::format("\n    localparam [{0}_N*{0}_WORD-1:0] {0}_TABLE =\n", name);
    for (int bits = 1; bits <= sizes; ++bits) {
        text +=
            fmt::format("        ({0}_BITS == {1}) ? ({0}_N * {0}_WORD)'({0}_{1}) :\n", name, bits);
    }
    return text + fmt::format("        {{{0}_N * {0}_WORD{{1'b0}}}};\n", name);
}

}  // namespace

std::string verilog_power_tables() {
    std::string text =
        "    // Printed from datapath/numbers/power.cpp: log2(1 + u) and 2^-f in pieces.\n"
        "    /* verilator lint_off UNUSEDPARAM */\n";
    for (int bits = 1; bits <= kLogSizes; ++bits) {
        const Power power(bits, 1);
        const OctaveLog2& log = power.log2();
        text += table_text(fmt::format("LOG_{}", bits), log.pieces().size(), log.word_bits(),
                           [&log](std::size_t i) { return log.word(i); });
    }
    for (int bits = 1; bits <= kExpSizes; ++bits) {
        const Power power(1, bits);
        text += table_text(fmt::format("EXP_{}", bits), power.pieces().size(), power.word_bits(),
                           [&power](std::size_t i) { return power.word(i); });
    }
    return text + choice_text("LOG", kLogSizes) + choice_text("EXP", kExpSizes) +
           "    /* verilator lint_on UNUSEDPARAM */\n";
}

}  // namespace repousse::cosim
