#include "datapath/pipelines/tessellation_tests.h"

#include <algorithm>

namespace repousse {

static_assert(ports_are(kTessellationTestsDesc, PortKind::Config,
                        {"eager", "use_view_test", "use_normal_test", "use_height_test",
                         "view_threshold", "normal_threshold", "map_space", "map_width",
                         "map_height", "wrap", "literal", "sum", "height_threshold"}));
static_assert(port_count(kTessellationTestsDesc, PortKind::Input) == 40);

// The words of the parts' own transactions stand one after the other, as their ports do in the
// description, without their skip flags.
std::array<Word, 40> TessellationTestsIn::pack() const {
    std::array<Word, 40> words{eligible};
    auto at = words.begin() + 1;
    const auto append = [&at](const auto& part) {
        at = std::copy(part.begin() + 1, part.end(), at);
    };
    append(TexcoordTestIn{false, u1, u2, u12}.pack());
    append(ViewTestIn{false, p1, p2}.pack());
    append(NormalTestIn{false, vertices}.pack());
    return words;
}

// Each part's words begin one place before its first field, where its skip flag would stand: that
// word is another field's, and the flag is not used.
TessellationTestsIn TessellationTestsIn::unpack(const Word* words) {
    const auto texcoord = TexcoordTestIn::unpack(words);
    const auto view = ViewTestIn::unpack(words + 6);
    const auto normals = NormalTestIn::unpack(words + 12);
    return {words[0] != 0, texcoord.u1, texcoord.u2,     texcoord.u12,
            view.p1,       view.p2,     normals.vertices};
}

TessellationTestsIn TessellationTestsIn::of(const Edge<Fixed>& edge, bool has_attributes) {
    const auto normals = [](const Vertex<Fixed>& v) {
        return VertexNormals{v.displaced_normal, v.map_normal, v.normal};
    };
    TessellationTestsIn in;
    in.eligible = edge.eligible;
    in.u1 = edge.v1->uv, in.u2 = edge.v2->uv, in.u12 = edge.mid.uv;
    in.p1 = edge.v1->screen, in.p2 = edge.v2->screen;
    in.vertices = {normals(*edge.v1), normals(*edge.v2),
                   has_attributes ? normals(edge.mid) : VertexNormals{}};
    return in;
}

std::array<Word, kTessellationTestsRegisters> pack_registers(const AdaptiveRegisters<Fixed>& r) {
    const auto height = r.height_test.pack();
    std::array<Word, kTessellationTestsRegisters> words{r.eager,
                                                        r.use_view_test,
                                                        r.use_normal_test,
                                                        r.use_height_test,
                                                        r.view_threshold,
                                                        r.normal_threshold,
                                                        r.normal_space == NormalSpace::Map};
    std::copy(height.begin(), height.end(), words.end() - height.size());
    return words;
}

AdaptiveRegisters<Fixed> unpack_registers(const Word* words) {
    AdaptiveRegisters<Fixed> r;
    r.eager = words[0] != 0;
    r.use_view_test = words[1] != 0;
    r.use_normal_test = words[2] != 0;
    r.use_height_test = words[3] != 0;
    r.view_threshold = words[4];
    r.normal_threshold = static_cast<int32_t>(words[5]);
    r.normal_space = words[6] != 0 ? NormalSpace::Map : NormalSpace::World;
    r.height_test = {static_cast<int>(words[7]),
                     static_cast<int>(words[8]),
                     words[9] != 0,
                     words[10] != 0 ? BoxKind::Literal : BoxKind::Square,
                     words[11] != 0 ? HeightMode::Sum : HeightMode::Average,
                     static_cast<uint64_t>(words[12])};
    return r;
}

template <class P>
TessellationTests<P>::TessellationTests(const Profile& profile,
                                        const AdaptiveRegisters<P>& registers,
                                        Span<const uint64_t> sums)
    : eager_(registers.eager), texcoord_test_(profile), split_(profile) {
    if (registers.use_view_test) {
        view_test_.emplace(profile);
        view_test_->configure(registers.view_threshold);
    }
    if (registers.use_normal_test) {
        normal_test_.emplace(profile);
        normal_test_->configure(registers.normal_threshold, registers.normal_space);
    }
    if (registers.use_height_test) {
        height_test_.emplace(profile);
        height_test_->configure(registers.height_test, sums);
    }
    split_.configure(registers.use_normal_test || registers.use_height_test);
}

template <class P>
TessellationTestsOut TessellationTests<P>::operator()(const TessellationTestsIn& in) {
    using V = typename P::Value;
    const auto vector = [](const Vec3<int32_t>& n) {
        return Vec3<V>{static_cast<V>(n.x), static_cast<V>(n.y), static_cast<V>(n.z)};
    };
    const auto point = [](const ScreenPoint<int32_t>& p) {
        return ScreenPoint<V>{static_cast<V>(p.x), static_cast<V>(p.y), p.near};
    };
    Vertex<P> v1, v2;
    Edge<P> edge;
    v1.uv = in.u1, v2.uv = in.u2, edge.mid.uv = in.u12;
    v1.screen = point(in.p1), v2.screen = point(in.p2);
    std::size_t i = 0;
    for (Vertex<P>* v : {&v1, &v2, &edge.mid}) {
        const VertexNormals& normals = in.vertices[i++];
        v->displaced_normal = vector(normals.displaced_normal);
        v->map_normal = vector(normals.map_normal);
        v->normal = vector(normals.normal);
    }
    edge.v1 = &v1, edge.v2 = &v2;
    edge.eligible = edge.undecided = in.eligible;
    run(Span<Edge<P>>(&edge, 1), [] {});
    return {edge.split, edge.ct, edge.vt, edge.nt, edge.sht};
}

template class TessellationTests<Fixed>;
template class TessellationTests<Real>;

}  // namespace repousse
