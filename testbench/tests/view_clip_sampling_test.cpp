// Conservative clipping against brute force: cameras and triangles in doubles, the device's eye
// coordinates, and dense samples of the displaced surface projected without any rounding.

#include "datapath/units/view_clip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "datapath/units/vertex_transform.h"
#include "testbench/cosim/random.h"
#include "testbench/host/clip_registers.h"
#include "testbench/host/view/camera.h"
#include "tlm/config/profile_reader.h"

namespace repousse {
namespace {

using cosim::Random;
using glm::dvec3;
using Registers = ClipRegisters<Fixed>;

double uniform(Random& random, double low, double high) {
    return low + std::ldexp(static_cast<double>(random.next() >> 11), -53) * (high - low);
}

dvec3 direction(Random& random) {
    for (;;) {
        const dvec3 v{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
        const double length = glm::length(v);
        if (length > 0.1 && length <= 1.0) return v / length;
    }
}

int32_t rounded(double x, const Format& format) {
    return static_cast<int32_t>(std::clamp(std::floor(std::ldexp(x, format.frac) + 0.5),
                                           static_cast<double>(format.min_raw()),
                                           static_cast<double>(format.max_raw())));
}

Vec3<int32_t> rounded(const dvec3& v, const Format& format) {
    return {rounded(v.x, format), rounded(v.y, format), rounded(v.z, format)};
}

struct Corner {
    dvec3 position;
    dvec3 normal;
};
using Corners = std::array<Corner, 3>;

/// A camera as host and device have it.
class View {
public:
    View(const Profile& profile, const host::CameraSettings& camera, const host::Viewport& viewport)
        : projection(host::view_projection(camera, viewport)),
          frame(host::view_frame(camera, viewport)),
          registers(host::make_clip_registers<Fixed>(profile, camera, viewport)),
          profile_(profile),
          transform_(profile) {
        ViewRegisters<Fixed> r;
        r.eye = rounded(frame.eye, profile.position);
        r.right = rounded(frame.right, profile.view_row);
        r.up = rounded(frame.up, profile.view_row);
        r.forward = rounded(frame.forward, profile.view_row);
        transform_.configure(r);
    }

    /// A point that is on the picture, if only just.
    bool sees(const dvec3& p) const {
        const auto apply = [&p](const std::array<double, 4>& row) {
            return row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3];
        };
        const double w = apply(projection.w_row);
        return w >= projection.near && w <= projection.far &&
               std::abs(apply(projection.x_row)) <= w && std::abs(apply(projection.y_row)) <= w;
    }

    std::array<EyePoint<Fixed>, 3> eye(const Corners& corners) {
        std::array<EyePoint<Fixed>, 3> result;
        for (std::size_t k = 0; k < 3; ++k) {
            result[k] = transform_.eye(rounded(corners[k].position, profile_.position));
        }
        return result;
    }

    host::ViewProjection projection;
    host::ViewFrame frame;
    Registers registers;

private:
    const Profile& profile_;
    VertexTransform<Fixed> transform_;
};

/// Whether any of (n+1)(n+2)/2 points of the triangle is visible when displaced by -d .. d.
bool visible(const View& view, const Corners& corners, double d, int n) {
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; i + j <= n; ++j) {
            const double a = double(i) / n, b = double(j) / n, c = double(n - i - j) / n;
            const dvec3 p =
                a * corners[0].position + b * corners[1].position + c * corners[2].position;
            const dvec3 normal =
                a * corners[0].normal + b * corners[1].normal + c * corners[2].normal;
            const double length = glm::length(normal);
            const dvec3 unit = length > 0 ? normal / length : dvec3{0.0};
            for (const double t : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
                if (view.sees(p + t * d * unit)) return true;
            }
        }
    }
    return false;
}

host::CameraSettings random_camera(Random& random) {
    host::CameraSettings camera;
    camera.eye = uniform(random, 0, 4) * direction(random);
    camera.target = camera.eye + direction(random);
    camera.up = direction(random);
    camera.fov_deg = random.percent(20) ? uniform(random, 1, 170) : uniform(random, 25, 100);
    camera.near = std::exp(uniform(random, std::log(0.003), std::log(0.5)));
    camera.far = camera.near * uniform(random, 2, 1000);
    return camera;
}

/// Triangles of several kinds around the view volume; sets d_max.
Corners random_triangle(Random& random, const View& view, double& d) {
    Corners corners;
    d = random.percent(30)   ? 0.0
        : random.percent(60) ? std::exp(uniform(random, std::log(1e-4), std::log(0.3)))
                             : uniform(random, 0, 6);  // far more than the near distance
    const double size = std::exp(uniform(random, std::log(1e-3), std::log(4.0)));
    const dvec3 centre = random.percent(20)
                             ? view.frame.eye + 0.05 * direction(random)  // around the eye
                             : view.frame.eye + uniform(random, 0, 5) * direction(random);
    const dvec3 face = direction(random);
    for (Corner& corner : corners) {
        corner.position = centre + size * direction(random);
        corner.normal = glm::normalize(face + uniform(random, 0, 0.9) * direction(random));
    }
    return corners;
}

