// Any file as a checkpoint, its digest put right: the run goes on from it, or it is refused. The first byte
// tells which scene it is said to be of.

#include "libmpm/files/checkpoint_file.hpp"
#include "libmpm/scene/error.hpp"
#include "libmpm/solver/checkpoint.hpp"
#include "tests/fuzz/checkpoint_samples.hpp"
#include "tests/fuzz/input_file.hpp"

namespace {

/// Else the reader would stop there, and nothing behind it were ever tried.
std::string sealed(const std::uint8_t* data, std::size_t size) {
  std::string bytes(reinterpret_cast<const char*>(data), size);
  bytes.resize(size < mpm::sha256_bytes ? 0 : size - mpm::sha256_bytes);
  return bytes + mpm::Sha256().add(bytes).digest();
}

/// A row further, where a run may be wrong but not the memory it works on.
void go_on(const mpm::Scene& scene, const mpm::Checkpoint& checkpoint) {
  mpm::RunHooks hooks;
  hooks.observer = [](const mpm::Progress&) { return false; };
  hooks.frames = [](const mpm::Frame&) {};
  hooks.checkpoints.sink = [](const mpm::Checkpoint&) {};
  try {
    (void)mpm::resume(scene, checkpoint, hooks);
  } catch (const mpm::Diverged&) {
    // as a run may
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file;
  static const std::vector<mpm::Scene> scenes = fuzz::checkpoint_scenes();
  if (size < 1) return 0;
  const std::string bytes = sealed(data + 1, size - 1);
  const mpm::Scene& scene = scenes[*data % scenes.size()];
  try {
    mpm::CheckpointFile read =
        mpm::read_checkpoint(file.hold(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
    read.checkpoint.specimen = mpm::specimen_digest(scene);
    read.checkpoint.instruction_set = scene.instruction_set;
    go_on(scene, read.checkpoint);
  } catch (const mpm::FileError&) {
    // refused, as it may be
  }
  return 0;
}
