/// Everything that a user can choose, as plain data. The defaults are those of the libraries' own structs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libmpm/scene/phase.hpp"
#include "libmpm/scene/scene.hpp"
#include "specimen/body/ellipse.hpp"
#include "specimen/body/ring.hpp"
#include "specimen/convert/convert.hpp"
#include "specimen/pack/packing.hpp"

namespace app {

/// What a specimen is made from.
enum class Source { generated, ellipses, picture, file };

/// Where the specimen comes from; at most one of file, picture, ellipses and ellipse_list is given, and none
/// of them means random ellipses.
struct SpecimenChoice {
  std::string file;                             ///< path of a specimen.h5
  std::string picture;                          ///< path of a picture
  std::string ellipses;                         ///< path of a CSV list
  std::vector<specimen::Ellipse> ellipse_list;  ///< as written in the scene itself
  std::string sha256;                           ///< expected of that file; empty = any
};

/// Sizes of random aggregates: a named curve between two diameters, or explicit classes.
struct GradingChoice {
  std::string name = "fuller";
  double d_min = specimen::PackingOptions().grading.back().d_min;   ///< [m]
  double d_max = specimen::PackingOptions().grading.front().d_max;  ///< [m]
  bool walraven = false;      ///< turn the volume curve into area shares of a plane cut
  specimen::Grading classes;  ///< used instead of the named curve where not empty
};

/// What is cut out of a specimen: a rectangle (x, y, width, height) or a circle (x, y, radius), from its
/// lower left corner [m]; empty = it is not that.
struct Cut {
  std::vector<double> rectangle, circle;
  bool keeps_inside = false;  ///< all beyond it is cut off instead
};

/// That of the library, with the cell and the damping that suit its kinematics.
[[nodiscard]] mpm::Scene default_scene();

struct Settings {
  SpecimenChoice specimen;
  double pixel_size = 0.5e-3;        ///< of drawn ellipses [m]
  specimen::PackingOptions packing;  ///< its grading is not used: see packing_options()
  GradingChoice grading;
  specimen::ConvertOptions convert;
  specimen::ItzOptions itz;
  std::vector<Cut> cuts;
  std::vector<mpm::Phase> phases = mpm::concrete_phases();
  mpm::Scene scene = default_scene();       ///< loading, damage and solver; no labels, no phases
  bool automatic_cell = true;               ///< its cell follows from its kinematics, see follow_kinematics()
  bool automatic_damping = true;            ///< so does its local damping
  std::optional<double> stop_displacement;  ///< of the leading load or platen, at which the run ends [m]
  std::string title;                        ///< of the report, the user's own words
};

[[nodiscard]] Source source_of(const Settings& settings);

/// Chooses what suits the kinematics where the user did not. For points that keep their place: a cell of one
/// pixel, which a crack can cross wherever it runs, and a local damping that keeps the waves of one failure
/// from causing the next. For points that move: 2 x 2 points a cell, no damping.
void follow_kinematics(Settings& settings);

/// Options of the packing with the grading that was chosen.   @throws specimen::Error.
[[nodiscard]] specimen::PackingOptions packing_options(const Settings& settings);

/// The phase of that name; an unknown one is added, with no stiffness and no mass yet.
mpm::Phase& phase_named(Settings& settings, std::string_view name);

}  // namespace app
