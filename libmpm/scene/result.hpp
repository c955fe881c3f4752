/// The result of a run, and the names, units and meanings of the columns of its history, defined once for
/// every file that contains them.
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
  double time = 0;    ///< since the start [s]
  double strain = 0;  ///< displacement of the top platen over the height [-]
  /// Mean of the reactions of both platens over the width; without platens the sum of the reactions of the
  /// lower and the upper edge over the width [Pa].
  double stress = 0;
  double stress_top = 0;              ///< reaction of the top platen over the width [Pa]
  double stress_bottom = 0;           ///< reaction of the bottom platen over the width [Pa]
  double platen_work = 0;             ///< work of the platens so far [J/m]
  double kinetic = 0;                 ///< kinetic energy [J/m]
  double elastic = 0;                 ///< elastic energy [J/m]
  double released = 0;                ///< elastic energy lost by failing points so far [J/m]
  double damped = 0;                  ///< energy dissipated by local damping so far [J/m]
  double left = 0;                    ///< energy of the points that have left through open edges so far [J/m]
  std::int64_t tension_failures = 0;  ///< points that have failed in tension so far
  std::int64_t shear_failures = 0;    ///< points that have failed in shear so far
  std::int64_t left_points = 0;       ///< points that have left through open edges so far
  std::int64_t moving_points = 0;     ///< moving points; 0 during small strain
};

/// By how much the reactions of both platens differ, over the sum of their amounts [-]: the share of them
/// that is inertia and damping, not stress that the specimen carries from platen to platen. 0 for no
/// reactions.
[[nodiscard]] double platen_imbalance(const HistoryRow& row);

/// Imbalance of the platens above which a stress is a wave that has not crossed the specimen [-].
inline constexpr double balanced = 0.5;

/// How a point failed.
enum class FailureMode : std::uint8_t { none = 0, tension = 1, shear = 2 };

/// Why a run ended.
enum class StopReason {
  strain,       ///< stop_strain was reached
  time,         ///< Loading::duration was reached
  drop,         ///< the stress fell below stop_drop times its peak, or no point carries load any more
  interrupted,  ///< the observer ended it
};

/// What a gauge has read.
struct GaugeReadings {
  std::string name;
  std::vector<double> values;  ///< by row of the history [m]
};

/// Maps have the shape (rows, cols) of Scene::labels, row 0 at the top; NaN = no value.
struct Result {
  std::vector<HistoryRow> history;    ///< the first row is the initial state
  std::vector<GaugeReadings> gauges;  ///< those of the scene, in its order
  /// Largest stress of the history [Pa], which is a peak if peak_reached() says so. Of platens whose
  /// imbalance is above `balanced`, the lesser reaction counts: what the greater one has beyond it moves the
  /// specimen, and does not pass through it.
  double peak_stress = 0;
  double peak_strain = 0;  ///< platen strain at that stress [-]
  /// Platen strain at which the point of a pixel failed [-]; NaN = it did not fail. With failure_mode it
  /// gives the damage at any strain. On a path that snaps back it is the largest strain until then.
  PixelField<float> failure_strain;
  PixelField<std::uint8_t> failure_mode;  ///< FailureMode of the point of a pixel
  /// With crack closure: platen strain at which a cracked point was crushed in shear [-]; otherwise empty.
  PixelField<float> crush_strain;
  /// With moving points: final position of the point of a pixel, from the lower left corner [m]; NaN = there
  /// is none. Otherwise empty.
  PixelField<float> end_x, end_y;
  /// With Motion::deformation_gradient: final F of the point of a pixel [-], as xx, xy, yx, yy; otherwise
  /// empty.
  std::array<PixelField<float>, 4> deformation;
  std::vector<float> extra_failure_strain;  ///< failure_strain of Scene::extra_points, in their order [-]
  std::vector<std::uint8_t> extra_failure_mode;  ///< failure_mode of Scene::extra_points, in their order
  std::int64_t tension_failures = 0;             ///< including extra points
  std::int64_t shear_failures = 0;               ///< including crushed points
  std::int64_t points = 0;                       ///< material points
  std::int64_t steps = 0;                        ///< time steps
  double dt = 0;                                 ///< time step [s]
  double wall_time = 0;                          ///< of the time loop [s]
  double energy_error = 0;      ///< largest imbalance of the energy ledger over the largest platen work [-]
  std::string instruction_set;  ///< used by the kernels, e.g. "avx512"
  std::int64_t threads = 1;     ///< threads used
  std::int64_t missing_threads = 0;  ///< that the system refused; not kept in files
  StopReason stop = StopReason::strain;
  bool nothing_carries = false;  ///< every point has lost all stiffness, which ended the run

  /// Speed of the time loop [1/s]; 0 without a wall time.
  [[nodiscard]] double point_updates_per_second() const {
    return wall_time > 0 ? static_cast<double>(points) * static_cast<double>(steps) / wall_time : 0;
  }
};

/// A column of the history: values or counts.
struct HistoryColumn {
  std::string_view name;     ///< name of the member of HistoryRow
  std::string_view unit;     ///< SI unit; "1" = dimensionless
  std::string_view meaning;  ///< one line
  std::variant<double HistoryRow::*, std::int64_t HistoryRow::*> member;
};

/// All columns, in the order of HistoryRow.
[[nodiscard]] const std::array<HistoryColumn, 15>& history_columns();

/// Share of the largest stress that the stress must have lost since, for that to be a peak [-].
inline constexpr double lost_after_peak = 0.05;

/// Whether the largest stress of a run is a peak: whether the stress has since fallen by `lost_after_peak`.
/// Of a run that ended before, the largest stress is a lower bound of the peak only.
[[nodiscard]] bool peak_reached(const Result& result);

/// The largest stress of a run or its strain [Pa, -], where that is a peak; NaN otherwise.
/// @param figure  &Result::peak_stress or &Result::peak_strain.
[[nodiscard]] double peak_of(const Result& result, double Result::*figure);

/// How far the stress has fallen since its largest value, over that [-], in [0, 1] unless the stress changes
/// its sign; 0 for a run whose largest stress is its last, or is none.
[[nodiscard]] double fall_after_peak(const Result& result);

}  // namespace mpm
