#include <cmath>

#include <fmt/format.h>

#include "datapath/units/triangle_setup_desc.h"
#include "testbench/study/paragraph.h"
#include "testbench/study/sweep.h"

namespace repousse::study {
namespace {

const char* name_of(AdderKind kind) {
    static constexpr const char* kNames[] = {"plain", "canonical", "exact"};
    return kNames[static_cast<std::size_t>(kind)];
}

const char* name_of(ZTableKind kind) {
    static constexpr const char* kNames[] = {"uniform", "octaves, linear", "octaves, quadratic"};
    return kNames[static_cast<std::size_t>(kind)];
}

double percent(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0 : 100.0 * double(part) / double(whole);
}

std::string work_section(const SweepReport& report) {
    std::string text = "## Work by size of triangle\n\n";
    text += paragraph(
        "Triangles that face the viewer, corners uniform in a square of so many grid units. An "
        "addition is one of whole vertices, the only arithmetic in the loop; a quad is a step that "
        "moves both sides. Commands are those of the stripping unit, init included. Sent vertices "
        "are what one lane makes, displaced ones what two lanes with a column FIFO of 256 vertices "
        "make; half a vertex a triangle is the least there can be. Fine triangles are compared "
        "with twice the base triangle's area in grid units.");
    text +=
        "| px | base triangles | fine ones each | over 2 area | additions / quad | commands | "
        "swaps "
        "| sent | displaced | additions, one lane | additions, two lanes | steps, two lanes |\n"
        "|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
    for (const SweepSizeRow& row : report.sizes) text += markdown_row(row);
    text += "\n" + paragraph(
                       "All columns from `commands` on are for each fine triangle. One lane makes "
                       "an addition a cycle, two lanes a step: these columns are the cycles that "
                       "`sweep_line` takes where nothing else holds it up.");
    return text;
}

std::string setup_section(const SweepReport& report) {
    std::string text = "## Where setup is the bottleneck\n\n";
    text += paragraph(fmt::format(
        "A setup divides {} components of three edges and two gradients, a quotient a cycle from "
        "each divider, while the sweep of two lanes takes a step a cycle of the triangle before. "
        "Base triangles are those of the table above, of each size as many as make half a million "
        "fine ones.",
        kSweepComponents));
    return text + setup_bound_table(report.setups) + "\n";
}

std::string adder_head() {
    return "| adders | fraction bits | guard bits | bits, edge | bits, inside | edge points off by "
           "(ulp) | and on the screen (px) | base edges cracked | edge vertices cracked | vertices "
           "cracked inside | open "
           "edges by name |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
}

std::string adder_section(const SweepReport& report) {
    std::string text = "## What accuracy costs\n\n";
    const AdderRow& first = report.adders.front();
    text += paragraph(fmt::format(
        "Three closed meshes (20 and 320 triangles of an icosphere, 168 of a capped cylinder) "
        "under four cameras each, {} base edges with {} vertices on them. Attributes are "
        "multiplied by c and rounded to `sweep_data`; an edge point is off by its distance from "
        "the true v * c before `perspective`, in units of the last fraction bit, worst component "
        "of position, normal, texture coordinates and c. A vertex is cracked if two base "
        "triangles, or two halves of one, give it different bits behind `perspective`. Bits are "
        "those of one component's adder; exact ones include the remainder.",
        first.base_edges, first.edge_vertices));
    text += adder_head();
    for (const AdderRow& row : report.adders) text += markdown_row(row);
    text += "\n" + paragraph(
                       "Guard bits make plain edges accurate but not equal: ties fall one way from "
                       "this end and the other way from that. The exact adders' remainder costs "
                       "about as much as those guard bits, is within half a unit everywhere and "
                       "never cracks. Canonical adders never crack either, and drift by half a "
                       "unit of their last bit a step. (Elsewhere, the reference model of a widely "
                       "used tessellator was measured at 12.26 ulp with 16 fraction bits.)");
    text += paragraph(
        "More fraction bits narrow the cracks of plain adders, and leave as many; exact edges "
        "match at any number.");
    text += adder_head();
    for (const AdderRow& row : report.fractions) text += markdown_row(row);
    return text + "\n";
}

std::string depth_section(const SweepReport& report) {
    if (report.depths.empty()) return {};
    std::string text = "## Depth tables\n\n";
    text += paragraph(fmt::format(
        "z_grid = K log2(w / near) for {} lines and {} degrees, K = {:.1f}. The error is that of "
        "z_grid with its {} fraction bits, in grid units; half of the last bit, {:.4f}, is part "
        "of it. What the paper prints, a table uniform in w, is made anew for every camera; the "
        "tables by octaves are fixed, and a camera changes two registers.",
        DepthRow::kLines, DepthRow::kAngle_deg, report.depths.front().steps_per_octave,
        kGridFractionBits, std::ldexp(0.5, -kGridFractionBits)));
    text += "| table | far / near | entries | bits | error (grid units) |\n|---|--:|--:|--:|--:|\n";
    for (const DepthRow& row : report.depths) text += markdown_row(row);
    return text + "\n";
}

std::string width_section() {
    return "## Widths\n\n" +
           paragraph(fmt::format(
               "Corners lie within +-{} (s{}), so differences and steps have {} bits, and twice a "
               "step, which bounds the remainder along an edge, {} bits without a sign. Twice a "
               "projected area has {} bits while it is computed and a sign; a remainder inside is "
               "less than twice that. Slots need no guard bits: they are exact.",
               kGridLimit, kGridSlotBits, kGridDifferenceBits, kGridRemainderBits,
               kGridDeterminantBits));
}

}  // namespace

std::string markdown_row(const SweepSizeRow& r) {
    return fmt::format(
        "| {} | {} | {:.1f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | "
        "{:.3f} | {:.3f} |\n",
        r.size_px, r.base_triangles, r.fine_triangles, r.to_area, r.additions_per_quad, r.commands,
        r.swaps, r.sent, r.displaced, r.additions_one, r.additions_two, r.steps_two);
}

std::string markdown_row(const AdderRow& r) {
    return fmt::format(
        "| {} | {} | {} | {} | {} | {:.2f} | {:.4f} | {:.1f} % | {:.2f} % | {:.2f} % | {} |\n",
        name_of(r.kind), r.data_frac, r.guard_bits, r.edge_bits, r.inside_bits, r.edge_ulp,
        r.edge_px, percent(r.cracked_edges, r.base_edges),
        percent(r.cracked_vertices, r.edge_vertices), percent(r.cracked_inside, r.inside_vertices),
        r.open_edges);
}

std::string markdown_row(const DepthRow& r) {
    return fmt::format("| {} | {:.0f} | {} | {} | {:.4f} |\n", name_of(r.kind), r.far_over_near,
                       std::size_t{1} << r.index_bits, r.table_bits, r.error);
}

std::string sweep_markdown(const SweepReport& report) {
    std::string text = "# Sweep-line remeshing: work, accuracy, widths\n\n";
    text +=
        paragraph(fmt::format("Made by `repousse study sweep -o docs/sweep.md`; no measured figure "
                              "is typed by hand. Seed "
                              "{}.",
                              report.seed));
    return text + work_section(report) + setup_section(report) + adder_section(report) +
           depth_section(report) + width_section();
}

}  // namespace repousse::study
