/// A scene: plain data that says everything about a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "libmpm/lattice.hpp"
#include "libmpm/phase.hpp"

namespace mpm {

enum class Direction { tension, compression };

/// How a platen holds the specimen sideways: smooth = free (one node pinned), rough = no sideways motion.
enum class Platen { smooth, rough };

enum class Precision {
  single,   ///< stresses in 32 bits, motion of the nodes in 64 bits
  double_,  ///< 64 bits throughout
};

/// A material point beside those of the pixels; shares the volume of its pixel with the points that lie in
/// it.
struct ExtraPoint {
  double x = 0;            ///< [m]
  double y = 0;            ///< [m]
  std::uint8_t phase = 0;  ///< label
};

struct Loading {
  Direction direction = Direction::tension;
  double velocity = 0.05;  ///< of the top platen, its amount [m/s], > 0
  double ramp_time = -1;   ///< from rest to full velocity [s]; < 0 = two transits of the slowest wave
  Platen platen = Platen::smooth;
  double stop_strain = 4e-4;        ///< platen displacement over height at which the run ends [-], > 0
  std::optional<double> stop_drop;  ///< ends below this share of the peak stress [-], in (0, 1)
};

/// What a point that failed in tension does when it is compressed.
enum class CrackClosure {
  off,         ///< nothing: it is a ghost point
  clipped,     ///< it carries its elastic stress with positive principal stresses clipped to zero; opening a
               ///< crack then relieves compression along it, and energy is not kept (the ledger shows it)
  unilateral,  ///< the same without what Poisson's effect of the opening did to the stress along the crack;
               ///< keeps energy
};

struct Damage {
  std::uint64_t seed = 1;  ///< of the strength field
  CrackClosure crack_closure = CrackClosure::off;
  double residual_stiffness = 0;  ///< share of the stiffness that a failed point keeps [-], in [0, 1)
};

struct Scene {
  Lattice<std::uint8_t> labels;              ///< label per pixel, row 0 on top
  double pixel_size = 0;                     ///< [m], > 0
  std::vector<std::optional<Phase>> phases;  ///< by label; nullopt = void
  std::vector<ExtraPoint> extra_points;

  Plane plane = Plane::strain;
  int points_per_cell = 2;  ///< along an edge of a cell: 1, 2, 3, 4; 2 means 2 x 2 points a cell
  Loading loading;
  Damage damage;
  double local_damping = 0;  ///< share of the unbalanced force that opposes the motion [-], in [0, 1)
  double cfl = 0.5;          ///< time step over cell size by fastest wave speed [-], in (0, 1]
  Precision precision = Precision::double_;
  int threads = 1;  ///< >= 1; does not change the result
  std::string
      instruction_set;  ///< of the sweeps: baseline, avx2, avx512; empty = the fastest that the processor has
  int history_rows = 1000;  ///< rows of the history up to stop_strain, >= 10

  [[nodiscard]] double width() const { return static_cast<double>(labels.cols()) * pixel_size; }   ///< [m]
  [[nodiscard]] double height() const { return static_cast<double>(labels.rows()) * pixel_size; }  ///< [m]
};

/// @throws Error naming the first value that is out of range.
void validate(const Scene& scene);

}  // namespace mpm
