/// Moving points: the full explicit material point method. Points move through the grid and carry mass,
/// velocity and stress; the grid is reset in each step.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "libmpm/scene/result.hpp"
#include "libmpm/solver/archive.hpp"
#include "libmpm/solver/failure_maps.hpp"
#include "libmpm/solver/frame.hpp"
#include "libmpm/solver/moving/moving_grid.hpp"
#include "libmpm/solver/moving/moving_points.hpp"
#include "libmpm/solver/moving_start.hpp"
#include "libmpm/solver/threads.hpp"

namespace mpm {

/// State of a point, for observers.
struct PointView {
  std::uint32_t id = 0;                  ///< as StartPoint::id
  double x = 0, y = 0;                   ///< in the picture [m]
  double vx = 0, vy = 0;                 ///< [m/s]
  double mass = 0;                       ///< [kg/m]
  double volume = 0;                     ///< [m^2]
  Stress<double> stress;                 ///< of the intact material [Pa]
  double gradient[4] = {0, 0, 0, 0};     ///< velocity gradient of APIC, row by row [1/s]
  double deformation[4] = {1, 0, 0, 1};  ///< deformation gradient, row by row [-]; when the plan has it
};

template <class Real>
class MovingSolver {
 public:
  /// The scene and the plan must outlive the solver.
  MovingSolver(const Scene& scene, const Plan& plan, MovingStart start);

  /// Take up to `steps` time steps (>= 1) on all threads. Stops early at the final strain or duration, or on
  /// a fault. Returns the ledger of the last step.
  [[nodiscard]] Ledger advance(std::int64_t steps);

  [[nodiscard]] std::int64_t steps() const { return clock_.step; }
  [[nodiscard]] double time() const { return clock_.time; }              ///< [s]
  [[nodiscard]] double dt() const { return clock_.dt; }                  ///< of the last step [s]
  [[nodiscard]] int missing_threads() const { return team_.missing(); }  ///< that the system refused
  [[nodiscard]] bool is_done() const;

  /// Frame after the last step, without its row of the history.
  void fill(Frame& frame) const;

  /// Failure maps so far, and the positions of the points.
  void copy_maps(Result& result) const;

  /// The complete state, independent of the number of threads.   @pre at least one step was taken.
  void save(ArchiveWriter& archive) const;
  /// Restore the state of the same scene (threads may differ) and instruction set.   @pre the solver has no
  /// points. An invalid state is recorded as a fault of the archive; the solver must not be used then.
  void restore(ArchiveReader& archive);

  /// Name of the point with the most kinetic and elastic energy per mass.
  [[nodiscard]] std::string worst_point() const;

  /// All points, in the internal order of the solver.
  [[nodiscard]] std::vector<PointView> points() const;
  /// Change the velocity of every point: by a body force, or to start from.
  using Kick = std::function<void(const PointView& point, double& vx, double& vy)>;
  void kick(const Kick& change);

 private:
  using Slot = typename MovingPoints<Real>::Slot;
  using Loose = typename MovingPoints<Real>::Loose;
  using Field = AlignedVector<Real> MovingGrid<Real>::*;

  /// What an edge took from the specimen in a step.
  struct Impulses {
    double bottom = 0, top = 0;  ///< on the specimen, upwards [N s/m]
    double work = 0;             ///< of the platens [J/m]
  };

  /// Rows of tiles of one thread, and the rows of nodes that begin with them.
  struct Band {
    int begin = 0, end = 0;
    std::vector<std::uint8_t> flags;   ///< by block
    std::vector<Loose> movers;         ///< points that left their tile
    std::vector<std::int64_t> failed;  ///< by label, in this step
    Real fastest = 0;                  ///< largest square of a speed [m^2/s^2]
    std::int64_t tension_failures = 0, shear_failures = 0;
  };

  /// What changes from step to step.
  struct Clock {
    std::int64_t step = 0;
    double time = 0;          ///< at the beginning of the step [s]
    double dt = 0;            ///< [s]
    double displacement = 0;  ///< of the top platen at the beginning of the step, upwards positive [m]
    double velocity = 0;      ///< of the top platen in the step [m/s]
    bool stopped = false;     ///< the run has ended
  };

  [[nodiscard]] static int most_bands(int threads, const MovingGeometry& geometry);
  [[nodiscard]] static std::vector<Band> make_bands(const Scene& scene, int count);
  void share_rows();
  [[nodiscard]] std::vector<std::int64_t> work_of_rows() const;
  void load_points(const MovingStart& start);
  void reserve_points(const MovingStart& start);
  [[nodiscard]] Loose loose_point(const StartPoint& point) const;
  [[nodiscard]] TilePlace place_of(double x, double y, Real& xi, Real& eta) const;

