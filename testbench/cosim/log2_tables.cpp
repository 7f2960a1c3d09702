#include "testbench/cosim/log2_tables.h"

#include <fmt/format.h>

#include "datapath/numbers/log2.h"

namespace repousse::cosim {
namespace {

using Pieces = OctaveLog2::Pieces;

constexpr std::size_t kWordsPerLine = 6;

std::string name_of(Pieces kind, int index_bits) {
    return fmt::format("{}_{}", kind == Pieces::Linear ? "LINEAR" : "QUADRATIC", index_bits);
}

/// One table as a concatenation, the last word first.
std::string table_text(Pieces kind, int index_bits) {
    const OctaveLog2 table(kind, index_bits);
    const std::size_t n = table.pieces().size();
    std::string text = fmt::format("\n    localparam [{}:0] {} = {{", table.table_bits() - 1,
                                   name_of(kind, index_bits));
    for (std::size_t i = n; i-- > 0;) {
        if ((n - 1 - i) % kWordsPerLine == 0) text += "\n       ";
        text += fmt::format(" {}'h{:0{}x}{}", table.word_bits(), table.word(i),
                            (table.word_bits() + 3) / 4, i == 0 ? "" : ",");
    }
    return text + "\n    };\n";
}

}  // namespace

std::string verilog_log2_tables() {
    std::string text =
        "    // Printed from datapath/numbers/log2.cpp: log2(1 + u) over an octave in pieces.\n"
        "    /* verilator lint_off UNUSEDPARAM */\n";
    std::string choice;
    for (const Pieces kind : {Pieces::Linear, Pieces::Quadratic}) {
        const int most = kind == Pieces::Linear ? 8 : 5;
        for (int bits = 1; bits <= most; ++bits) {
            text += table_text(kind, bits);
            choice +=
                fmt::format("        (QUADRATIC {} 0 && INDEX_BITS == {}) ? (N * WORD)'({}) :\n",
                            kind == Pieces::Linear ? "==" : "!=", bits, name_of(kind, bits));
        }
    }
    return text + "\n    localparam [N*WORD-1:0] TABLE =\n" + choice +
           "        {N * WORD{1'b0}};\n    /* verilator lint_on UNUSEDPARAM */\n";
}

}  // namespace repousse::cosim
