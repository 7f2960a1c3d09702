#pragma once

#include <optional>
#include <string>
#include <vector>

#include "datapath/error.h"
#include "datapath/profile.h"
#include "testbench/host/map/height_map.h"
#include "testbench/reference/leaf_mesh.h"

namespace repousse::study {

/// How an elevation map is tessellated from a base grid. Without a threshold it stays the grid.
struct Setting {
    int quads = 1;                      ///< base grid: quads x quads
    std::optional<int> cap;             ///< generation cap; absent: the natural one
    std::optional<double> average_lsb;  ///< AVG threshold, height LSB
    std::optional<double> sum;          ///< SUM threshold, height LSB x texel^2
    std::optional<double> normal;       ///< normal threshold
    bool ref = false;                   ///< level ref instead of lt
};

/// A part of a tessellation: the triangles of similar size.
struct SizeClass {
    double longest = 0;         ///< upper bound of the triangles' extents, in samples
    double triangle_share = 0;  ///< of all triangles
    double area_share = 0;      ///< of all samples
    double error_share = 0;     ///< of all squared errors
};

/// What came out.
struct Quality {
    Setting setting;
    std::size_t triangles = 0;
    double rms_m = 0;  ///< vertical error at every sample, metres
    double max_m = 0;
};

/// A square part of an elevation map as a height field: one world unit is a metre, samples are
/// `spacing_m` apart, texture coordinates run from the first sample's centre to the last one's,
/// heights are read bilinearly.
class HeightField {
public:
    /// Errors: the file, or a part that is not inside it.
    static Result<HeightField> open(const std::string& npz_path, int column, int row, int size,
                                    double spacing_m);

    /// Tessellates with the default profile and measures the vertical distance of the mesh from
    /// every sample. Above `budget` triangles the distance is not measured.
    Result<Quality> measure(const Setting& setting, std::size_t budget = ~std::size_t{0}) const;

    /// Where the triangles and the error are, by the triangles' size: up to 2, 4, 8, ... samples.
    Result<std::vector<SizeClass>> by_size(const Setting& setting) const;

    int size() const { return map_.width; }

private:
    using Leaves = std::vector<reference::LeafTriangle>;
    Result<Leaves> tessellate(const Setting& setting) const;
    reference::HeightError error(const Leaves& leaves) const;

    host::HeightMap map_;
    std::vector<double> elevation_m_;  ///< as in the file, not as quantised
    double spacing_m_ = 1;
    Profile profile_;
};

}  // namespace repousse::study
