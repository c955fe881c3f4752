/// What the cases share: small scenes, each for one thread, bodies of points that fly, and a judge.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/bench/stability.hpp"
#include "libmpm/run/simulate.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/moving/moving_solver.hpp"
#include "libmpm/solver/plan.hpp"

namespace app::bench {

/// Collects what a case measures, and whether all of it is as it must be.
class Judge {
 public:
  /// Something that is seen and must hold.
  Judge& must(bool holds, const std::string& seen);
  /// A figure that is shown and bound to nothing.
  Judge& note(const std::string& seen);
  /// |value / exact - 1| <= tolerance; not-a-number fails.
  Judge& near(const std::string& what, double value, double exact, double tolerance);
  /// The trouble that ended a run of so many steps must be none.
  Judge& no_trouble(const std::string& trouble, std::int64_t steps);
  /// value <= limit; not-a-number fails.
  Judge& below(const std::string& what, double value, double limit);

  /// Holds when something was judged and all of it held.
  [[nodiscard]] Finding finding() const;

 private:
  Judge& add(const std::string& seen);

  bool holds_ = true;
  bool judged_ = false;
  std::string seen_;
};

inline constexpr std::uint8_t first = 1, second = 2, third = 3;  ///< labels

/// A phase that does not break. young [Pa], density [kg/m^3].
[[nodiscard]] mpm::Phase elastic(double young = 20e9, double poisson = 0.2, double density = 2400);

/// A block of `first`, in tension between smooth platens. Rows and columns in pixels of 0.5 mm.
[[nodiscard]] mpm::Scene block(int rows, int cols, const mpm::Phase& phase);

/// Round aggregates in mortar, each with a ring of ITZ: `first`, `second` and `third` of Table 1.
/// Source: Liu et al. (2020).
[[nodiscard]] mpm::Scene concrete(int rows, int cols);

[[nodiscard]] mpm::Scene unbreakable(mpm::Scene scene);

/// Stiffness and strengths times s, density times r and speeds times sqrt(s / r): the law is linear, so that
/// every stress is s times what it was, and the same points fail.
[[nodiscard]] mpm::Scene scaled(mpm::Scene scene, double s, double r = 1);

/// A block of 16 x 16 pixels, `first` and `second` by turns.
[[nodiscard]] mpm::Scene checkerboard(const mpm::Phase& one, const mpm::Phase& other);

/// So slow and damped that the end of the run is as good as static.
/// @param transits  of a wave through the slowest phase while the specimen is loaded to `strain` [-].
void load_slowly(mpm::Scene& scene, double strain = 1e-4, double transits = 30);

/// Stress over strain at the end [Pa].
[[nodiscard]] double end_modulus(const mpm::Result& result);

/// Young's modulus between smooth platens in plane strain [Pa].
[[nodiscard]] double plane_modulus(const mpm::Phase& phase);

/// Largest difference of the stress in any row of two runs, over the peak of the first, when that of the
/// second is multiplied by a scale; infinite when they have not the same rows.
[[nodiscard]] double curve_difference(const mpm::Result& a, const mpm::Result& b, double scale);

/// Whether stress, strain and energies of all rows are numbers.
[[nodiscard]] bool is_finite(const mpm::Result& result);

/// A run that may go wrong.
struct Attempt {
  mpm::Result result;
  std::optional<std::string> diverged;  ///< what was said; nothing when it came to its end
};
[[nodiscard]] Attempt attempt(const mpm::Scene& scene, const mpm::Plan& plan);
[[nodiscard]] Attempt attempt(const mpm::Scene& scene);

/// Void with room for bodies of a soft phase, label 1, in which waves run at 100 m/s: Young's modulus 10 MPa,
/// density 1000 kg/m^3, no Poisson's effect. Pixels of 50 mm, no platens.
[[nodiscard]] mpm::Scene sky(int rows, int cols);

/// Puts a disc there; places in pixels from the lower left corner.
void add_disc(mpm::Scene& scene, double x, double y, double radius);

/// Sums over points.
struct Sums {
  double mass = 0;     ///< [kg/m]
  double px = 0;       ///< momentum [kg/s]
  double py = 0;       ///< [kg/s]
  double x = 0;        ///< centre of mass [m]
  double y = 0;        ///< [m]
  double spin = 0;     ///< angular momentum about that centre [kg m/s]
  double kinetic = 0;  ///< [J/m]
};
[[nodiscard]] Sums sums_of(const std::vector<mpm::PointView>& points);

/// A scene with its plan and its solver.
struct Flight {
  mpm::Scene scene;
  mpm::Plan plan;
  mpm::MovingSolver<double> solver;

  explicit Flight(mpm::Scene what)
      : scene(std::move(what)),
        plan(mpm::plan(scene)),
        solver(scene, plan, mpm::pictured_start(scene, plan)) {}
  Flight(const Flight&) = delete;
  Flight& operator=(const Flight&) = delete;
};

/// The true critical time step of a lattice.
struct CriticalStep {
  double dt = 0;           ///< 2 / omega_max [s]
  double uncertainty = 0;  ///< residual of omega_max^2 over itself [-]
};

/// Of intact points between their platens, whose motion is given. Lanczos on M^-1/2 K M^-1/2, with K applied
/// point by point and never made; a few hundred nodes take milliseconds.
/// Source: Lanczos (1950), with full reorthogonalization.
[[nodiscard]] CriticalStep critical_step(const mpm::Scene& scene, const mpm::Plan& plan);

}  // namespace app::bench
