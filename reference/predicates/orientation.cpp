// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/predicates/orientation.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace pcm::reference {
namespace {

/// a + b s for s -> 0+; products keep no s^2, for the determinants below are linear in s: all shifted rows are shifted
/// by the same vector, so subtracting one of them from the others leaves s in one row only.
struct Linear {
  Exact constant, slope;

  friend Linear operator+(const Linear& a, const Linear& b) { return {a.constant + b.constant, a.slope + b.slope}; }
  friend Linear operator-(const Linear& a, const Linear& b) { return {a.constant - b.constant, a.slope - b.slope}; }
  friend Linear operator*(const Linear& a, const Linear& b) {
    return {a.constant * b.constant, a.constant * b.slope + a.slope * b.constant};
  }
};

int sign_of(const Linear& x) {
  const int constant = reference::sign_of(x.constant);
  return constant != 0 ? constant : reference::sign_of(x.slope);
}

/// Determinant by expansion along the first row.
template <int N>
Linear generic_determinant(const std::array<std::array<Linear, N>, N>& m) {
  if constexpr (N == 1) {
    return m[0][0];
  } else {
    Linear sum{Exact(0), Exact(0)};
    for (int column = 0; column < N; ++column) {
      if (reference::sign_of(m[0][column].constant) == 0 && reference::sign_of(m[0][column].slope) == 0) continue;
      std::array<std::array<Linear, N - 1>, N - 1> minor;
      for (int i = 1; i < N; ++i)
        for (int j = 0, k = 0; j < N; ++j)
          if (j != column) minor[i - 1][k++] = m[i][j];
      const Linear term = m[0][column] * generic_determinant<N - 1>(minor);
      sum = column % 2 == 0 ? sum + term : sum - term;
    }
    return sum;
  }
}

/// The power of eps that a matching carries, given each point's rank.
template <int D>
int power_of(const PerturbationTerm<D>& matching, const std::array<int, D + 1>& rank) {
  int power = 0;
  for (int point = 0; point <= D; ++point)
    if (matching[point] >= 0) power += 1 << (3 * (rank[point] + 1) - (matching[point] + 1));
  return power;
}

/// Every partial matching of points to coordinates, with the power of eps it carries. Only the order of the ranks
/// matters for the order of the powers (they are sums of distinct powers of two), so ranks 1 .. D + 1 stand for all.
template <int D>
std::vector<PerturbationTerm<D>> make_terms() {
  std::vector<std::pair<int, PerturbationTerm<D>>> terms;
  std::array<int, D + 1> rank;
  std::iota(rank.begin(), rank.end(), 0);
  PerturbationTerm<D> term;
  const auto extend = [&](const auto& self, int point) -> void {
    if (point > D) {
      terms.emplace_back(power_of<D>(term, rank), term);
      return;
    }
    term[point] = -1;
    self(self, point + 1);
    for (int coordinate = 0; coordinate < D; ++coordinate) {
      if (std::find(term.begin(), term.begin() + point, coordinate) != term.begin() + point) continue;
      term[point] = coordinate;
      self(self, point + 1);
    }
  };
  extend(extend, 0);
  std::sort(terms.begin(), terms.end());
  std::vector<PerturbationTerm<D>> sorted;
  for (const auto& [power, matching] : terms) sorted.push_back(matching);
  return sorted;
}

template <int D>
using Rows = std::array<std::array<Linear, D + 1>, D + 1>;

/// Which place each vertex has among `all`, which are different ones.
template <int D>
std::array<int, D + 1> ranks_among(const std::array<Vertex, D + 1>& vertices, const auto& all) {
  std::array<int, D + 1> rank{};
  for (int v = 0; v <= D; ++v)
    rank[v] = static_cast<int>(std::count_if(all.begin(), all.end(), [&](Vertex u) { return u < vertices[v]; }));
  return rank;
}

/// The coefficient of one term in the determinant of the rows.
template <int D>
Linear coefficient(Rows<D> rows, const std::array<int, D + 1>& rank, const PerturbationTerm<D>& term) {
  for (int v = 0; v <= D; ++v) {
    if (term[rank[v]] < 0) continue;
    for (int j = 0; j <= D; ++j) rows[v][j] = {Exact(j == term[rank[v]] + 1 ? 1 : 0), Exact(0)};
  }
  return generic_determinant<D + 1>(rows);
}

}  // namespace

template <int D>
const std::vector<PerturbationTerm<D>>& perturbation_terms() {
  static const std::vector<PerturbationTerm<D>> terms = make_terms<D>();
  return terms;
}
template const std::vector<PerturbationTerm<2>>& perturbation_terms<2>();
template const std::vector<PerturbationTerm<3>>& perturbation_terms<3>();

bool Orientation::is_shifted(Vertex v) const {
  if (!shifted_ || shifted_->side != v.side) return false;
  const Triangle& t = pose_.face(shifted_->side, shifted_->face);
  return std::find(t.begin(), t.end(), v.index) != t.end();
}

