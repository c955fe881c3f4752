/// Fracture without waves: the specimen is in equilibrium at every strain, and fails point by point.
///
/// Between two failures everything is linear. At a platen strain of 1 the solution U of the points that still
/// live gives each of them the strain at which it fails; the smallest is next. If it lies below the strain
/// that the platens have reached, the failure belongs to an avalanche at that strain; or, on the path that
/// snaps back, the platens go back to it. No velocity, time step, density or damping is involved. Cracks that
/// close change nothing of this: which of them are open depends on the direction of the strain alone.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "libmpm/material/failure.hpp"
#include "libmpm/material/strength.hpp"
#include "libmpm/scene/result.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/archive.hpp"
#include "libmpm/solver/failure_maps.hpp"
#include "libmpm/solver/frame.hpp"
#include "libmpm/solver/plan.hpp"
#include "libmpm/solver/quasi_static/equilibrium.hpp"

namespace mpm {

class QuasiStaticSolver {
 public:
  /// The scene and the plan must outlive the solver.
  QuasiStaticSolver(const Scene& scene, const Plan& plan);
  /// With given strength factors q [-], shape of the labels, instead of those of the seed.
  QuasiStaticSolver(const Scene& scene, const Plan& plan, const PixelField<double>& factors);

  /// Take up to `steps` steps (>= 1), each from one state in equilibrium to the next one at which a point
  /// fails, or on a path that snaps back to the one after the drop; stops at stop_strain. Returns the ledger
  /// of the last state, before its points fail.
  [[nodiscard]] Ledger advance(std::int64_t steps);

  [[nodiscard]] std::int64_t steps() const { return steps_; }
  [[nodiscard]] std::int64_t iterations() const { return equilibrium_.iterations(); }  ///< so far
  [[nodiscard]] bool is_done() const { return done_; }
  [[nodiscard]] double dt() const { return 0; }  ///< there is no time
  [[nodiscard]] int missing_threads() const {
    return equilibrium_.missing_threads();
  }  ///< that the system refused

  /// State of the last ledger.
  void fill(Frame& frame) const;
  void copy_maps(Result& result) const { maps_.copy_to(result); }
  void save(ArchiveWriter& archive) const;
  /// @pre no step was taken.
  void restore(ArchiveReader& archive);
  [[nodiscard]] std::string worst_point() const { return {}; }

 private:
  /// What the failure criteria need of a phase.
  struct Limits {
    Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();  ///< of the plane [Pa]
    double normal = 0;    ///< out-of-plane stress over the sum of those in the plane [-]
    double tension = 0;   ///< f_t [Pa]; infinite for a phase that does not crack
    double sine = 0;      ///< of the friction angle
    double cohesion = 0;  ///< 2 c cos(phi) [Pa]; infinite for a phase that does not shear
  };

  using Place = PointPlace;

  /// Failure of a point at a platen strain.
  struct Onset {
    double strain = 0;  ///< [-]; infinite = never
    FailureMode mode = FailureMode::none;
  };

