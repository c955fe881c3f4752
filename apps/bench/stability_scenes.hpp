/// Collects what a case measures, and whether all of it is as it must be.
/// Small scenes that the cases share, each for one thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "apps/bench/stability.hpp"
#include "libmpm/run/simulate.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/plan.hpp"

namespace app::bench {

class Judge {
 public:
  /// Something that is seen and must hold.
  Judge& must(bool holds, const std::string& seen);
  /// A figure that is shown and bound to nothing.
  Judge& note(const std::string& seen);
  /// |value / exact - 1| <= tolerance; not-a-number fails.
  Judge& near(const std::string& what, double value, double exact, double tolerance);
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

/// Pixels of `second` on every other place.
void checkerboard(mpm::Scene& scene, const mpm::Phase& other);

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

}  // namespace app::bench