  void run_band(std::size_t index, std::int64_t steps, Barrier& barrier);
  void begin_step();
  void choose_time_step();
  void end_step();
  void step_usf(Band& band, Barrier& barrier);
  void step_usl(Band& band, Barrier& barrier);
  void step_musl(Band& band, Barrier& barrier);

  template <class Tiles1, class Nodes1, class Tiles2, class Nodes2, class Tiles3>
  void sweep_in_waves(Band& band, Barrier& barrier, Tiles1&& tiles_1, Nodes1&& nodes_1, Tiles2&& tiles_2,
                      Nodes2&& nodes_2, Tiles3&& tiles_3);
  void scatter(moving::Scatter<Real> sweep, int row);
  void sum_momentum(int node_row);
  void sum_new_momentum(int node_row);
  void integrate_momentum(int node_row);
  void choose_brought_velocity(int node_row);
  void choose_straining_velocity(int node_row);
  void gather(moving::Gather<Real> sweep, Band& band, int row);
  void follow(moving::Follow<Real> sweep, Band& band, int row);
  void take_out_movers(Band& band, int row);
  void resort();

  /// Bits of contact_.
  static constexpr std::uint8_t touches_upright = 1, touches_across = 2;
  template <class Visit>
  void for_held_nodes(int node_row, Visit&& visit);
  void hold(int node_row);
  void hold_node(int node_row, int col);
  void hold_straining_velocity(int node_row);
  void hold_straining(int node_row, int col);
  [[nodiscard]] bool is_pinned(int node_row, int col);
  [[nodiscard]] int pinned_column(int node_row);

  void fail_suspects(Band& band, int row);
  void fail_point(Band& band, const Slot& slot);
  [[nodiscard]] double nominal_strain() const;
  [[nodiscard]] PointState read_state(const Slot& slot, const PointOrigin& origin) const;
  void write_state(const PointState& state, Real* fields, int stride) const;
  void record_failure(const PointOrigin& origin, FailureMode mode);

  [[nodiscard]] moving::NodeVectors<Real> nodes(int tile_row, Field x, Field y) const;
  [[nodiscard]] moving::TileRow<Real> tiles(int row);
  [[nodiscard]] PointView view(const Slot& slot) const;
  [[nodiscard]] FramePoint frame_point(const Slot& slot) const;
  [[nodiscard]] double cell_height(double displacement) const;
  [[nodiscard]] Ledger balance();
  [[nodiscard]] double energy_of(const Loose& point) const;
  [[nodiscard]] bool is_inside(const Loose& point) const;
  [[nodiscard]] bool stays_at_support(Loose& point) const;
  void leave(const Loose& point);
  void stop(std::string what);
  template <class Archive, class Self>
  static void pass(Archive& archive, Self& self);

  const Scene& scene_;
  const Plan& plan_;
  moving::Sweeps<Real> sweeps_;
  moving::Integrate<Real> integrate_undamped_;
  MovingGeometry geometry_;
  Supports supports_;
  DamageLaw law_;
  StrengthFactors factors_;
  MovingGrid<Real> grid_;
  Team team_;
  std::vector<Band> bands_;
  TileSums<Real> momentum_, force_, new_momentum_;
  MovingPoints<Real> points_;
  moving::Step<Real> step_{};
  std::vector<std::uint8_t> contact_;   ///< by node: which supports it touches
  std::vector<Impulses> row_impulses_;  ///< by row of nodes, in this step
  std::vector<double> row_damped_;      ///< by row of nodes, in all [J/m]
  std::vector<double> row_released_;    ///< by row of tiles, in all [J/m]
  std::vector<std::int64_t> live_;      ///< points that carry load, by label
  std::vector<double> speeds_;          ///< of the compression wave, by label [m/s]
  Real least_mass_ = 0, light_mass_ = 0;
  bool slopes_from_straining_ = false;  ///< APIC takes its gradients from the straining velocity
  int pinned_ = -1;                     ///< column of the node that smooth platens hold; -1 = not chosen yet
  double first_dt_ = 0;                 ///< [s]
  Real start_fastest_ = 0;              ///< largest square of a speed that the points were given [m^2/s^2]
  Clock clock_;
  Tally start_;  ///< what was there before the first step
  Tally sums_;
  double force_top_ = 0, force_bottom_ = 0;  ///< in the last step [N/m]
  double reported_displacement_ = 0;         ///< at the beginning of the last step [m]
  double reported_time_ = 0;
  std::int64_t left_ = 0;
  double left_energy_ = 0;
  std::string failure_;  ///< fault; empty = none
  FailureMaps maps_;
};

}  // namespace mpm
