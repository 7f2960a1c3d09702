#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "datapath/error.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {

/// A scenario with the outputs that belong to it, and where it stands in a file.
struct Recorded {
    Scenario scenario;
    std::vector<int64_t> outputs;
    int first_line = 0;
};

/// The outputs that the datapath gives to scenarios.
std::vector<Recorded> record(UnitModel& model, std::vector<Scenario> scenarios);

/// How much a vector file holds.
struct VectorSizes {
    uint64_t lines = 0;    ///< transactions
    uint64_t entries = 0;  ///< of all tables
    uint64_t beats = 0;    ///< in a .beats file
};

/// Writes NAME.vec, and NAME.tables beside it for units with a read port. Both can be read by
/// Verilog's $readmemh. A file is written beside its place and then renamed.
///
/// The .vec file has one transaction a line in hexadecimal: the registers, the index of the
/// table's first entry in the .tables file (units with a read port), inputs and outputs, each as
/// wide as its port, the first one most significant. Header lines begin with `//` and name the
/// unit, the schema's version, the seed, the hash of the profile entries that the unit uses, and
/// the fields with their formats; `// table FIRST W H` describes a table, `// case NAME` begins a
/// case. The .tables file has one entry a line.
///
/// Where an item may leave as several beats, the outputs stand in NAME.beats, a beat a line without
/// leading zeros, item after item; an item's last beat is marked by its field.
Result<VectorSizes> write_vectors(const std::filesystem::path& path, const UnitModel& model,
                                  const std::vector<Recorded>& recorded, uint64_t seed);

/// Reads a file back. It must be for this unit, these fields and this profile; errors are
/// `file:line:column: ...`.
Result<std::vector<Recorded>> read_vectors(const std::filesystem::path& path,
                                           const UnitModel& model);

/// The hash of the profile entries that a unit uses, as the header has it.
uint64_t parameter_hash(const UnitModel& model);

/// The files of a .vec file's tables and beats.
std::filesystem::path tables_path(std::filesystem::path path);
std::filesystem::path beats_path(std::filesystem::path path);

}  // namespace repousse::cosim
