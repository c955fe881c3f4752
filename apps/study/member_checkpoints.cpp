#include "apps/study/member_checkpoints.hpp"

#include <system_error>

#include "libmpm/scene/error.hpp"

namespace app {
namespace {

constexpr double interval = 60;  // [s]

}  // namespace

mpm::Result MemberCheckpoints::run(const mpm::Scene& scene, const mpm::Observer& observer) {
  mpm::RunHooks hooks;
  hooks.observer = observer;
  hooks.checkpoints = {[this](const mpm::Checkpoint& checkpoint) { keep(checkpoint); }, interval};
  const CheckpointFolder::Found found = folder_.last();
  if (found.last && found.last->file.scene_text == scene_text_) try {
      return mpm::resume(scene, found.last->file.checkpoint, hooks);
    } catch (const mpm::FileError&) {  // no checkpoint for this machine; those of the hooks throw nothing
    }
  remove();  // of another run, behind which those of this one would count as old
  return mpm::simulate(scene, hooks);
}

void MemberCheckpoints::keep(const mpm::Checkpoint& checkpoint) {
  try {
    folder_.write(checkpoint, scene_text_, "");
  } catch (const mpm::FileError&) {  // the one before stays
  }
}

void MemberCheckpoints::remove() const {
  std::error_code ignored;
  try {
    folder_.remove();
  } catch (const mpm::FileError&) {
    return;
  }
  std::filesystem::remove(path_, ignored);  // once it is empty
}

}  // namespace app