/// A triangle that lies just so far beyond a plane of the view that, displaced, it touches it:
/// displaced points differ from visible ones by a few LSB at most.
Corners touching_triangle(Random& random, const View& view, double lsb, double& d) {
    const host::ViewProjection& p = view.projection;
    const std::array<double, 4>& row = random.percent(50) ? p.x_row : p.y_row;
    const double side = random.percent(50) ? 1.0 : -1.0;
    const dvec3 axis{row[0], row[1], row[2]};
    const dvec3 forward{p.w_row[0], p.w_row[1], p.w_row[2]};
    dvec3 outward = glm::normalize(side * axis - forward);
    // Points of the plane in front of the eye; in place of a side sometimes near or far.
    const double far = std::min(p.far, 50.0);
    const unsigned kind = random.below(4);
    if (kind == 0) outward = -forward;
    if (kind == 1) outward = forward;
    d = random.percent(20) ? 0.0 : std::exp(uniform(random, std::log(1e-4), std::log(8.0)));
    const double gap = lsb * uniform(random, -3, 6);
    Corners corners;
    for (Corner& corner : corners) {
        const double w = kind == 0 ? p.near : kind == 1 ? p.far : uniform(random, p.near, far);
        const auto& other = &row == &p.x_row ? p.y_row : p.x_row;
        const dvec3 other_axis{other[0], other[1], other[2]};
        // x_row . v = side * w, y_row . v = t * w, w_row . v = w; the rows are perpendicular.
        const double t = uniform(random, -1, 1);
        const double s = kind < 2 ? uniform(random, -1, 1) : side;
        const dvec3 point = view.frame.eye + w * forward + s * w * axis / glm::dot(axis, axis) +
                            t * w * other_axis / glm::dot(other_axis, other_axis);
        corner.position = point + (d + gap) * outward;
        corner.normal = random.percent(50) ? outward : -outward;
    }
    if (random.percent(70)) corners[1].normal = corners[2].normal = corners[0].normal;
    return corners;
}

struct Tally {
    uint64_t triangles = 0;
    uint64_t rejected = 0;
    uint64_t invisible = 0;  ///< by dense samples
    uint64_t wrong = 0;      ///< rejected, and a sample is visible
};

/// `touching`: triangles at the border. `careless`: planes without their outward rounding, to see
/// that the samples would notice.
Tally tally(const Profile& profile, uint64_t cameras, uint64_t triangles, bool touching,
            bool careless = false) {
    Tally result;
    ViewClip<Fixed> unit(profile);
    const double lsb = std::ldexp(1.0, -profile.clip.frac);
    for (uint64_t k = 0; k < cameras; ++k) {
        Random random(k, touching);
        const host::Viewport viewport{1280, random.percent(50) ? 720 : 1280};
        View view(profile, random_camera(random), viewport);
        if (careless) view.registers.margin = 0;
        unit.configure(view.registers);
        for (uint64_t i = 0; i < triangles; ++i) {
            double d = 0;
            const Corners corners = touching ? touching_triangle(random, view, lsb, d)
                                             : random_triangle(random, view, d);
            const int32_t raw = careless ? rounded(d, profile.displacement)
                                         : *host::max_displacement_register<Fixed>(profile, d);
            const bool rejects = unit(view.eye(corners), raw);
            const bool seen = visible(view, corners, d, touching ? 4 : 10);
            ++result.triangles;
            result.rejected += rejects;
            result.invisible += !seen;
            result.wrong += rejects && seen;
        }
    }
    return result;
}

TEST(ViewClip, NeverRejectsWhatIsVisible) {
    const Tally t = tally(*shipped_profile("default"), 2000, 500, false);
    EXPECT_EQ(t.triangles, 1'000'000U);
    EXPECT_EQ(t.wrong, 0U);
    // Of those that no sample sees, most are beyond a single plane.
    EXPECT_GT(double(t.rejected), 0.8 * double(t.invisible));
    RecordProperty("invisible", std::to_string(t.invisible));
    RecordProperty("rejected", std::to_string(t.rejected));
}

TEST(ViewClip, NeverRejectsWhatIsVisibleAtTheBorder) {
    const Tally t = tally(*shipped_profile("default"), 2000, 500, true);
    EXPECT_EQ(t.wrong, 0U);
    EXPECT_GT(t.rejected, t.triangles / 20);
    EXPECT_GT(t.invisible, t.rejected) << "the border was not met";
    RecordProperty("invisible", std::to_string(t.invisible));
    RecordProperty("rejected", std::to_string(t.rejected));
}

TEST(ViewClip, NarrowProfile) {
    const Profile narrow = *shipped_profile("narrow");
    EXPECT_EQ(tally(narrow, 200, 500, false).wrong, 0U);
    EXPECT_EQ(tally(narrow, 200, 500, true).wrong, 0U);
}

TEST(ViewClip, WithoutItsMarginSamplesFindMistakes) {
    EXPECT_GT(tally(*shipped_profile("default"), 200, 500, true, true).wrong, 0U);
}

}  // namespace
}  // namespace repousse
