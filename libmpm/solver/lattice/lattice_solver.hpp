/// Small strain on the fixed lattice of pixels: points keep their place in their cell, so that weights are
/// constants and the stress of a live point is C : strain(u), which need not be stored.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "libmpm/scene/result.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/archive.hpp"
#include "libmpm/solver/failure_maps.hpp"
#include "libmpm/solver/force_buffer.hpp"
#include "libmpm/solver/frame.hpp"
#include "libmpm/solver/grid.hpp"
#include "libmpm/solver/lattice/lattice_points.hpp"
#include "libmpm/solver/moving_start.hpp"
#include "libmpm/solver/plan.hpp"
#include "libmpm/solver/threads.hpp"

namespace mpm {

template <class Real>
class LatticeSolver {
 public:
  /// The scene and the plan must outlive the solver.
  LatticeSolver(const Scene& scene, const Plan& plan);

  /// Take up to `steps` time steps (>= 1) on all threads; stops at the last step of the plan, or when a value
  /// is not a number. Returns the ledger of the last step.
  [[nodiscard]] Ledger advance(std::int64_t steps);

  /// Change the velocity of every node between the platens.
  /// @param change  called with its place at rest from the lower left corner, and its velocity: x, y [m],
  /// vx&, vy& [m/s].
  template <class Change>
  void kick(const Change& change) {
    for (int row = 1; row + 1 < grid_.rows; ++row)
      for (int col = 0; col < grid_.cols; ++col) {
        const auto at = static_cast<std::size_t>(grid_.at(row, col));
        change(col * plan_.cell_size, row * plan_.cell_size, grid_.vx[at], grid_.vy[at]);
      }
  }

  [[nodiscard]] std::int64_t steps() const { return clock_.step; }
  /// The state that a step begins with is the one it reports, so the last step is one past the strain asked
  /// for.
  [[nodiscard]] bool is_done() const { return clock_.step > plan_.steps; }

  /// Whether the limits of the hand-over are exceeded: strain of an intact point, or displacement of a node.
  [[nodiscard]] bool outgrows(const Handover& limits) const;
  /// Hand-over to moving points; conserves mass, momentum and stress. Moves the failure maps out.
  [[nodiscard]] MovingStart hand_over();

  /// Frame at the time of the last ledger, without its row of the history.
  void fill(Frame& frame) const;

  /// Failure maps so far.
  void copy_maps(Result& result) const;

  /// The complete state, independent of the number of threads.   @pre at least one step was taken.
  void save(ArchiveWriter& archive) const;
  /// Restore the state of the same scene (threads may differ).   @pre no step was taken. An invalid state is
  /// recorded as a fault of the archive; the solver must not be used then.
  void restore(ArchiveReader& archive);

  [[nodiscard]] double dt() const { return plan_.dt; }                   ///< [s]
  [[nodiscard]] int missing_threads() const { return team_.missing(); }  ///< that the system refused
  /// Name of the point where a value became not-a-number, otherwise of the one with the most elastic energy.
  [[nodiscard]] std::string worst_point() const;

 private:
  /// The first node that was no number.
  struct Loss {
    std::int64_t step = -1;  ///< -1 = all are numbers
    int row = 0, col = 0;    ///< of the node
  };

  /// The rows of cells of one thread. Its lowest row of nodes is shared with the band below.
  struct Band {
    int begin = 0, end = 0;  ///< rows of cells
    /// Of the row at hand and of the one below it, in turn; of each step that is under way.
    std::vector<std::array<ForceBuffer<Real>, 2>> upper;
    ForceBuffer<Real> lower;        ///< of the row at hand
    ForceBuffer<Real> first_lower;  ///< of the lowest row, kept until the band below is done
    AlignedVector<kernels::Flag<Real>> suspects;
    std::int64_t tension_failures = 0, shear_failures = 0;
    std::int64_t dead = 0;  ///< points that have lost all stiffness
    Loss loss;
  };

  /// Where the platen stands; every thread keeps its own, they are equal.
  struct Clock {
    std::int64_t step = 0;     ///< number of the step, from 1
    double displacement = 0;   ///< of the top platen at the beginning of the step, upwards positive [m]
    double velocity = 0;       ///< in the step before [m/s]
    double next_velocity = 0;  ///< in the step [m/s]
  };

  /// What a platen does to the specimen.
  struct Reaction {
    double force = 0;  ///< upwards positive [N/m]
    double work = 0;   ///< [J/m]
  };

  /// Stress now and at the end of the step before [Pa].
  struct StepStress {
    Stress<double> now, before;
  };

