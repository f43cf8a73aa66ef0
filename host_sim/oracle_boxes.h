/*
 * A tree of bounding boxes in double that lists the shapes a ray may meet; the boxes are padded by far more
 * than double rounds, so it never misses one, and what it lists is decided elsewhere.
 */
#ifndef FIXCAST_HOST_ORACLE_BOXES_H
#define FIXCAST_HOST_ORACLE_BOXES_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace host::oracle {

using Double3 = std::array<double, 3>;

struct Box {
  Double3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  int shape = -1;

  void include(const Double3 &point, double margin) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], point[k] - margin);
      high[k] = std::max(high[k], point[k] + margin);
    }
  }
};

class BoxTree {
public:
  /* `reach` is the largest coordinate, in size, of anything in the scene: shapes, eye and lights. */
  void build(std::vector<Box> boxes, double reach) {
    nodes_.clear();
    const double padding = 1e-9 * reach;
    for (Box &box : boxes) {
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] -= padding;
        box.high[k] += padding;
      }
    }
    if (!boxes.empty()) grow(boxes, 0, boxes.size());
  }

  /* Calls visit(shape, end) for every box that origin + t * direction, start <= t <= end, may meet, nearer
   * boxes first. visit may lower `end`; it returns false to stop. */
  template <class Visit>
  void walk(const Double3 &origin, const Double3 &direction, double start, double end, Visit visit) const {
    if (nodes_.empty()) return;
    Double3 inverse{};
    for (std::size_t k = 0; k < 3; ++k)
      inverse[k] = 1 / direction[k];
    struct Entry {
      int node;
      double t;
    };
    std::array<Entry, 72> stack; /* halving keeps the depth at log2 of the number of boxes */
    std::size_t height = 0;
    double t = 0;
    if (enter(0, origin, direction, inverse, start, end, t)) stack[height++] = {0, t};
    while (height > 0) {
      const Entry entry = stack[--height];
      if (entry.t > end) continue;
      const Node &node = nodes_[static_cast<std::size_t>(entry.node)];
      if (node.box.shape >= 0) {
        if (!visit(node.box.shape, end)) return;
        continue;
      }
      const int left = entry.node + 1, right = node.right;
      double t_left = 0, t_right = 0;
      const bool in_left = enter(left, origin, direction, inverse, start, end, t_left);
      const bool in_right = enter(right, origin, direction, inverse, start, end, t_right);
      const bool left_first = t_left <= t_right;
      if (in_left && !left_first) stack[height++] = {left, t_left};
      if (in_right) stack[height++] = {right, t_right};
      if (in_left && left_first) stack[height++] = {left, t_left};
    }
  }

private:
  struct Node {
    Box box;        /* shape >= 0 in a leaf */
    int right = -1; /* the left child follows its parent */
  };

  int grow(std::vector<Box> &boxes, std::size_t first, std::size_t last) {
    const int index = static_cast<int>(nodes_.size());
    nodes_.emplace_back();
    if (last - first == 1) {
      nodes_.back().box = boxes[first];
      return index;
    }
    Box all, centres;
    for (std::size_t i = first; i < last; ++i) {
      all.include(boxes[i].low, 0);
      all.include(boxes[i].high, 0);
      centres.include(centre(boxes[i]), 0);
    }
    nodes_.back().box = all;
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (centres.high[k] - centres.low[k] > centres.high[axis] - centres.low[axis]) axis = k;
    }
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [&](std::size_t i) { return boxes.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last),
                     [&](const Box &a, const Box &b) { return centre(a)[axis] < centre(b)[axis]; });
    grow(boxes, first, middle);
    const int right = grow(boxes, middle, last);
    nodes_[static_cast<std::size_t>(index)].right = right;
    return index;
  }

  static Double3 centre(const Box &box) {
    return {box.low[0] / 2 + box.high[0] / 2, box.low[1] / 2 + box.high[1] / 2,
            box.low[2] / 2 + box.high[2] / 2};
  }

  /* The slab test. min and max are ordered so that a NaN (0 times infinity) leaves the range as it is. */
  bool enter(int node, const Double3 &origin, const Double3 &direction, const Double3 &inverse, double start,
             double end, double &t) const {
    const Box &box = nodes_[static_cast<std::size_t>(node)].box;
    for (std::size_t k = 0; k < 3; ++k) {
      if (direction[k] == 0) {
        if (origin[k] < box.low[k] || origin[k] > box.high[k]) return false;
        continue;
      }
      const double a = (box.low[k] - origin[k]) * inverse[k], b = (box.high[k] - origin[k]) * inverse[k];
      start = std::max(start, inverse[k] > 0 ? a : b);
      end = std::min(end, inverse[k] > 0 ? b : a);
    }
    t = start;
    return start <= end;
  }

  std::vector<Node> nodes_;
};

} // namespace host::oracle

#endif
