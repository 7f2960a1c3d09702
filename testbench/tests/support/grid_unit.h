#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "datapath/units/grid_transform.h"
#include "datapath/units/triangle_setup_desc.h"
#include "testbench/host/z_table.h"
#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/vertices.h"

namespace repousse::test {

/// A shipped profile with another depth table.
inline Profile with_table(ZTableKind kind, int index_bits, const char* shipped = "default") {
    return profile_with(shipped, {{"z_table_kind", std::to_string(static_cast<int>(kind))},
                                  {"z_table_index_bits", std::to_string(index_bits)}});
}

/// A camera over `height` lines; the grid's depth is the same for every eye and direction.
inline host::GridCamera grid_camera(double height, double fov_deg, double near, double far) {
    host::GridCamera c;
    const double focal = 0.5 * height / std::tan(fov_deg * 3.14159265358979323846 / 360);
    c.view.focal = {focal, -focal};
    c.view.near = near;
    c.w_min = c.w_scale = near;
    c.far = far;
    return c;
}

/// A unit with its registers and, if need be, its table.
class GridUnit {
public:
    GridUnit(const Profile& profile, const host::GridCamera& camera)
        : profile_(profile), camera_(camera), unit_(profile) {
        const auto made = host::make_grid_registers<Fixed>(profile, camera, table_);
        EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().message());
        if (made) registers = *made;
        configure();
    }
    void configure() { unit_.configure(registers); }
    GridTransform<Fixed>& operator*() { return unit_; }
    GridTransform<Fixed>* operator->() { return &unit_; }

    int32_t raw_w(double w) const { return to_raw(w, profile_.clip); }
    GridPoint<Fixed> at(int32_t x, int32_t y, int32_t w) { return unit_({x, y, w}); }
    /// Grid units.
    double z(int32_t w) { return std::ldexp(unit_({0, 0, w}).position[2], -kGridFractionBits); }
    double exact_z(int32_t w) const {
        return host::grid_depth(camera_, std::ldexp(w, -profile_.clip.frac));
    }
    std::size_t table_words() const { return table_.size(); }

    GridRegisters<Fixed> registers;

private:
    Profile profile_;
    host::GridCamera camera_;
    std::vector<uint32_t> table_;
    GridTransform<Fixed> unit_;
};

}  // namespace repousse::test