  [[nodiscard]] static int most_bands(const Plan& plan);
  void make_bands();
  void find_pinned_node();
  Clock run_band(std::size_t index, Clock clock, std::int64_t steps, Barrier& barrier);
  void advance_clock(Clock& clock) const;
  Clock run_alone(Clock clock, std::int64_t steps);
  void sweep_row(Band& band, std::size_t lane, int row, const Clock& clock, bool ledger);
  [[nodiscard]] const ForceBuffer<Real>& last_upper(const Band& band) const;
  void sweep_cell_row(Band& band, int row, ForceBuffer<Real>& lower, ForceBuffer<Real>& upper, double strain);
  void sweep_node_row(Band& band, int row, const ForceBuffer<Real>& below, const ForceBuffer<Real>& above,
                      const Clock& clock, bool ledger);
  void sweep_platen_row(Band& band, int row, const ForceBuffer<Real>& below, const ForceBuffer<Real>& above,
                        const Clock& clock);
  void note_loss(Band& band, int row, const Clock& clock) const;
  [[nodiscard]] bool is_lost(const Clock& clock);
  [[nodiscard]] Loss first_loss() const;
  [[nodiscard]] std::string point_at_node(int row, int col) const;
  void record_reaction(bool top, double reaction, const Clock& clock);
  [[nodiscard]] Ledger balance() const;
  [[nodiscard]] bool strains_more_than(double limit) const;
  [[nodiscard]] bool strays_more_than(double limit) const;
  [[nodiscard]] PointState state_of(int pixel_row, int pixel_col, std::size_t at) const;
  [[nodiscard]] bool is_intact(int row, int plane, int cell) const;
  void hand_over_pixels(MovingStart& start) const;
  void hand_over_extra_points(MovingStart& start) const;
  [[nodiscard]] StartPoint moved(int row, int cell, double xi, double eta, const Eigen::Matrix3d& c,
                                 const CellDisplacement& u) const;
  void add_pixels(Frame& frame) const;
  void add_extra_points(Frame& frame) const;
  [[nodiscard]] FramePoint frame_point(const StartPoint& point, const PointState& state) const;
  [[nodiscard]] CellDisplacement velocity(int row, int cell) const;

  [[nodiscard]] CellDisplacement displacement(int row, int cell) const;
  [[nodiscard]] CellDisplacement displacement_before(int row, int cell) const;
  [[nodiscard]] StepStress stress_at(const Eigen::Matrix3d& c, int row, int cell, double xi,
                                     double eta) const;
  bool fail_suspects(Band& band, int row, double strain);
  bool fail_point(Band& band, int row, int plane, int cell, double strain);
  static void count(Band& band, FailureMode mode);
  static void count_dead(Band& band, const PointState& before, const PointState& after);
  void record_failure(const Pixel& pixel, FailureMode mode, double strain);
  [[nodiscard]] double released_energy(const PointState& before, const PointState& after,
                                       const StepStress& elastic) const;
  [[nodiscard]] double released_bending(const PointState& before, const PointState& after, int row,
                                        int cell) const;
  void sweep_extra_points(Band& band, int row, const kernels::NodeForces<Real>& lower,
                          const kernels::NodeForces<Real>& upper, double strain);
  void fail_extra_point(Band& band, int row, CellPoint& point, const Stress<double>& elastic, double strain);

  template <class Archive, class Self>
  static void pass(Archive& archive, Self& self);

  const Scene& scene_;
  const Plan& plan_;
  DamageLaw law_;
  StrengthFactors factors_;
  Grid grid_;
  LatticePoints<Real> points_;
  ExtraPoints extra_;
  std::int64_t all_points_ = 0;
  PixelField<std::uint16_t> shares_;  ///< points a pixel; empty when there are no extra points
  Eigen::Matrix3d unit_stiffness_;    ///< of a phase with E = 1 and the plan's Poisson ratio [-]
  kernels::SweepCells<Real> sweep_cells_;
  kernels::SweepNodes<Real> sweep_nodes_;
  kernels::SweepNodes<Real> sweep_nodes_ledger_;
  ForceBuffer<Real> no_force_;
  Team team_;
  std::vector<Band> bands_;
  std::vector<kernels::NodeSums> row_sums_;
  std::vector<double> row_released_, row_damped_;  ///< [J/m]
  int pinned_ = 0;                                 ///< column of the node that a smooth bottom platen holds
  Clock clock_;
  Reaction top_, bottom_;
  FailureMaps maps_;
};

}  // namespace mpm
