#include "libmpm/solver/boundary.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "libmpm/scene/error.hpp"

namespace mpm {
namespace {

const char* name_of(Side side) {
  switch (side) {
    case Side::bottom:
      return "bottom";
    case Side::top:
      return "top";
    case Side::left:
      return "left";
    case Side::right:
      return "right";
  }
  return "";
}

std::string numbered(const char* list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index + 1) + "]";
}

std::string millimetres(double length) { return text(1e3 * length, "mm"); }

/// The nodes of a grid that touch material.
class Outline {
 public:
  Outline(const Scene& scene, int cells_x, int cells_y, double cell_size)
      : scene_(scene), cells_x_(cells_x), cells_y_(cells_y), cell_size_(cell_size) {}

  using Node = std::pair<int, int>;  // row, column

  [[nodiscard]] bool is_solid_cell(int row, int col) const {
    if (row < 0 || col < 0 || row >= cells_y_ || col >= cells_x_) return false;
    const int k = scene_.points_per_cell;
    const auto top = scene_.labels.rows() - (row + 1) * k;
    for (int i = 0; i < k; ++i)
      for (int j = 0; j < k; ++j)
        if (scene_.phases[scene_.labels(top + i, col * k + j)]) return true;
    return false;
  }
  [[nodiscard]] bool is_solid_node(int row, int col) const {
    return is_solid_cell(row, col) || is_solid_cell(row - 1, col) || is_solid_cell(row, col - 1) ||
           is_solid_cell(row - 1, col - 1);
  }

  /// The nodes of a stretch; empty without material there.
  [[nodiscard]] std::vector<Node> nodes_at(const Stretch& at) const {
    const bool level = at.side == Side::bottom || at.side == Side::top;
    const int last = level ? cells_x_ : cells_y_;
    std::vector<std::pair<int, int>> found;  // depth, place along the side
    const auto try_place = [&](int place) {
      if (const int depth = depth_at(at.side, place); depth >= 0) found.emplace_back(depth, place);
    };
    constexpr double rounding = 1e-6;  // of a cell
    const double low = std::max(at.from / cell_size_ - rounding, 0.0);
    const double high = std::min(at.to / cell_size_ + rounding, last + 0.5);
    for (int place = static_cast<int>(std::ceil(low)); place <= std::min<double>(last, high); ++place)
      try_place(place);
    if (found.empty() && high - low < 1 + 3 * rounding)
      try_place(std::clamp(static_cast<int>(std::lround(0.5 * (low + high))), 0, last));
    std::vector<Node> nodes;
    if (found.empty()) return nodes;
    const int least = std::min_element(found.begin(), found.end())->first;
    for (const auto& [depth, place] : found)
      if (depth == least) nodes.push_back(node_at(at.side, depth, place));
    return nodes;
  }

  /// The solid node nearest to a place, with its distance [m].
  [[nodiscard]] std::pair<Node, double> nearest(double x, double y) const {
    std::pair<Node, double> best{{0, 0}, std::numeric_limits<double>::infinity()};
    for (int row = 0; row <= cells_y_; ++row)
      for (int col = 0; col <= cells_x_; ++col) {
        const double distance = std::hypot(col * cell_size_ - x, row * cell_size_ - y);
        if (distance < best.second && is_solid_node(row, col)) best = {{row, col}, distance};
      }
    return best;
  }

 private:
  [[nodiscard]] Node node_at(Side side, int depth, int place) const {
    switch (side) {
      case Side::bottom:
        return {depth, place};
      case Side::top:
        return {cells_y_ - depth, place};
      case Side::left:
        return {place, depth};
      case Side::right:
        return {place, cells_x_ - depth};
    }
    return {0, 0};
  }
  /// How far in the first solid node lies; -1 = there is none.
  [[nodiscard]] int depth_at(Side side, int place) const {
    const bool level = side == Side::bottom || side == Side::top;
    for (int depth = 0; depth <= (level ? cells_y_ : cells_x_); ++depth) {
      const Node node = node_at(side, depth, place);
      if (is_solid_node(node.first, node.second)) return depth;
    }
    return -1;
  }

  const Scene& scene_;
  int cells_x_, cells_y_;
  double cell_size_;
};

/// Collects what is given of each node.
class Holder {
 public:
  explicit Holder(const Outline& outline) : outline_(outline) {}

  void add(const std::string& field, const Bearing& support) {
    for (const auto& [row, col] : nodes_of(field, support.at)) {
      HeldNode node{.row = row, .col = col, .x = support.fix_x, .y = support.fix_y};
      merge(field, node);
    }
  }
  void add(const std::string& field, const Load& load, int index) {
    for (const auto& [row, col] : nodes_of(field, load.at)) {
      const bool along_x = load.way == Way::left || load.way == Way::right;
      HeldNode node{.row = row,
                    .col = col,
                    .x = along_x || load.grips,
                    .y = !along_x || load.grips,
                    .ux = load.share * sense_x(load.way),
                    .uy = load.share * sense_y(load.way),
                    .load = index};
      merge(field, node);
    }
  }
  [[nodiscard]] std::vector<HeldNode> all() && {
    std::sort(held_.begin(), held_.end(), [](const HeldNode& a, const HeldNode& b) {
      return std::pair(a.row, a.col) < std::pair(b.row, b.col);
    });
    return std::move(held_);
  }

