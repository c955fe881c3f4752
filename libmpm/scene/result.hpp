/// What a run leaves behind.
/// The history as a table: names, units and meanings of its columns, said once for every file that holds it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "libmpm/scene/phase.hpp"

namespace mpm {

/// One row of the history. Stress and strain are positive in the direction of the loading. Energies are per
/// metre of thickness [J/m].
struct HistoryRow {
  double time = 0;    ///< [s]
  double strain = 0;  ///< platen displacement over height [-]
  double stress = 0;  ///< mean of the reactions of both platens, or their sum without platens, over the width
                      ///< [Pa]
  double stress_top = 0;     ///< [Pa]
  double stress_bottom = 0;  ///< [Pa]
  double platen_work = 0;    ///< put in so far
  double kinetic = 0;
  double elastic = 0;
  double released = 0;  ///< elastic energy of the points that failed, when they failed
  double damped = 0;    ///< taken by local damping so far
  double left = 0;      ///< energy of the points that have left through open edges
  std::int64_t tension_failures = 0;
  std::int64_t shear_failures = 0;
  std::int64_t left_points = 0;    ///< that have left through open edges
  std::int64_t moving_points = 0;  ///< points that move; 0 while small strain holds
};

enum class FailureMode : std::uint8_t { none = 0, tension = 1, shear = 2 };

enum class StopReason {
  strain,       ///< stop_strain was reached
  time,         ///< the duration is over
  drop,         ///< the stress fell below stop_drop of its peak, or nothing carries load any more
  interrupted,  ///< the observer asked for it
};

struct Result {
  std::vector<HistoryRow> history;  ///< the first row is the state at rest
  double peak_stress = 0;           ///< [Pa]
  double peak_strain = 0;           ///< platen strain at the peak [-]
  /// Platen strain at which the point of a pixel failed, NaN = it did not; the picture of damage at any
  /// strain follows from this and the mode.
  PixelField<float> failure_strain;
  PixelField<std::uint8_t> failure_mode;  ///< FailureMode of that failure
  /// With crack closure only: platen strain at which a point that had cracked was crushed in shear; else
  /// empty.
  PixelField<float> crush_strain;
  /// With moving points only: where the point of a pixel is at the end, in the picture [m]; NaN = there is
  /// none. Else empty.
  PixelField<float> end_x, end_y;
  /// With Motion::deformation_gradient only: F of the point of a pixel at the end [-], xx, xy, yx, yy; else
  /// empty.
  std::array<PixelField<float>, 4> deformation;
  std::vector<float> extra_failure_strain;       ///< the same for Scene::extra_points, in their order
  std::vector<std::uint8_t> extra_failure_mode;  ///< the same for Scene::extra_points, in their order
  std::int64_t tension_failures = 0;             ///< extra points included
  std::int64_t shear_failures = 0;               ///< crushed ones included
  std::int64_t points = 0;                       ///< material points that were solved for
  std::int64_t steps = 0;
  double dt = 0;                ///< [s]
  double wall_time = 0;         ///< of the time loop [s]
  double energy_error = 0;      ///< largest imbalance of the ledger over the platen work [-]
  std::string instruction_set;  ///< that the kernels ran on, e.g. "avx512"
  std::int64_t threads = 1;     ///< that shared the work
  StopReason stop = StopReason::strain;
  bool nothing_carries = false;  ///< every point has lost all stiffness: the run ended with the specimen

  [[nodiscard]] double point_updates_per_second() const {
    return wall_time > 0 ? static_cast<double>(points) * static_cast<double>(steps) / wall_time : 0;
  }
};

/// A column of the history, either of measured values or of counts.
struct HistoryColumn {
  std::string_view name;     ///< as the member of HistoryRow
  std::string_view unit;     ///< SI; "1" = without
  std::string_view meaning;  ///< one line
  std::variant<double HistoryRow::*, std::int64_t HistoryRow::*> member;
};

/// All columns, in the order of HistoryRow.
[[nodiscard]] const std::array<HistoryColumn, 15>& history_columns();

}  // namespace mpm
