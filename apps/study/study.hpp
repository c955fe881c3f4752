/// A study: one scene, run again and again with other values and other random numbers, as plain data.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "apps/scene/scene_file.hpp"
#include "apps/settings/schema.hpp"

namespace app {

/// How the points of a study fill the space of its parameters.
enum class Sampling {
  grid,             ///< every level of a parameter with every level of all others
  latin_hypercube,  ///< McKay, Beckman, Conover (1979): each of N strata of a parameter holds one of N points
  sobol,  ///< Sobol's sequence with the direction numbers of Joe and Kuo (2008); its point 0 is left out
};

/// What varies: one key of the scene, or several that share a value ("generate.width + generate.height").
struct StudyParameter {
  std::string name;           ///< as the study file writes it
  std::vector<Field> fields;  ///< settings that take the value, at least one
  std::vector<Value> levels;  ///< of a list or of equal steps; empty: between low and high
  double low = 0;             ///< of a range [SI]
  double high = 0;            ///< of a range [SI]
  Place place;                ///< of its values in the study file
  std::string folder;         ///< that its values are relative to where they are paths

  [[nodiscard]] bool is_range() const { return levels.empty(); }
};

/// As its file says it.
struct StudyPlan {
  std::string title;
  std::string scene;  ///< path of the scene that every member begins with
  Sampling sampling = Sampling::grid;
  int samples = 0;                   ///< points of a Latin hypercube or of Sobol's sequence; 0 = not given
  std::uint64_t sampling_seed = 1;   ///< of a Latin hypercube
  std::vector<std::uint64_t> seeds;  ///< every point is run with each; empty = with those of the scene
  Place seed_of_place;               ///< in the study file, where it is given
  std::vector<std::string> seed_of;  ///< tables whose key `seed` takes them: "generate", "damage"
  std::vector<StudyParameter> parameters;  ///< in the order of the file
};

/// A text, and the path of the file that it stands in.
struct TextFile {
  std::string text;
  std::string path;
};

/// A plan with its scene.
struct Study {
  StudyPlan plan;
  Resolved base;   ///< settings of the scene
  TextFile file;   ///< that says the plan
  TextFile scene;  ///< that says the base
};

}  // namespace app