/// Rows (1, x, y, z); one row for each vertex.
template <int D>
auto Orientation::rows_of(const std::array<Vertex, D + 1>& vertices) const {
  Vec3<Exact> normal{Exact(0), Exact(0), Exact(0)};
  if (std::any_of(vertices.begin(), vertices.end(), [this](Vertex v) { return is_shifted(v); })) {
    const auto [p0, p1, p2] = pose_.corners<Exact>(shifted_->side, shifted_->face);
    normal = doubled_normal(p0, p1, p2);
  }
  Rows<D> rows;
  for (int v = 0; v <= D; ++v) {
    const Vec3<Exact> point = pose_.point<Exact>(vertices[v]);
    rows[v][0] = {Exact(1), Exact(0)};
    for (int j = 0; j < D; ++j) rows[v][j + 1] = {point[j], is_shifted(vertices[v]) ? -normal[j] : Exact(0)};
  }
  return rows;
}

template <int D>
int Orientation::tie_rule(const std::array<Vertex, D + 1>& vertices) const {
  const Rows<D> rows = rows_of<D>(vertices);
  const std::array<int, D + 1> rank = ranks_among<D>(vertices, vertices);
  for (const PerturbationTerm<D>& term : perturbation_terms<D>())
    if (const int sign = sign_of(coefficient<D>(rows, rank, term)); sign != 0) return sign;
  assert(false && "the coefficients of full matchings are +1 or -1");
  return 0;
}

int Orientation::sign_of_sum(const std::vector<WeightedDeterminant>& sum) const {
  std::vector<Vertex> all;
  for (const WeightedDeterminant& summand : sum)
    all.insert(all.end(), summand.vertices.begin(), summand.vertices.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());

  struct Term {
    int power;  // of eps, the vertices of all determinants ranked together
    std::size_t summand;
    const PerturbationTerm<3>* matching;
  };
  std::vector<Term> terms;
  std::vector<Rows<3>> rows;
  std::vector<std::array<int, 4>> ranks;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    rows.push_back(rows_of<3>(sum[i].vertices));
    ranks.push_back(ranks_among<3>(sum[i].vertices, sum[i].vertices));
    std::array<Vertex, 4> ascending = sum[i].vertices;
    std::sort(ascending.begin(), ascending.end());
    const std::array<int, 4> rank_among_all = ranks_among<3>(ascending, all);
    for (const PerturbationTerm<3>& matching : perturbation_terms<3>())
      terms.push_back({power_of<3>(matching, rank_among_all), i, &matching});
  }
  std::stable_sort(terms.begin(), terms.end(), [](const Term& a, const Term& b) { return a.power < b.power; });
  for (std::size_t first = 0, next = 0; first < terms.size(); first = next) {
    Linear total{Exact(0), Exact(0)};
    for (; next < terms.size() && terms[next].power == terms[first].power; ++next) {
      const std::size_t i = terms[next].summand;
      total = total + Linear{sum[i].weight, Exact(0)} * coefficient<3>(rows[i], ranks[i], *terms[next].matching);
    }
    if (const int sign = sign_of(total); sign != 0) return sign;
  }
  return 0;
}

int certain_orientation(const Box& a, const Box& b, const Box& c, const Box& d) {
  const CGAL::Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
  const Vec3<Interval> a_Me = interval_point(a);
  return certain_sign(determinant(interval_point(b) - a_Me, interval_point(c) - a_Me, interval_point(d) - a_Me));
}

namespace {
int filtered_orientation(const ExactPose& pose, Vertex a, Vertex b, Vertex c, Vertex d) {
  return certain_orientation(pose.enclosure(a), pose.enclosure(b), pose.enclosure(c), pose.enclosure(d));
}
}  // namespace

int Orientation::orient3d(Vertex a, Vertex b, Vertex c, Vertex d) const {
  // Without a shift the unperturbed determinant is the polynomial's first coefficient.
  const int decided = shifted_ ? filtered_orientation(pose_, a, b, c, d) : exact_orientation(a, b, c, d);
  return decided != 0 ? decided : tie_rule<3>({a, b, c, d});
}

int Orientation::side(Vertex x, Side face_side, Index face) const {
  const Triangle& t = pose_.face(face_side, face);
  return orient3d({face_side, t[0]}, {face_side, t[1]}, {face_side, t[2]}, x);
}

int Orientation::orient_xy(Vertex a, Vertex b, Vertex c) const {
  int filtered = 0;
  {
    const CGAL::Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
    const Vec3<Interval> a_Me = interval_point(pose_.enclosure(a));
    const Vec3<Interval> ab = interval_point(pose_.enclosure(b)) - a_Me;
    const Vec3<Interval> ac = interval_point(pose_.enclosure(c)) - a_Me;
    filtered = certain_sign(ab.x * ac.y - ab.y * ac.x);
  }
  return filtered != 0 ? filtered : tie_rule<2>({a, b, c});
}

int Orientation::exact_orientation(Vertex a, Vertex b, Vertex c, Vertex d) const {
  if (const int filtered = filtered_orientation(pose_, a, b, c, d); filtered != 0) return filtered;
  const Vec3<Exact> a_Me = pose_.point<Exact>(a);
  return sign_of(determinant(pose_.point<Exact>(b) - a_Me, pose_.point<Exact>(c) - a_Me, pose_.point<Exact>(d) - a_Me));
}

}  // namespace pcm::reference
