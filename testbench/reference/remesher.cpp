#include "testbench/reference/remesher.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace repousse::reference {
namespace {

using Corners = std::array<std::array<int64_t, 3>, 3>;

// floor(a / d + 1/2) for d > 0.
int64_t round_half_up(int64_t a, int64_t d) {
    const int64_t n = 2 * a + d;
    return n / (2 * d) - (n % (2 * d) < 0);
}

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Remesher {
public:
    explicit Remesher(const Corners& corners) : p_(corners) {}
    Remeshing run();

private:
    int64_t length(int p, int q) const {
        int64_t n = 0;
        for (std::size_t i = 0; i < 3; ++i) n = std::max(n, std::abs(p_[at(p)][i] - p_[at(q)][i]));
        return n;
    }
    int64_t steps(int p, int q) const { return std::max<int64_t>(1, length(p, q)); }
    int64_t s(int i) const { return p_[at(i)][at(out_.axis_a)]; }
    int64_t y(int i) const { return mirror_ * p_[at(i)][at(out_.axis_b)]; }

    /// Point k of the edge, counted from corner p.
    CoverVertex edge_point(int p, int q, int64_t k) const {
        if (k == 0) return {CoverVertex::Kind::Corner, p, 0, 0};
        if (k == steps(p, q)) return {CoverVertex::Kind::Corner, q, 0, 0};
        if ((p + 1) % 3 == q) return {CoverVertex::Kind::Edge, p, k, 0};
        return {CoverVertex::Kind::Edge, q, steps(p, q) - k, 0};
    }
    CoverVertex inside(int64_t column, int64_t row) const {
        return {CoverVertex::Kind::Interior, 0, column, mirror_ * row};
    }
    CoverVertex primary_point(int64_t column) const { return edge_point(a_, b_, column - s(a_)); }
    int64_t primary_row(int64_t column) const {
        return round_half_up(y(a_) * (s(b_) - column) + y(b_) * (column - s(a_)), s(b_) - s(a_));
    }
    void emit(const CoverVertex& a, const CoverVertex& b, const CoverVertex& c) {
        out_.triangles.push_back(flip_ ? CoverTriangle{a, c, b} : CoverTriangle{a, b, c});
    }
    int64_t determinant(int side) const {
        const auto &a = p_[at(a_)], &b = p_[at(b_)], &c = p_[at(c_)];
        const std::size_t u = at(out_.axis_a), v = at(side);
        return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
    }
    void half(int e, int f);
    void strip(int e, int f, int64_t u);

    Corners p_;
    Remeshing out_;
    int a_ = 0, b_ = 1, c_ = 2;
    int64_t mirror_ = 1;
    bool odd_ = false, flip_ = false;
    int64_t ke_ = 0;  // next point of the half's edge
};

Remeshing Remesher::run() {
    for (int e = 1; e < 3; ++e) {
        if (length(e, (e + 1) % 3) > length(a_, b_)) a_ = e, b_ = (e + 1) % 3, c_ = (e + 2) % 3;
    }
    if (length(a_, b_) == 0) {
        emit(edge_point(0, 1, 0), edge_point(1, 2, 0), edge_point(2, 0, 0));
        return out_;
    }
    while (std::abs(p_[at(a_)][at(out_.axis_a)] - p_[at(b_)][at(out_.axis_a)]) < length(a_, b_)) {
        ++out_.axis_a;
    }
    if (s(a_) > s(b_)) {
        std::swap(a_, b_);
        odd_ = true;
    }
    const int low = out_.axis_a == 0 ? 1 : 0, high = out_.axis_a == 2 ? 1 : 2;
    out_.axis_b = std::abs(determinant(high)) > std::abs(determinant(low)) ? high : low;
    mirror_ = determinant(out_.axis_b) < 0 ? -1 : 1;

    if (y(c_) < y(a_)) {
        half(b_, c_);
        half(c_, a_);
    } else if (y(b_) > y(c_)) {
        half(a_, c_);
        half(c_, b_);
    } else {
        half(a_, c_);
        half(b_, c_);
    }
    return out_;
}

void Remesher::half(int e, int f) {
    const int64_t columns = std::abs(s(f) - s(e));
    const int other = e == c_ ? (f == a_ ? b_ : a_) : (e == a_ ? b_ : a_);
    flip_ = odd_ != (s(f) < s(e));
    ke_ = e != c_ || s(other) == s(c_) ? 1 : 0;
    for (int64_t u = 0; u < columns; ++u) strip(e, f, u);
}

void Remesher::strip(int e, int f, int64_t u) {
    const int64_t columns = std::abs(s(f) - s(e)), direction = s(f) < s(e) ? -1 : 1;
    const int64_t n = steps(e, f);
    const int o = e == c_ ? (f == a_ ? b_ : a_) : (e == a_ ? b_ : a_);
    const int64_t other_steps = steps(o, c_);
    const bool beside = s(o) == s(c_), last = u == columns - 1;
    const bool other_left = beside && e == c_ && u == 0, other_right = beside && f == c_ && last;
    const bool closing = last && f != c_;
    const auto column = [&](int64_t k) {
        return k == n ? columns : std::min(round_half_up(k * columns, n), columns - 1);
    };
    const auto row = [&](int64_t k) { return round_half_up(y(e) * (n - k) + y(f) * k, n); };
    const auto other_row = [&](int64_t k) {
        return round_half_up(y(o) * (other_steps - k) + y(c_) * k, other_steps);
    };
    const int64_t left = s(e) + direction * u, right = left + direction;
    CoverVertex bl = primary_point(left), br = primary_point(right);
    int64_t rl = primary_row(left), rr = primary_row(right);
    bool on_edge = u == 0 && e != c_, done = closing;
    int64_t kl = 0, kr = 0;
    for (;;) {
        const bool edge_left = column(ke_) == u;
        const bool can_left = !on_edge || edge_left, can_right = !done;
        if (!can_left && !can_right) return;
        bool go_left = can_left && !(can_right && rl > rr);
        bool go_right = can_right && !(can_left && rr > rl);
        if (go_right && !go_left && can_left && edge_left && row(ke_) <= rr + 1) {
            std::swap(go_left, go_right);
        }
        CoverVertex tl, tr;
        int64_t top_left = 0, top_right = 0;
        if (go_left) {
            if (other_left && !on_edge) {
                tl = edge_point(o, c_, ++kl);
                top_left = other_row(kl);
                on_edge = kl == other_steps;
            } else if (on_edge || (edge_left && row(ke_) <= rl + 1)) {
                on_edge = true;
                tl = edge_point(e, f, ke_);
                top_left = row(ke_++);
                while (closing && column(ke_) == u) {
                    const CoverVertex next = edge_point(e, f, ke_);
                    emit(bl, next, tl);
                    tl = next;
                    top_left = row(ke_++);
                }
            } else {
                top_left = rl + 1;
                tl = inside(left, top_left);
            }
        }
        if (go_right) {
            if (go_left && column(ke_) == u && row(ke_) <= rr + 1) {
                go_right = false;
            } else if (other_right) {
                tr = edge_point(o, c_, ++kr);
                top_right = other_row(kr);
                done = kr == other_steps;
            } else if (column(ke_) == u + 1 && row(ke_) <= rr + 1) {
                tr = edge_point(e, f, ke_);
                top_right = row(ke_);
                done = true;
            } else {
                top_right = rr + 1;
                tr = inside(right, top_right);
            }
        }
        if (go_left) emit(bl, br, tl);
        if (go_right && go_left) emit(br, tr, tl);
        if (go_right && !go_left) emit(bl, br, tr);
        if (go_left) bl = tl, rl = top_left;
        if (go_right) br = tr, rr = top_right;
    }
}

}  // namespace

Remeshing remesh(const std::array<std::array<int64_t, 3>, 3>& corners) {
    return Remesher(corners).run();
}

}  // namespace repousse::reference
