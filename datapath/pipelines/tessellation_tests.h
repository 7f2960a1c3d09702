#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "datapath/pipelines/draw.h"
#include "datapath/pipelines/tessellation_tests_desc.h"
#include "datapath/units/split.h"
#include "datapath/units/texcoord_test.h"
#include "datapath/units/view_test.h"

namespace repousse {

/// One edge as it enters the Tessellation Tests: the input ports of the description.
struct TessellationTestsIn {
    bool eligible = true;
    Uv u1, u2, u12;
    ScreenPoint<int32_t> p1, p2;
    std::array<VertexNormals, 3> vertices;  ///< end 1, end 2, the midpoint

    std::array<Word, 40> pack() const;
    static TessellationTestsIn unpack(const Word* words);

    /// The edge of a batch. Where nothing has asked for the midpoint's attributes they are zero.
    static TessellationTestsIn of(const Edge<Fixed>& edge, bool has_attributes);
};

/// What they say of it: the output ports.
struct TessellationTestsOut {
    bool split = false, ct = true, vt = true, nt = false, sht = false;

    std::array<Word, 5> pack() const { return {split, ct, vt, nt, sht}; }
    static TessellationTestsOut of(const Edge<Fixed>& edge) {
        return {edge.split, edge.ct, edge.vt, edge.nt, edge.sht};
    }
};
static_assert(ports_are(kTessellationTestsDesc, PortKind::Output,
                        {"split", "ct", "vt", "nt", "sht"}));

/// The registers as words, in the order of the description's ports. Only those of the tests are
/// among them: the cap and the order of the stack belong to other units.
inline constexpr std::size_t kTessellationTestsRegisters =
    port_count(kTessellationTestsDesc, PortKind::Config);
std::array<Word, kTessellationTestsRegisters> pack_registers(
    const AdaptiveRegisters<Fixed>& registers);
AdaptiveRegisters<Fixed> unpack_registers(const Word* words);

/// The Tessellation Tests (Doggett and Hirche 2000, section 3.1, figure 8): the four tests of an
/// edge in the hardware's order, and the first half of Pass or Tessellate, which decides.
///
///  1. ct, vt, nt, sht, one after the other. An edge that may not be split, or for which ct or vt
///     said no, is decided: later tests let it pass, and what they would have said stays at its
///     neutral value (ct = vt = 1, nt = sht = 0). After nt said yes, sht has nothing to add.
///  2. Eager tests work on every edge. The decision is the same.
///  3. split = eligible & ct & vt & (nt | sht), where a test that is not used is neutral; without
///     nt and sht every edge counts as detailed.
///
/// The midpoint's normal is needed by the Normal Test alone, so whoever makes it (New N, New N_D
/// and Bump in the figure) is called between the View Test and the Normal Test.
template <class P>
class TessellationTests {
public:
    /// `sums` is the Summed Height Test's table, which must outlive this; empty without that test.
    TessellationTests(const Profile& profile, const AdaptiveRegisters<P>& registers,
                      Span<const uint64_t> sums);

    /// Tests and decides edges whose ends are complete and whose midpoints have their U.
    /// `make_normals()` is called once if there is a Normal Test: it gives the midpoints of
    /// undecided edges (of all when eager) their normals.
    template <class MakeNormals>
    void run(Span<Edge<P>> edges, const MakeNormals& make_normals) {
        texcoord_test_.run(edges, eager_);
        if (view_test_) view_test_->run(edges, eager_);
        if (normal_test_) {
            make_normals();
            normal_test_->run(edges, eager_);
        }
        if (height_test_) height_test_->run(edges, eager_);
        split_.decide(edges);
    }

    /// One transaction of the unit.
    TessellationTestsOut operator()(const TessellationTestsIn& in);

    const TexcoordTest& texcoord_test() const { return texcoord_test_; }
    const std::optional<ViewTest<P>>& view_test() const { return view_test_; }
    const std::optional<NormalTest<P>>& normal_test() const { return normal_test_; }
    const std::optional<HeightTest>& height_test() const { return height_test_; }
    std::optional<HeightTest>& height_test() { return height_test_; }

    /// The same unit cuts the triangles of the edges that are split.
    const Split<P>& split() const { return split_; }
    Split<P>& split() { return split_; }

private:
    bool eager_;
    TexcoordTest texcoord_test_;
    std::optional<ViewTest<P>> view_test_;
    std::optional<NormalTest<P>> normal_test_;
    std::optional<HeightTest> height_test_;
    Split<P> split_;
};

}  // namespace repousse