  void step();
  /// What a point has left: of its tension [Pa], and the share of its cohesion [-].
  struct Left {
    double strength = 0, cohesion = 1;
  };
  [[nodiscard]] static Onset onset_of(const Limits& limits, double factor, const Left& left,
                                      const Stress<double>& stress);
  template <class Visit>
  void each_point(const Visit& visit) const;
  [[nodiscard]] const Limits& limits_at(const Place& at) const;
  [[nodiscard]] Stress<double> elastic_at(const Limits& limits, const Place& at, double strain) const;
  [[nodiscard]] double strength_at(const Place& at, std::size_t index) const;
  [[nodiscard]] Left left_at(const Place& at, std::size_t index) const;
  [[nodiscard]] PointState state_at(const Place& at, std::size_t index) const;
  [[nodiscard]] Onset onset_at(const Place& at, std::size_t index) const;
  template <class Visit>
  void each_point_near(double strain, const Visit& visit) const;
  void set_resistance(const Place& at, std::size_t index);
  [[nodiscard]] double least_kept() const;
  void record(const Place& at, FailureMode mode, double strain);
  [[nodiscard]] PointState gone(const Place& at, std::size_t index, FailureMode mode, double strain);
  [[nodiscard]] PointState cracked_through(const Place& at, std::size_t index, double strain);
  [[nodiscard]] PointState softened(const Place& at, std::size_t index, double strain);
  [[nodiscard]] PointState sheared(const Place& at, std::size_t index, double strain);
  [[nodiscard]] PointState failed(const Place& at, std::size_t index, const Onset& onset, double strain);
  [[nodiscard]] bool closes() const { return plan_.features.crack_closure; }
  void find_utilisations(int row);
  void find_onsets();
  void add_work(double strain);
  void take_work(double before);
  void move_platens(double before);
  [[nodiscard]] double strain_at(double reading) const;
  void follow_gauge(double before);
  [[nodiscard]] double end_strain() const;
  [[nodiscard]] double volume() const { return scene_.width() * scene_.height(); }
  void move_on();
  [[nodiscard]] bool is_live(double share) const;
  [[nodiscard]] bool may_be_loose(std::int64_t iterations) const;
  void take_out_loose();
  void take_out(const Pieces& pieces);
  [[nodiscard]] double energy_of(const Place& at, const PointState& point) const;
  [[nodiscard]] bool has_failed(const Place& at) const;
  [[nodiscard]] FramePoint frame_point(const Place& at, FramePoint start) const;
  void add_extra_points(Frame& frame) const;
  [[nodiscard]] bool snaps_back() const { return scene_.loading.path == LoadingPath::snap_back; }
  void fail_points(double strain, double up_to);
  [[nodiscard]] Ledger ledger() const;
  [[nodiscard]] double energy() const;  ///< elastic energy at the strain reached [J/m]
  template <class Archive, class Self>
  static void pass(Archive& archive, Self& self);
  template <class Archive, class Points>
  static void pass_points(Archive& archive, Points& points);

  const Scene& scene_;
  const Plan& plan_;
  Equilibrium equilibrium_;
  DamageLaw law_;
  std::vector<Limits> limits_;  ///< by label
  AlignedVector<double>
      factors_;  ///< q of each point by its number, see LatticeCells [-]; 0 = it cannot fail (any more)
  AlignedVector<double>
      strengths_;  ///< largest principal stress that each point carries [Pa]; empty if it stays f_t q
  AlignedVector<double>
      cohesions_;  ///< share of its cohesion that each point has left; empty if it keeps all
  Resistance resistance_;
  std::vector<double> utilisations_;  ///< at a platen strain of 1, the largest of each row and place in its
                                      ///< cells; then that of its extra points
  double next_ = 0;                   ///< smallest strain at which a point fails [-]
  FailureMaps maps_;
  Tally tally_;
  double sign_ = 1;      ///< of the platen strain
  double strain_ = 0;    ///< now, without sign [-]
  double farthest_ = 0;  ///< largest of them so far [-]
  double modulus_ = 0;   ///< of the last state [Pa]
  double spent_ = 0;     ///< energy that the points lose that fail now, at their strain [J/m]
  int control_ = -1;     ///< number of the gauge that controls the run; -1 = the platens do
  double reading_ = 0;   ///< its largest so far [m]
  std::int64_t steps_ = 0;
  std::int64_t carrying_ = 0;
  bool done_ = false;
  bool has_dropped_ = false;  ///< the last state is that after a drop, before which nothing else fails
  bool lost_ = false;         ///< no equilibrium was found
  bool parted_ = false;       ///< no way of live points joins the platens
};

template <class Visit>
void QuasiStaticSolver::each_point(const Visit& visit) const {
  for (int row = 0; row < plan_.cells_y; ++row)
    equilibrium_.each_point(row, [&](const Place& at) { visit(at, equilibrium_.index(at)); });
}

}  // namespace mpm
