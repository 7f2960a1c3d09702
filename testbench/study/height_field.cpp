#include "testbench/study/height_field.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "datapath/pipelines/adaptive.h"
#include "testbench/host/draw.h"
#include "testbench/host/files.h"
#include "testbench/host/map/npz_reader.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/host/scene/assets.h"
#include "tlm/config/profile_reader.h"

namespace repousse::study {
namespace {

template <class P>
Result<std::vector<reference::LeafTriangle>> leaves_of(const Profile& profile,
                                                       const host::DrawInputs& inputs) {
    const auto draw = host::make_draw<P>(profile, inputs);
    if (!draw) return draw.error();
    const int frac = std::is_same_v<P, Real> ? 0 : profile.position.frac;
    std::vector<reference::LeafTriangle> leaves;
    AdaptivePipeline<P> pipeline(profile, *draw);
    const bool fits = pipeline.run([&](Span<const OutputTriangle<P>> triangles) {
        for (const auto& triangle : triangles) {
            reference::LeafTriangle leaf;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto& p = triangle.corners[k].displaced;
                leaf.corners[k].position = {std::ldexp(double(p.x), -frac),
                                            std::ldexp(double(p.y), -frac),
                                            std::ldexp(double(p.z), -frac)};
            }
            leaves.push_back(leaf);
        }
    });
    if (!fits) return Error{ErrorKind::Mismatch, "triangle_stack", "the bound is broken", {}, {}};
    return leaves;
}

}  // namespace

Result<HeightField> HeightField::open(const std::string& npz_path, int column, int row, int size,
                                      double spacing_m) {
    const auto bytes = host::read_file(npz_path);
    if (!bytes) return bytes.error();
    const auto grid = host::read_npz(*bytes, npz_path);
    if (!grid) return grid.error();
    HeightField field;
    const auto map = host::crop(host::quantise(*grid), column, row, size, size);
    if (!map) return map.error();
    field.map_ = *map;
    field.map_.range_low = grid->low;
    field.map_.range_high = grid->high;
    for (int y = row; y < row + size; ++y) {
        for (int x = column; x < column + size; ++x) {
            const auto at = static_cast<std::size_t>(y * grid->width + x);
            field.elevation_m_.push_back(grid->samples[at]);
        }
    }
    field.spacing_m_ = spacing_m;
    const auto profile = shipped_profile("default");
    if (!profile) return profile.error();
    field.profile_ = *profile;
    return field;
}

Result<HeightField::Leaves> HeightField::tessellate(const Setting& setting) const {
    const double side_m = spacing_m_ * (size() - 1);
    const host::Mesh mesh = host::make_grid(setting.quads, setting.quads, {side_m, side_m});
    host::DrawInputs inputs;
    inputs.mesh = &mesh;
    inputs.map = &map_;
    inputs.filter = host::HeightFilter::Bilinear;
    inputs.uv = host::UvSpan::Centres;
    inputs.texel_size = host::texel_size(mesh, map_, inputs.uv);
    host::AdaptiveSettings& s = inputs.settings;
    s.generation_cap = setting.cap;
    if (!setting.average_lsb && !setting.sum && !setting.normal) s.generation_cap = 0;
    s.height_mode = setting.sum ? host::HeightMode::Sum : host::HeightMode::Average;
    s.height_threshold = setting.sum ? setting.sum : setting.average_lsb;
    s.normal_threshold = setting.normal;
    if (setting.ref) return leaves_of<Real>(host::reference_profile(profile_), inputs);
    return leaves_of<Fixed>(profile_, inputs);
}

reference::HeightError HeightField::error(const Leaves& leaves) const {
    const reference::SampleLattice samples{size(), size(), 0, spacing_m_, 0, spacing_m_};
    return reference::height_error(leaves, samples, [this](int x, int y) {
        return elevation_m_[static_cast<std::size_t>(y * size() + x)];
    });
}

Result<Quality> HeightField::measure(const Setting& setting, std::size_t budget) const {
    const auto leaves = tessellate(setting);
    if (!leaves) return leaves.error();
    if (leaves->size() > budget) return Quality{setting, leaves->size(), 0, 0};
    const auto found = error(*leaves);
    if (found.samples != elevation_m_.size()) {
        return Error{ErrorKind::Mismatch, "study", "the mesh does not cover every sample", {}, {}};
    }
    return Quality{setting, leaves->size(), found.rms, found.max};
}

Result<std::vector<SizeClass>> HeightField::by_size(const Setting& setting) const {
    const auto leaves = tessellate(setting);
    if (!leaves) return leaves.error();
    const auto extent = [this](const reference::LeafTriangle& leaf) {
        double longest = 0;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const auto& c = leaf.corners;
            const auto [low, high] =
                std::minmax({c[0].position[axis], c[1].position[axis], c[2].position[axis]});
            longest = std::max(longest, (high - low) / spacing_m_);
        }
        return longest;
    };
    const auto squares = [](const reference::HeightError& e) {
        return e.rms * e.rms * static_cast<double>(e.samples);
    };
    // Each class is what it adds to all smaller ones, so that a sample on the edge between two
    // triangles counts once.
    const reference::HeightError whole = error(*leaves);
    std::vector<SizeClass> classes;
    Leaves part;
    reference::HeightError before;
    for (double high = 2; high / 2 < size(); high *= 2) {
        const std::size_t smaller = part.size();
        for (const auto& leaf : *leaves) {
            const double e = extent(leaf);
            if (e <= high && (e > high / 2 || high == 2)) part.push_back(leaf);
        }
        const reference::HeightError e = error(part);
        classes.push_back({high, double(part.size() - smaller) / double(leaves->size()),
                           double(e.samples - before.samples) / double(whole.samples),
                           (squares(e) - squares(before)) / squares(whole)});
        before = e;
    }
    return classes;
}

}  // namespace repousse::study
