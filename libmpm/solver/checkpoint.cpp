#include "libmpm/solver/checkpoint.hpp"

#include "libmpm/solver/archive.hpp"
#include "libmpm/solver/sha256.hpp"

namespace mpm {

std::string specimen_digest(const Scene& scene) {
  ArchiveWriter archive;
  archive.finite(scene.pixel_size);
  archive.whole(scene.labels.rows(), 0, 0);
  archive.block(scene.labels);
  for (const ExtraPoint& point : scene.extra_points) {
    archive.finite(point.x);
    archive.finite(point.y);
    archive.whole(point.phase, 0, 0);
  }
  return Sha256().add(archive.take()).digest();
}

}  // namespace mpm
