/// Members of a study that end early go on where they were.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "apps/run/checkpoint_folder.hpp"
#include "libmpm/run/simulate.hpp"

namespace app {

/// The checkpoints of one member: once a minute, and when the observer ends its run. They are a convenience:
/// one that cannot be written is left out, and one that cannot be gone on from (damaged, of another scene, of
/// an instruction set that the processor lacks) is passed over.
class MemberCheckpoints {
 public:
  /// @param folder  of the member alone.   @param scene_text  what its result depends on.
  MemberCheckpoints(std::filesystem::path folder, std::string scene_text)
      : path_(std::move(folder)), folder_(path_), scene_text_(std::move(scene_text)) {}

  /// From the last checkpoint, or from the start where there is none.   @throws what mpm::simulate() throws.
  [[nodiscard]] mpm::Result run(const mpm::Scene& scene, const mpm::Observer& observer);

  /// All of them, once the result is kept. What cannot be removed stays.
  void remove() const;

 private:
  void keep(const mpm::Checkpoint& checkpoint);

  std::filesystem::path path_;
  CheckpointFolder folder_;
  std::string scene_text_;
};

}  // namespace app
