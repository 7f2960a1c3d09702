#include "testbench/cosim/descriptions.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "datapath/pipelines/sweep_chain_desc.h"
#include "datapath/pipelines/tessellation_tests_desc.h"
#include "datapath/units/bump_desc.h"
#include "datapath/units/controller_desc.h"
#include "datapath/units/displace_desc.h"
#include "datapath/units/edge_iter_desc.h"
#include "datapath/units/footprint_desc.h"
#include "datapath/units/grid_transform_desc.h"
#include "datapath/units/height_test_desc.h"
#include "datapath/units/mid_vertex_desc.h"
#include "datapath/units/normal_test_desc.h"
#include "datapath/units/normalise_desc.h"
#include "datapath/units/perspective_desc.h"
#include "datapath/units/shade_desc.h"
#include "datapath/units/split_desc.h"
#include "datapath/units/strip_desc.h"
#include "datapath/units/sweep_line_desc.h"
#include "datapath/units/texcoord_test_desc.h"
#include "datapath/units/texel_cache_desc.h"
#include "datapath/units/triangle_buffer_desc.h"
#include "datapath/units/triangle_setup_desc.h"
#include "datapath/units/triangle_stack_desc.h"
#include "datapath/units/vertex_transform_desc.h"
#include "datapath/units/view_clip_desc.h"
#include "datapath/units/view_test_desc.h"
#include "testbench/cosim/engine_builder.h"
#include "testbench/cosim/log2_tables.h"
#include "testbench/cosim/parameters.h"
#include "testbench/cosim/power_tables.h"
#include "testbench/cosim/sine_tables.h"

namespace repousse::cosim {
namespace {

namespace fs = std::filesystem;

const char* kind_name(PortKind kind) {
    switch (kind) {
        case PortKind::Input:
            return "in";
        case PortKind::Output:
            return "out";
        case PortKind::Config:
            return "register";
    }
    return "";
}

/// `s14.8`, without modes: on a port nothing is rounded any more.
std::string plain_format(Format format) {
    format.quantization = {};
    format.overflow = {};
    return to_string(format);
}

/// Text for a cell of a Markdown table.
std::string cell(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '|') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

/// The text of a file, empty if there is none.
std::string read_text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// The sheet with its tables replaced; fails if the markers are not there.
Result<std::string> with_tables(const fs::path& path, const std::string& sheet,
                                const std::string& tables) {
    const std::size_t begin = sheet.find(kTablesBegin);
    const std::size_t end = sheet.find(kTablesEnd);
    if (begin == std::string::npos || end == std::string::npos || end < begin) {
        return Error{ErrorKind::Input,
                     path.string(),
                     "no place for the tables",
                     fmt::format("the lines \"{}\" and \"{}\"", kTablesBegin, kTablesEnd),
                     {}};
    }
    return sheet.substr(0, begin) + kTablesBegin + "\n" + tables + sheet.substr(end);
}

}  // namespace

std::vector<const UnitDesc*> unit_descriptions() {
    return {&kTriangleStackDesc,
            &kEdgeIterDesc,
            &kMidVertexDesc,
            &kTexcoordTestDesc,
            &kViewTestDesc,
            &kDisplaceDesc,
            &kBumpDesc,
            &kNormalTestDesc,
            &kHeightTestDesc,
            &kVertexTransformDesc,
            &kViewClipDesc,
            &kPerspectiveDesc,
            &kNormaliseDesc,
            &kSplitDesc,
            &kStripDesc,
            &kGridTransformDesc,
            &kTriangleSetupDesc,
            &kSweepLineDesc,
            &kControllerDesc,
            &kTriangleBufferDesc,
            &kShadeDesc,
            &kTexelCacheDesc,
            &kFootprintDesc,
            &kSweepChainDesc,
            &kTessellationTestsDesc};
}

std::string verilog_parameters(const UnitDesc& desc, const Profile& profile) {
    const std::vector<Parameter> list = parameters(desc, profile);
    std::size_t longest = 0;
    for (const Parameter& p : list) longest = std::max(longest, p.name.size());
    std::string text = fmt::format(
        "    // Printed from datapath/{}/{}_desc.h; the defaults are the profile `default`.\n"
        "    // A unit need not use all that an entry gives.\n"
        "    /* verilator lint_off UNUSEDPARAM */\n",
        desc.parts.empty() ? "units" : "pipelines", desc.name);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string value = std::to_string(list[i].value) + (i + 1 < list.size() ? "," : "");
        text += fmt::format("    parameter integer {:<{}} = {:<3}  // {}\n", list[i].name, longest,
                            value, list[i].doc);
    }
    return text + "    /* verilator lint_on UNUSEDPARAM */\n";
}

std::string sheet_tables(const UnitDesc& desc, const Profile& profile) {
    std::string text = "\n| port | direction | format | meaning |\n|---|---|---|---|\n";
    for (const Port& port : desc.ports) {
        const int elements = port_elements(port, profile);
        const std::string times = port.count_key.empty() ? "" : fmt::format("{} x ", elements);
        text += fmt::format("| `{}` | {} | {}`{}` | {} |\n", port.name, kind_name(port.kind), times,
                            plain_format(port_format(port, profile)), cell(port.doc));
    }
    text += "\n| profile entry | value in `default` |\n|---|---|\n";
    for (const ProfileEntry& entry : profile_entries()) {
        for (const std::string_view key : desc.keys) {
            if (key != entry.key) continue;
            text += fmt::format("| `{}` | `{}` |\n", key, entry_text(profile, entry));
        }
    }
    text += fmt::format(
        "\n| latency | interval | capacity | backward latency |\n|---|---|---|---|\n"
        "| {} | {} | {} | {} |\n\n",
        desc.latency, desc.interval, desc.capacity, desc.backward_latency);
    return text;
}

Result<std::vector<PrintedFile>> print_descriptions(const fs::path& root, const Profile& profile) {
    std::vector<PrintedFile> files;
    for (const UnitDesc* desc : unit_descriptions()) {
        const std::string name(desc->name);
        const fs::path folder = rtl_folder(*desc);
        if (fs::exists(root / folder / (name + ".sv"))) {
            const fs::path path = folder / (name + "_params.svh");
            const std::string text = verilog_parameters(*desc, profile);
            files.push_back({path, text, read_text(root / path) != text});
        }
        const fs::path path = fs::path("docs/units") / (name + ".md");
        if (fs::exists(root / path)) {
            const std::string old = read_text(root / path);
            const Result<std::string> text = with_tables(path, old, sheet_tables(*desc, profile));
            if (!text) return text.error();
            files.push_back({path, *text, old != *text});
        }
    }
    if (const fs::path path = "rtl/units/grid_transform_tables.svh";
        fs::exists(root / "rtl/units/grid_transform.sv")) {
        const std::string text = verilog_log2_tables();
        files.push_back({path, text, read_text(root / path) != text});
    }
    if (const fs::path path = "rtl/units/bump_tables.svh"; fs::exists(root / "rtl/units/bump.sv")) {
        const std::string text = verilog_sine_tables();
        files.push_back({path, text, read_text(root / path) != text});
    }
    if (const fs::path path = "rtl/units/shade_tables.svh";
        fs::exists(root / "rtl/units/shade.sv")) {
        const std::string text = verilog_power_tables();
        files.push_back({path, text, read_text(root / path) != text});
    }
    return files;
}

}  // namespace repousse::cosim
