// (M + t L) h' = M h, with lumped areas M and cotangent weights L (Pinkall & Polthier 1993), solved by
// conjugate gradients. Sums run in order, so that the bits do not depend on threads.

#include "heat_flow.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

namespace verdigris {

namespace {

// Rows of a symmetric matrix, its diagonal apart.
struct SparseRows {
  std::vector<std::size_t> begin;
  std::vector<std::uint32_t> column;
  std::vector<double> weight, diagonal;

  void multiply(const std::vector<double>& x, std::vector<double>& y) const {
    for (std::size_t i = 0; i < diagonal.size(); ++i) {
      double sum = diagonal[i] * x[i];
      for (std::size_t k = begin[i]; k < begin[i + 1]; ++k) sum += weight[k] * x[column[k]];
      y[i] = sum;
    }
  }
};

double dot(const std::vector<double>& x, const std::vector<double>& y) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
  return sum;
}

// Preconditioned by the diagonal; x holds a first guess.
void solve(const SparseRows& a, const std::vector<double>& b, std::vector<double>& x) {
  const std::size_t n = b.size();
  std::vector<double> r(n), z(n), p(n), q(n);
  a.multiply(x, r);
  for (std::size_t i = 0; i < n; ++i) r[i] = b[i] - r[i];
  const auto scale = [&] {
    for (std::size_t i = 0; i < n; ++i) z[i] = r[i] / a.diagonal[i];
  };
  scale();
  p = z;
  double rz = dot(r, z);
  double target = 0.0;
  for (std::size_t i = 0; i < n; ++i) target += b[i] * b[i] / a.diagonal[i];
  target *= 1e-14;
  for (int k = 0; k < 2000 && rz > target; ++k) {
    a.multiply(p, q);
    const double alpha = rz / dot(p, q);
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += alpha * p[i];
      r[i] -= alpha * q[i];
    }
    scale();
    const double next = dot(r, z), beta = next / rz;
    rz = next;
    for (std::size_t i = 0; i < n; ++i) p[i] = z[i] + beta * p[i];
  }
}

}  // namespace

std::vector<double> spread_by_heat(const SampleMesh& mesh, std::vector<double> held, double radius) {
  constexpr int steps = 6;  // more steps come nearer to a Gaussian; one would have long tails
  const double time = 0.5 * radius * radius / steps;
  const std::size_t n = mesh.samples().size();
  std::vector<double> area(n, 0.0);
  struct Weight {
    std::uint32_t row, column;
    double weight;
  };
  std::vector<Weight> weights;
  for (const SampleMesh::Piece& piece : mesh.pieces()) {
    glm::dvec3 p[3];
    for (int k = 0; k < 3; ++k) p[k] = mesh.samples()[piece.samples[k]].position;
    const double twice = glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
    const double longest =
        std::max({glm::length(p[1] - p[0]), glm::length(p[2] - p[1]), glm::length(p[0] - p[2])});
    // A piece of next to no area conducts nothing that counts, but its cotangents would be infinite.
    if (!(twice > 1e-9 * longest * longest)) continue;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = piece.samples[(k + 1) % 3], b = piece.samples[(k + 2) % 3];
      area[piece.samples[k]] += twice / 6.0;
      const double cotangent = glm::dot(p[(k + 1) % 3] - p[k], p[(k + 2) % 3] - p[k]) / twice;
      weights.push_back({a, b, -0.5 * time * cotangent});
      weights.push_back({b, a, -0.5 * time * cotangent});
    }
  }
  std::stable_sort(weights.begin(), weights.end(), [](const Weight& x, const Weight& y) {
    return x.row != y.row ? x.row < y.row : x.column < y.column;
  });
  SparseRows a;
  a.diagonal = area;
  a.begin.assign(n + 1, 0);
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const Weight& w = weights[k];
    a.diagonal[w.row] -= w.weight;
    if (k > 0 && weights[k - 1].row == w.row && weights[k - 1].column == w.column) {
      a.weight.back() += w.weight;
      continue;
    }
    a.column.push_back(w.column);
    a.weight.push_back(w.weight);
    ++a.begin[w.row + 1];
  }
  for (std::size_t i = 0; i < n; ++i) a.begin[i + 1] += a.begin[i];
  for (double& d : a.diagonal)
    if (!(d > 0.0)) d = 1.0;  // a sample of no area
  std::vector<double> h(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) h[i] = area[i] > 0.0 ? held[i] / area[i] : 0.0;
  for (int step = 0; step < steps; ++step) {
    std::vector<double> b = held;
    solve(a, b, h);
    for (std::size_t i = 0; i < n; ++i) held[i] = area[i] * h[i];
  }
  return h;
}

}  // namespace verdigris
