/* Exact oracles for convex sets (fractions): hulls that meet, by linear programming; least distances, by trying all active sets. */
#ifndef VOLUME_EXACT_CONVEX_H
#define VOLUME_EXACT_CONVEX_H

#include "exact.h"

namespace exact {

/* Whether 0 is in the hull of some points: sum l_i p_i = 0, sum l_i = 1, l >= 0, by the simplex method's first phase with Bland's rule
 * (1977), so that it ends. */
inline bool hull_has_origin(const std::vector<Point> &points) {
  const size_t rows = 4, columns = points.size();
  /* a tableau: columns of the points, then the right side; rows with a right side of 0 or more; artificial variables are implied */
  std::vector<std::vector<Q>> t(rows, std::vector<Q>(columns + 1));
  for (size_t j = 0; j < columns; j++) {
    for (size_t i = 0; i < 3; i++) t[i][j] = points[j].x[i];
    t[3][j] = 1;
  }
  t[3][columns] = 1;
  std::vector<size_t> basis(rows, columns + 1); /* artificial */
  for (;;) {
    /* what is left of the artificial variables: the sum of their rows; a column with a positive sum lessens it */
    size_t enter = columns;
    for (size_t j = 0; j < columns && enter == columns; j++) {
      Q gain = 0;
      for (size_t i = 0; i < rows; i++)
        if (basis[i] > columns) gain += t[i][j];
      if (sgn(gain) > 0) enter = j;
    }
    Q left = 0;
    for (size_t i = 0; i < rows; i++)
      if (basis[i] > columns) left += t[i][columns];
    if (sgn(left) == 0) return true;
    if (enter == columns) return false;
    size_t leave = rows;
    Q least;
    for (size_t i = 0; i < rows; i++) {
      if (sgn(t[i][enter]) <= 0) continue;
      Q ratio = t[i][columns] / t[i][enter];
      if (leave == rows || ratio < least || (ratio == least && basis[i] < basis[leave])) {
        leave = i;
        least = ratio;
      }
    }
    if (leave == rows) return false; /* cannot be: the set is bounded */
    Q pivot = t[leave][enter];
    for (Q &v : t[leave]) v /= pivot;
    for (size_t i = 0; i < rows; i++) {
      if (i == leave || sgn(t[i][enter]) == 0) continue;
      Q factor = t[i][enter];
      for (size_t j = 0; j <= columns; j++) t[i][j] -= factor * t[leave][j];
    }
    basis[leave] = enter;
  }
}

inline bool hulls_meet(const std::vector<Vec> &a, const std::vector<Vec> &b) {
  std::vector<Point> differences;
  for (Vec p : a)
    for (Vec q : b) differences.push_back(point(p) - point(q));
  return hull_has_origin(differences);
}

/* Solves g x = r of n <= 3 unknowns by elimination; false when g is singular. */
inline bool solve(int n, Q g[3][3], Q r[3]) {
  for (int c = 0; c < n; c++) {
    int p = c;
    while (p < n && sgn(g[p][c]) == 0) p++;
    if (p == n) return false;
    for (int j = 0; j < n; j++) std::swap(g[c][j], g[p][j]);
    std::swap(r[c], r[p]);
    for (int i = 0; i < n; i++) {
      if (i == c) continue;
      Q f = g[i][c] / g[c][c];
      for (int j = 0; j < n; j++) g[i][j] -= f * g[c][j];
      r[i] -= f * r[c];
    }
  }
  for (int i = 0; i < n; i++) r[i] /= g[i][i];
  return true;
}

/*
 * The least |a + s (b - a) - q|^2 for 0 <= s <= 1 and q in a triangle: a convex function of (s, u, v) on a prism. On each of the prism's
 * vertices, edges, faces and on its inside the least of the function on the whole flat through it is solved for; it counts when it lies on
 * the prism. Where that is not unique, a smaller flat has the least too.
 */
inline Q segment_triangle_distance2(const Point &a, const Point &b, const Point v[3]) {
  static const int corner[6][3] = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {1, 0, 1}};
  static const int faces[21][4] = {
      /* corners that span: base and up to three more, -1: none */
      {0, -1, -1, -1},
      {1, -1, -1, -1},
      {2, -1, -1, -1},
      {3, -1, -1, -1},
      {4, -1, -1, -1},
      {5, -1, -1, -1},
      {0, 1, -1, -1},
      {1, 2, -1, -1},
      {2, 0, -1, -1},
      {3, 4, -1, -1},
      {4, 5, -1, -1},
      {5, 3, -1, -1},
      {0, 3, -1, -1},
      {1, 4, -1, -1},
      {2, 5, -1, -1},
      {0, 1, 2, -1},
      {3, 4, 5, -1},
      {0, 1, 3, -1},
      {1, 2, 4, -1},
      {2, 0, 5, -1},
      {0, 1, 2, 3}};
  Point along[3] = {b - a, v[0] - v[1], v[0] - v[2]}; /* of s, l1, l2 */
  Point start = a - v[0];
  bool found = false;
  Q least;
  for (const auto &face : faces) {
    Point base = start, span[3];
    Q at[3], dir[3][3];
    int n = 0;
    for (int c = 0; c < 3; c++) {
      at[c] = corner[face[0]][c];
      base = base + along[c] * at[c];
    }
    for (int k = 1; k < 4 && face[k] >= 0; k++, n++) {
      span[n] = point({0, 0, 0});
      for (int c = 0; c < 3; c++) {
        dir[n][c] = corner[face[k]][c] - corner[face[0]][c];
        span[n] = span[n] + along[c] * dir[n][c];
      }
    }
    Q g[3][3], r[3];
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) g[i][j] = dot(span[i], span[j]);
      r[i] = -dot(span[i], base);
    }
    if (!solve(n, g, r)) continue;
    for (int i = 0; i < n; i++) {
      base = base + span[i] * r[i];
      for (int c = 0; c < 3; c++) at[c] += dir[i][c] * r[i];
    }
    if (sgn(at[0]) < 0 || at[0] > 1 || sgn(at[1]) < 0 || sgn(at[2]) < 0 || at[1] + at[2] > 1) continue;
    Q d = dot(base, base);
    if (!found || d < least) least = d;
    found = true;
  }
  return least;
}

} // namespace exact

#endif
