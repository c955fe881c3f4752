/// The scenes of data/paper, which the program carries in itself.
/// One run of a figure: a scene of the paper, and the settings in which this run differs from it.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "apps/settings/settings.hpp"
#include "libmpm/scene/result.hpp"
#include "specimen/body/specimen.hpp"

namespace app::reproduce {

struct PaperScene {
  std::string name;  ///< "tension"
  std::string text;  ///< TOML
};

/// In alphabetical order.
[[nodiscard]] const std::vector<PaperScene>& paper_scenes();

/// @pre there is one of that name.
[[nodiscard]] const PaperScene& paper_scene(const std::string& name);

/// "data/paper/tension.toml": where the file lies in the sources.
[[nodiscard]] std::string path_of_scene(const std::string& name);

/// Key and value as on the command line, e.g. {"phases.mortar.tensile_scale", "8 MPa"}.
using Setting = std::pair<std::string, std::string>;

struct Trial {
  std::string scene;              ///< name of a scene of data/paper
  std::vector<Setting> settings;  ///< a later one of the same key wins
  bool keep_maps = false;         ///< the figure looks at where the points failed
};

/// Names the run: two trials of one name give the same result.
[[nodiscard]] std::string name_of(const Trial& trial);

/// "mesopix simulate data/paper/tension.toml --set damage.seed=2": the run alone.
[[nodiscard]] std::string command_of(const Trial& trial);

/// @throws Rejected for a setting that the schema refuses.
[[nodiscard]] Settings settings_of(const Trial& trial);

struct TrialResult {
  bool done = false;            ///< false: it was interrupted, or never begun
  mpm::Result result;           ///< its maps are empty unless they are kept
  specimen::Specimen specimen;  ///< empty unless the maps are kept
};

/// Break the specimen of a trial on one thread.
/// @param go_on  the run is given up once it says no.   @throws Rejected, naming the trial, when the physics
/// went wrong; the exceptions of the libraries.
[[nodiscard]] TrialResult run_trial(const Trial& trial, const std::function<bool()>& go_on);

/// What the trials ended with, in the order in which they were first asked for.
class TrialResults {
 public:
  struct Entry {
    Trial trial;
    TrialResult outcome;
  };

  /// Makes room for a trial; asks for its maps too where one of the trials of this name does.
  void expect(const Trial& trial);

  /// @pre the trial is expected.
  [[nodiscard]] const TrialResult& of(const Trial& trial) const {
    return entries_[index_.at(name_of(trial))].outcome;
  }
  [[nodiscard]] TrialResult& of(const Trial& trial) { return entries_[index_.at(name_of(trial))].outcome; }
  [[nodiscard]] bool has(const Trial& trial) const;  ///< it was run to its end

  [[nodiscard]] std::vector<Entry>& entries() { return entries_; }
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::vector<Entry> entries_;
  std::map<std::string, std::size_t> index_;  ///< by name
};

}  // namespace app::reproduce
