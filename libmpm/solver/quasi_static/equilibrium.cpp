#include "libmpm/solver/quasi_static/equilibrium.hpp"

#include <algorithm>
#include <cmath>

#include "libmpm/kernels/instruction_set.hpp"

namespace mpm {
namespace {

constexpr double accuracy = 1e-7;  ///< of the displacements in the norm of the energy [-]
/// Error over that scale at which the solution of cracks that close counts as none [-].
constexpr double least_accuracy = 1e-2;
/// Error over that scale that is never left if it can be helped: what is torn through would carry it on [-].
constexpr double much = 1e-5;
constexpr double of_step = 0.05;         ///< error that one leaves of its linear problem [-]
constexpr int iterations_of_step = 20;   ///< after which one is taken as it is
constexpr int most_trials = 8;           ///< of the length of one
constexpr double search_accuracy = 0.2;  ///< of the slope of the energy at that length [-]
constexpr double longest_step = 4;       ///< over that of Newton's method [-]

/// sum = a + factor b
void combine(const NodeField& a, double factor, const NodeField& b, NodeField& sum) {
  for (std::size_t at = 0; at < sum.x.size(); ++at) {
    sum.x[at] = a.x[at] + factor * b.x[at];
    sum.y[at] = a.y[at] + factor * b.y[at];
  }
}

}  // namespace

Equilibrium::Equilibrium(const Scene& scene, const Plan& plan, const StrengthFactors& factors)
    : LatticeCells(scene, plan, factors), u_(shape().zeros()) {
  if (plan.boundary.empty()) {
    find_pinned_node();
    move_platens();
  } else {
    move_loads();
  }
  for (int row = 0; row < plan_.cells_y; ++row)
    separate_.follow(row, caution_, [&](int cell) { return loaded(row, cell); });
  (void)separate_.changed();
  make_multigrid();
  // Between loads no displacements are known that would do as a scale: those in equilibrium are found.
  if (!plan.boundary.empty()) (void)gradients_->solve(u_, {.accuracy = accuracy});
  scale_ = std::sqrt(-dot(shape(), u_, gradients_->unbalanced(u_)));
}

void Equilibrium::make_multigrid() {
  const FineGrid& fine = *this;
  multigrid_ = std::make_unique<Multigrid>(fine, coarsenings(plan_.cells_x, plan_.cells_y),
                                           chosen_equilibrium_kernels(scene_.instruction_set), plan_.threads);
  gradients_ = std::make_unique<ConjugateGradients>(fine, *multigrid_);
}

Equilibrium::Points Equilibrium::all_points() const {
  Points all{points_.stiffness, points_.shear, {}, {}, {}, separate_.told()};
  for (std::size_t at = 0; at < points_in_all(); ++at)
    if (const auto state = separate_.state(at)) {
      all.at.push_back(at);
      all.kept.push_back(state->kept);
      all.cracked.push_back(state->cracked);
    }
  return all;
}

bool Equilibrium::restore(const Points& points) {
  const auto possible = [](const AlignedVector<double>& now, const AlignedVector<double>& intact) {
    return std::equal(now.begin(), now.end(), intact.begin(), intact.end(),
                      [](double a, double b) { return a >= 0 && a <= b; });
  };
  if (!possible(points.stiffness, points_.stiffness) || !possible(points.shear, points_.shear)) return false;
  if (!restore_separate(points)) return false;
  take_over(points.stiffness, points.shear);
  follow_cracks();
  if (!separate_.set_told(points.told)) return false;
  make_multigrid();
  return true;
}

bool Equilibrium::restore_separate(const Points& points) {
  const std::size_t count = points.at.size();
  if (count > 0 && !separate_.may_have_any()) return false;
  if (points.kept.size() != count || points.cracked.size() != count) return false;
  const auto is_share = [](double value) { return value >= 0 && value <= 1; };
  if (!std::all_of(points.kept.begin(), points.kept.end(), is_share) ||
      !std::all_of(points.cracked.begin(), points.cracked.end(), is_share))
    return false;
  std::size_t found = 0;
  for (int row = 0; row < plan_.cells_y; ++row)
    each_point(row, [&](const PointPlace& at) {
      const auto place = std::lower_bound(points.at.begin(), points.at.end(), index(at));
      if (place == points.at.end() || *place != index(at)) return;
      const auto i = static_cast<std::size_t>(place - points.at.begin());
      const bool possible = is_extra(at) || points.cracked[i] > 0;
      if (possible && keep(at, points.kept[i], points.cracked[i])) ++found;
    });
  return found == count;
}

/// The node nearest the middle of the lower edge that touches a point.
void Equilibrium::find_pinned_node() {
  const int cols = plan_.cells_x;
  const auto is_solid = [&](int col) {
    for (int cell = std::max(0, col - 1); cell <= std::min(cols - 1, col); ++cell)
      for (int plane = 0; plane < points_.planes; ++plane)
        if (points_.stiffness[points_.at(0, plane, cell)] > 0) return true;
    return false;
  };
  pinned_ = nearest_to_middle(cols + 1, is_solid);
}

void Equilibrium::move_platens() {
  const double height = scene_.height();
  for (int row = 0; row <= plan_.cells_y; ++row)
    for (int col = 0; col <= plan_.cells_x; ++col)
      u_.y[shape().node(row, col)] = height * row / plan_.cells_y;  // a first guess, exact at both platens
}

/// At rest but for what is given.
void Equilibrium::move_loads() {
  held_x_.assign(shape().nodes(), 0);
  held_y_.assign(shape().nodes(), 0);
  for (const HeldNode& node : plan_.boundary.held) {
    const std::size_t at = shape().node(node.row, node.col);
    held_x_[at] = node.x ? 1 : 0;
    held_y_[at] = node.y ? 1 : 0;
    if (node.x) u_.x[at] = scene_.height() * node.ux;
    if (node.y) u_.y[at] = scene_.height() * node.uy;
  }
}

HeldNodes Equilibrium::held(int row, int col) const {
  HeldNodes held;
  if (!plan_.boundary.empty()) {
    for (int node = 0; node < 4; ++node) {
      const std::size_t at = shape().node(row + node / 2, col + node % 2);
      held.x[static_cast<std::size_t>(node)] = held_x_[at] != 0;
      held.y[static_cast<std::size_t>(node)] = held_y_[at] != 0;
    }
    return held;
  }
  const bool rough = scene_.loading.platen == Platen::rough;
  for (int node = 0; node < 4; ++node) {
    const int node_row = row + node / 2;
    if (node_row != 0 && node_row != plan_.cells_y) continue;
    const auto i = static_cast<std::size_t>(node);
    held.y[i] = true;
    held.x[i] = rough || (node_row == 0 && col + node % 2 == pinned_);
  }
  return held;
}

bool Equilibrium::solve(double reduction) {
  const bool solved = separate_.any_cracked()
                          ? settle(reduction)
                          : gradients_->solve(u_, {.reduction = reduction, .accuracy = accuracy});
  read_reactions();
  return solved;
}

/// Newton's method: the stress of a crack is in proportion to the strain, so that a step is the linear
/// problem with the stiffness at the displacements of now. The energy is convex, and a step goes to where it
/// is least, so that cracks cannot open and close in turns for ever. What only open cracks hold would fly far
/// beyond where the next one closes: as long as steps are cut short, open cracks are taken to be stiffer than
/// they are. Pieces that lie loose between others may move on for long while hardly any energy is left to
/// win, so that the longer it takes the less is asked.
bool Equilibrium::settle(double reduction) {
  take_caution(SeparatePoints::most_caution);
  SolutionGoal goal{.reduction = of_step, .accuracy = accuracy, .iterations = iterations_of_step};
  NodeField step = shape().zeros();
  double wanted = 0;
  double enough = accuracy;
  int wait = 0;
  int next_wait = 1;
  for (; enough < least_accuracy; enough *= 1.26) {
    const std::int64_t before = iterations();
    const NodeField start = u_;
    goal.error = std::max(wanted, enough * scale_);
    const bool solved = gradients_->solve(u_, goal);
    if (wanted == 0) wanted = std::min(reduction * gradients_->error_at_start(), much * scale_);
    if (iterations() == before) return solved;
    combine(u_, -1, start, step);
    const double length = search(start, step);
    if (length < 0.5) {
      caution_ = std::min(10 * caution_, SeparatePoints::most_caution);
      wait = next_wait;
      next_wait = std::min(2 * next_wait, 16);
    } else if (length >= 1 && --wait <= 0) {
      caution_ *= 0.1;
    }
    follow({});
  }
  return false;
}

void Equilibrium::take_caution(double caution) {
  caution_ = caution;
  follow_cracks();
}

/// Goes from where a step began to where the energy is about least on its way.   @return the length of the
/// way.
double Equilibrium::search(const NodeField& start, const NodeField& step) {
  struct End {
    double length, slope;  // of the energy, which rises with the length
  };
  const double steepest = dot(shape(), step, gradients_->unbalanced(start));
  End low{0, -steepest};
  End high{0, 0};  // none yet
  double length = 1;
  for (int i = 0; i < most_trials; ++i) {
    combine(start, length, step, u_);
    follow_cracks();
    const double slope = -dot(shape(), step, gradients_->unbalanced(u_));
    if (std::abs(slope) <= search_accuracy * steepest) break;
    const double width = high.length - low.length;
    (slope > 0 ? high : low) = {length, slope};
    const bool is_slow = high.length - low.length > 0.5 * width;
    if (high.slope <= 0) {
      if (length >= longest_step) break;
      length *= 2;
    } else if (is_slow && i > 0) {
      length = 0.5 * (low.length + high.length);
    } else {
      length = (low.length * high.slope - high.length * low.slope) / (high.slope - low.slope);
    }
  }
  return length;
}

/// Gives the cracks the stiffness of the displacements of now.
void Equilibrium::follow_cracks() {
  each_row([&](int row) { separate_.follow(row, caution_, [&](int cell) { return loaded(row, cell); }); });
}

/// @param changed  cells that have changed besides.
void Equilibrium::follow(std::vector<Multigrid::Cell> changed) {
  follow_cracks();
  for (const SeparatePoints::Cell& cell : separate_.changed()) changed.push_back({cell.row, cell.col});
  if (!changed.empty()) multigrid_->update(std::move(changed));
}

/// Under a platen strain in the direction of the loading, by which cracks open or close.
CellDisplacement Equilibrium::loaded(int row, int cell) const {
  CellDisplacement u = displacement(row, cell);
  if (scene_.loading.direction == Direction::tension) return u;
  for (double* v : {u.ux, u.uy})
    for (int node = 0; node < 4; ++node) v[node] = -v[node];
  return u;
}

/// Forces of the loads on the specimen, and their work at a strain of 1.
void Equilibrium::read_forces() {
  const NodeField& force = gradients_->unbalanced(u_);  // of the cells on the nodes
  double work = 0, leading = 0;
  for (const HeldNode& node : plan_.boundary.held) {
    if (node.load < 0) continue;
    const std::size_t at = shape().node(node.row, node.col);
    work -= (node.x ? force.x[at] * node.ux : 0) + (node.y ? force.y[at] * node.uy : 0);
    const Load& load = scene_.fixture.loads[static_cast<std::size_t>(node.load)];
    if (load.leads) leading -= force.x[at] * sense_x(load.way) + force.y[at] * sense_y(load.way);
  }
  const double area = points_.planes * scene_.width();
  modulus_top_ = modulus_bottom_ = work / area;
  modulus_leading_ = leading / area;
}

double Equilibrium::gauge(std::size_t index) const {
  double reading = 0;
  for (const NodeWeight& node : plan_.boundary.gauges[index]) {
    const std::size_t at = shape().node(node.row, node.col);
    reading += node.x * u_.x[at] + node.y * u_.y[at];
  }
  return reading;
}

void Equilibrium::read_reactions() {
  if (!plan_.boundary.empty()) return read_forces();
  const double area = points_.planes * scene_.width();
  modulus_top_ = -gradients_->force_y(plan_.cells_y) / area;
  modulus_bottom_ = gradients_->force_y(0) / area;
  modulus_leading_ = modulus();
}

void Equilibrium::change(const std::vector<Change>& changes) {
  std::vector<Multigrid::Cell> cells;
  for (const Change& one : changes) {
    if (keep(one.at, one.kept, one.cracked)) cells.push_back({one.at.row, one.at.cell});
  }
  separate_.empty() ? multigrid_->update(std::move(cells)) : follow(std::move(cells));
}

double Equilibrium::largest_utilisation(int row, int plane, const Resistance& resistance, double sign) const {
  const std::size_t at = points_.at(row, plane, 0);
  const std::size_t below = shape().node(row, 0);
  const std::size_t above = shape().node(row + 1, 0);
  const int k = scene_.points_per_cell;
  const Eigen::Matrix3d& unit = unit_stiffness();
  return multigrid_->kernels().largest_utilisation(
      {.cells = static_cast<int>(points_.stride),
       .ux_lower = u_.x.data() + below,
       .uy_lower = u_.y.data() + below,
       .ux_upper = u_.x.data() + above,
       .uy_upper = u_.y.data() + above,
       .xi = (plane % k + 0.5) / k,
       .eta = (plane / k + 0.5) / k,
       .scale = sign / plan_.cell_size,
       .stiffness = points_.stiffness.data() + at,
       .shear = points_.shear.empty() ? nullptr : points_.shear.data() + at,
       .unit_axial = unit(0, 0),
       .unit_lateral = unit(0, 1),
       .unit_shear = unit(2, 2),
       .tension = resistance.tension.data() + at,
       .crush = resistance.crush.data() + at,
       .crush_share = resistance.crush_share});
}

void Equilibrium::part(const Pieces& pieces) {
  const Load* leading = scene_.fixture.leading();
  const double x = leading == nullptr ? 0 : sense_x(leading->way) * scene_.height();
  const double y = leading == nullptr ? scene_.height() : sense_y(leading->way) * scene_.height();
  for (int row = 0; row <= plan_.cells_y; ++row)
    for (int col = 0; col <= plan_.cells_x; ++col) {
      const std::size_t node = shape().node(row, col);
      if (!pieces.is_above(row, col) && !pieces.is_below(row, col)) continue;
      u_.x[node] = pieces.is_above(row, col) ? x : 0;
      u_.y[node] = pieces.is_above(row, col) ? y : 0;
    }
  modulus_top_ = modulus_bottom_ = modulus_leading_ = 0;
}

CellDisplacement Equilibrium::displacement(int row, int cell) const {
  const std::size_t lower = shape().node(row, cell);
  const std::size_t upper = shape().node(row + 1, cell);
  return {{u_.x[lower], u_.x[lower + 1], u_.x[upper], u_.x[upper + 1]},
          {u_.y[lower], u_.y[lower + 1], u_.y[upper], u_.y[upper + 1]}};
}

}  // namespace mpm
