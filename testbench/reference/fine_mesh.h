#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace repousse::reference {

/// What a vertex of a remeshed mesh is, independent of its bits: the same name from every triangle
/// around it. Ids of base vertices and numbers of base triangles are below 2^24, steps and grid
/// coordinates within +-8191.
struct FineName {
    enum class Kind : uint8_t { Vertex, Edge, Inside };
    Kind kind = Kind::Vertex;
    uint32_t first = 0;   ///< Vertex: its id. Edge: the lower id. Inside: the base triangle
    uint32_t second = 0;  ///< Edge: the higher id
    int32_t a = 0;        ///< Edge: step from the vertex with the lower id. Inside: grid coordinate
    int32_t b = 0;        ///< Inside: grid coordinate on the second axis
};

/// What a remeshed mesh must have none of, and counts to compare.
struct FineReport {
    std::size_t triangles = 0;
    std::size_t vertices = 0;       ///< distinct names
    std::size_t base_edges = 0;     ///< distinct base edges with fine vertices on them
    std::size_t edge_vertices = 0;  ///< distinct names on base edges
    std::size_t degenerate = 0;     ///< fine triangles with one name twice
    std::size_t open_edges = 0;  ///< fine half-edges without exactly one partner: holes, overlaps
                                 ///< and T-vertices all show as these
    std::size_t rim_edges = 0;   ///< of these, along a base edge that is open or not manifold
    std::size_t rim_base_edges = 0;         ///< distinct base edges with a rim edge
    std::size_t cracked = 0;                ///< names that came with more than one set of bits
    std::size_t cracked_edge_vertices = 0;  ///< of these, on base edges
    std::size_t cracked_base_edges = 0;     ///< base edges with one or more of those

    /// Watertight: closed but for the base mesh's own rim, and one set of bits for each name.
    bool watertight() const { return open_edges == rim_edges && cracked == 0 && degenerate == 0; }
};

/// Judges a remeshed mesh by the names of its vertices, without tolerance. A mesh in which every
/// fine edge pairs with just one other has neither holes nor T-vertices, and if each name has one
/// set of bits, no cracks.
class FineMeshChecker {
public:
    /// Starts a mesh of these base triangles, given by the ids of their corners.
    void start(const std::vector<std::array<uint32_t, 3>>& base);

    /// A vertex as some base triangle made it. `digest` stands for all its bits: a 64-bit hash.
    void add_vertex(const FineName& name, uint64_t digest) {
        vertices_.push_back({key_of(name), digest});
    }

    /// A fine triangle of the current base triangle.
    void add_triangle(const std::array<FineName, 3>& triangle);

    /// The current base triangle is complete: pairs its half-edges and vertices, so that only
    /// what it shares with others is kept.
    void finish_base();

    FineReport finish();

private:
    using Key = uint64_t;
    struct HalfEdge {
        Key low = 0, high = 0;
        bool down = false;  ///< runs from `high` to `low`
    };
    struct Occurrence {
        Key name = 0;
        uint64_t digest = 0;
    };
    static Key key_of(const FineName& name);
    static bool is_inside(Key key) { return (key >> 62) == 2; }
    void pair_half_edges(std::vector<HalfEdge>& edges, std::vector<HalfEdge>& unpaired);
    const std::pair<uint32_t, uint32_t>* rim_of(const HalfEdge& edge) const;
    void count_vertices(std::vector<Occurrence>& vertices);

    FineReport report_;
    std::vector<std::pair<uint32_t, uint32_t>>
        rim_;  ///< base edges without one partner, lower first
    std::vector<Occurrence> vertices_, shared_vertices_;
    std::vector<HalfEdge> half_edges_, shared_half_edges_;
};

/// A running 64-bit digest of words, for FineMeshChecker.
class Digest {
public:
    void add(uint64_t word) {
        value_ = (value_ ^ word) * 0x9E3779B97F4A7C15ULL;
        value_ ^= value_ >> 32;
    }
    uint64_t value() const { return value_; }

private:
    uint64_t value_ = 0x6A09E667F3BCC908ULL;
};

}  // namespace repousse::reference
