/// A checkpoint on disk.
///
/// Layout: all numbers are little-endian, integers have 64 bits; texts, lists and states begin with their
/// length:
///   8 bytes                  "MPXCKPT\n"
///   version                  of this layout: 1
///   precision, moving        0 single, 1 double; 0 small strain, 1 moving points
///   instruction set          text
///   specimen                 text of 32 bytes: specimen_digest()
///   step, fraction, time     whole number, [-], [s]
///   frames                   list of time [s] and number of points
///   scene, remarks           texts from the caller
///   state                    see archive.hpp; its layout depends on the version of the program
///   32 bytes                 SHA-256 of all bytes before
#pragma once

#include <string>

#include "libmpm/solver/checkpoint.hpp"

namespace mpm {

/// The contents of a checkpoint file.
struct CheckpointFile {
  Checkpoint checkpoint;
  std::string scene_text;  ///< the resolved scene
  std::string remarks;     ///< further text of the caller
};

/// Write a checkpoint to a temporary name, flush it, rename it, and flush the folder.   @throws FileError.
void write_checkpoint(const std::string& path, const Checkpoint& checkpoint, const std::string& scene_text,
                      const std::string& remarks);

/// Read a checkpoint. The digest is checked before anything else.
/// @throws FileError naming the file and the fault: it cannot be read, is not a checkpoint, is damaged, or
/// has another version.
[[nodiscard]] CheckpointFile read_checkpoint(const std::string& path);

}  // namespace mpm