 private:
  [[nodiscard]] std::vector<Outline::Node> nodes_of(const std::string& field, const Stretch& at) const {
    std::vector<Outline::Node> nodes = outline_.nodes_at(at);
    if (nodes.empty())
      throw Error(field, std::string(name_of(at.side)) + " from " + millimetres(at.from), "meets no material",
                  "choose from and to where the specimen is");
    return nodes;
  }

  void merge(const std::string& field, const HeldNode& node) {
    const auto same = std::find_if(held_.begin(), held_.end(), [&](const HeldNode& one) {
      return one.row == node.row && one.col == node.col;
    });
    if (same == held_.end()) return held_.push_back(node);
    if ((same->x && node.x && same->ux != node.ux) || (same->y && node.y && same->uy != node.uy))
      throw Error(field, "meets a node that another support or load moves otherwise",
                  "a node can move in one way only", "let them end before they meet");
    if (node.x) same->ux = node.ux;
    if (node.y) same->uy = node.uy;
    same->x |= node.x;
    same->y |= node.y;
    same->load = std::max(same->load, node.load);
  }

  const Outline& outline_;
  std::vector<HeldNode> held_;
};

/// The specimen as a rigid body has two translations and a rotation, and each must meet a node that is held.
void refuse_mechanism(const std::vector<HeldNode>& held, int cells_x, int cells_y) {
  const double size = std::max(cells_x, cells_y);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const HeldNode& node : held) {
    const Eigen::Vector3d x(1, 0, -node.row / size), y(0, 1, node.col / size);
    if (node.x) sum += x * x.transpose();
    if (node.y) sum += y * y.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(sum);
  if (eigen.eigenvalues()(0) > 1e-6) return;
  const Eigen::Vector3d free = eigen.eigenvectors().col(0).cwiseAbs();
  const char* motion = free(2) > 0.5 * free.maxCoeff() ? "turn"
                       : free(0) > free(1)             ? "slide along x"
                                                       : "slide along y";
  throw Error("supports", std::string("the specimen can ") + motion + " as a whole",
              "supports and loads must hold it along x, along y and against turning",
              free(0) > free(1) ? "add x to fix of a support" : "add a support");
}

std::vector<NodeWeight> weights_of(const Outline& outline, const std::string& field, const Gauge& gauge,
                                   double cell_size) {
  const double length = std::hypot(gauge.x2 - gauge.x1, gauge.y2 - gauge.y1);
  const double dx = gauge.direction == Gauge::Direction::x   ? 1
                    : gauge.direction == Gauge::Direction::y ? 0
                                                             : (gauge.x2 - gauge.x1) / length;
  const double dy = gauge.direction == Gauge::Direction::y   ? 1
                    : gauge.direction == Gauge::Direction::x ? 0
                                                             : (gauge.y2 - gauge.y1) / length;
  std::vector<NodeWeight> weights;
  const auto add_point = [&](double x, double y, double sign) {
    const int col = static_cast<int>(std::floor(x / cell_size)),
              row = static_cast<int>(std::floor(y / cell_size));
    if (outline.is_solid_cell(row, col)) {
      const double xi = x / cell_size - col, eta = y / cell_size - row;
      for (int node = 0; node < 4; ++node) {
        const double weight = sign * (node % 2 == 1 ? xi : 1 - xi) * (node / 2 == 1 ? eta : 1 - eta);
        weights.push_back({row + node / 2, col + node % 2, weight * dx, weight * dy});
      }
      return;
    }
    const auto [node, distance] = outline.nearest(x, y);
    if (distance > 1.5 * cell_size)
      throw Error(field, "(" + millimetres(x) + ", " + millimetres(y) + ")",
                  "is not on the specimen; the nearest material is " + millimetres(distance) + " away",
                  "put both points of a gauge on material");
    weights.push_back({node.first, node.second, sign * dx, sign * dy});
  };
  add_point(gauge.x1, gauge.y1, -1);
  add_point(gauge.x2, gauge.y2, 1);
  return weights;
}

}  // namespace

double sense_x(Way way) { return way == Way::right ? 1 : way == Way::left ? -1 : 0; }
double sense_y(Way way) { return way == Way::up ? 1 : way == Way::down ? -1 : 0; }

GridBoundary find_boundary(const Scene& scene, int cells_x, int cells_y, double cell_size) {
  const Fixture& fixture = scene.fixture;
  const Outline outline(scene, cells_x, cells_y, cell_size);
  GridBoundary boundary;
  for (std::size_t i = 0; i < fixture.gauges.size(); ++i)
    boundary.gauges.push_back(
        weights_of(outline, numbered("gauges", i) + ".between", fixture.gauges[i], cell_size));
  if (!fixture.has_loads()) return boundary;
  Holder holder(outline);
  for (std::size_t i = 0; i < fixture.supports.size(); ++i)
    holder.add(numbered("supports", i), fixture.supports[i]);
  for (std::size_t i = 0; i < fixture.loads.size(); ++i)
    holder.add(numbered("loads", i), fixture.loads[i], static_cast<int>(i));
  boundary.held = std::move(holder).all();
  refuse_mechanism(boundary.held, cells_x, cells_y);
  return boundary;
}

}  // namespace mpm
