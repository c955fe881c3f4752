#include "apps/report/fixture_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "libmpm/solver/boundary.hpp"
#include "specimen/picture/picture.hpp"

namespace output {
namespace {

constexpr double paper = 44;     ///< round the specimen [px]
constexpr double longest = 440;  ///< side of the specimen [px]
constexpr double symbol = 11;    ///< size of a triangle [px]
constexpr double shaft = 26;     ///< length of an arrow [px]
constexpr double apart = 16;     ///< two symbols of a stretch [px]

/// Nodes beside each other that are held or moved alike.
std::vector<std::vector<mpm::HeldNode>> stretches_of(const std::vector<mpm::HeldNode>& held) {
  std::vector<std::vector<mpm::HeldNode>> stretches;
  for (const mpm::HeldNode& node : held) {
    const auto goes_on = [&](const std::vector<mpm::HeldNode>& stretch) {
      const mpm::HeldNode& last = stretch.back();
      return last.load == node.load && last.x == node.x && last.y == node.y &&
             std::abs(last.row - node.row) <= 1 && std::abs(last.col - node.col) <= 1;
    };
    const auto found = std::find_if(stretches.begin(), stretches.end(), goes_on);
    if (found == stretches.end())
      stretches.push_back({node});
    else
      found->push_back(node);
  }
  return stretches;
}

class SetUp {
 public:
  SetUp(const specimen::LabelledMask& mask, const mpm::Scene& scene)
      : scene_(scene),
        scale_(longest / std::max(mask.width(), mask.height())),
        cell_(scene.pixel_size * scene.points_per_cell) {
    drawing_.width = mask.width() * scale_ + 2 * paper;
    drawing_.height = mask.height() * scale_ + 2 * paper;
    drawing_.title = "The specimen with its supports, loads and gauges";
    drawing_.shapes.push_back(
        Pixels{{paper, paper}, mask.width() * scale_, mask.height() * scale_, specimen::preview(mask)});
  }

  void add(const mpm::GridBoundary& boundary) {
    for (const std::vector<mpm::HeldNode>& stretch : stretches_of(boundary.held)) {
      const Place first = place_of(stretch.front()), last = place_of(stretch.back());
      const double length = std::hypot(last.x - first.x, last.y - first.y);
      const int symbols = 1 + static_cast<int>(length / apart);
      for (int i = 0; i < symbols; ++i) {
        const double part = symbols == 1 ? 0.5 : static_cast<double>(i) / (symbols - 1);
        const Place at{first.x + part * (last.x - first.x), first.y + part * (last.y - first.y)};
        const auto nearest = static_cast<std::size_t>(part * static_cast<double>(stretch.size() - 1));
        const mpm::HeldNode& node = stretch[nearest];
        node.load >= 0 ? add_arrow(at, node) : add_triangle(at, node);
      }
    }
  }

  void add(const mpm::Gauge& gauge) {
    const Place a = place(gauge.x1, gauge.y1), b = place(gauge.x2, gauge.y2);
    drawing_.shapes.push_back(Stroke{{a, b}, Ink::fifth, 2});
    for (const Place& end : {a, b}) drawing_.shapes.push_back(Dot{end, 3.5, Ink::fifth});
    const Place middle{0.5 * (a.x + b.x) + 6, 0.5 * (a.y + b.y) + (b.x == a.x ? 0 : 18)};
    drawing_.shapes.push_back(Words{middle, gauge.name, 13, Anchor::start, Ink::fifth});
  }

  [[nodiscard]] Drawing drawing() && { return std::move(drawing_); }

 private:
  [[nodiscard]] Place place(double x, double y) const {
    return {paper + x * scale_, drawing_.height - paper - y * scale_};
  }

  [[nodiscard]] Place place_of(const mpm::HeldNode& node) const {
    return place(node.col * cell_, node.row * cell_);
  }

  [[nodiscard]] bool is_solid(int row, int col) const {  // a cell, by its lower left node
    const int k = scene_.points_per_cell;
    const auto rows = static_cast<int>(scene_.labels.rows()), cols = static_cast<int>(scene_.labels.cols());
    const int top = rows - (row + 1) * k, left = col * k;
    if (top < 0 || left < 0 || top + k > rows || left + k > cols) return false;
    for (int i = 0; i < k * k; ++i)
      if (scene_.phases[scene_.labels(top + i / k, left + i % k)]) return true;
    return false;
  }

  /// Away from the material, one of the four ways.
  [[nodiscard]] Place outwards(const mpm::HeldNode& node) const {
    const auto solid = [&](int row, int col) { return is_solid(row, col); };
    const bool below = solid(node.row - 1, node.col) || solid(node.row - 1, node.col - 1);
    const bool above = solid(node.row, node.col) || solid(node.row, node.col - 1);
    const bool left = solid(node.row, node.col - 1) || solid(node.row - 1, node.col - 1);
    if (!below) return {0, 1};
    if (!above) return {0, -1};
    return {left ? 1.0 : -1.0, 0};
  }

  void add_triangle(const Place& at, const mpm::HeldNode& node) {
    const Place out = outwards(node), across{out.y, out.x};
    const auto corner = [&](double along, double aside) {
      return Place{at.x + along * out.x + aside * across.x, at.y + along * out.y + aside * across.y};
    };
    drawing_.shapes.push_back(
        Stroke{{at, corner(symbol, -0.6 * symbol), corner(symbol, 0.6 * symbol), at}, Ink::second, 2});
    const bool slides = !(node.x && node.y);
    const double base = symbol + (slides ? 4 : 0);
    if (slides)
      drawing_.shapes.push_back(
          Stroke{{corner(base, -0.8 * symbol), corner(base, 0.8 * symbol)}, Ink::second, 2});
  }

  void add_arrow(const Place& at, const mpm::HeldNode& node) {
    const double length = std::hypot(node.ux, node.uy);
    const Place way{node.ux / length, -node.uy / length}, across{-way.y, way.x};
    const Place out = outwards(node);
    const bool pulls = out.x * way.x + out.y * way.y > 0;
    const double tip = pulls ? shaft + 2 : -2;
    const auto point = [&](double along, double aside) {
      return Place{at.x + along * way.x + aside * across.x, at.y + along * way.y + aside * across.y};
    };
    drawing_.shapes.push_back(Stroke{{point(tip - shaft, 0), point(tip, 0)}, Ink::first, 2.5});
    drawing_.shapes.push_back(
        Stroke{{point(tip - 8, -5), point(tip, 0), point(tip - 8, 5)}, Ink::first, 2.5});
  }

  const mpm::Scene& scene_;
  double scale_, cell_;
  Drawing drawing_;
};

}  // namespace

Drawing fixture_drawing(const specimen::LabelledMask& mask, const mpm::Scene& scene) {
  const int k = scene.points_per_cell;
  const auto cells = [k](Eigen::Index pixels) { return static_cast<int>(pixels) / k; };
  SetUp set_up(mask, scene);
  set_up.add(mpm::find_boundary(scene, cells(scene.labels.cols()), cells(scene.labels.rows()),
                                k * scene.pixel_size));
  for (const mpm::Gauge& gauge : scene.fixture.gauges) set_up.add(gauge);
  return std::move(set_up).drawing();
}

}  // namespace output
