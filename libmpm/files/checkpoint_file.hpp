/// A checkpoint on disk.
///
/// Layout, all numbers little end first, whole ones of 64 bits; a text, a list or a state has its length in
/// front:
///   8 bytes                  "MPXCKPT\n"
///   version                  of this layout: 1
///   precision, moving        0 single, 1 double; 0 small strain, 1 moving points
///   instruction set          text
///   specimen                 text of 32 bytes: specimen_digest()
///   step, fraction, time     whole number, [-], [s]
///   frames                   list of time [s] and number of points
///   scene, remarks           texts of the caller
///   state                    see archive.hpp; its layout is that of the version of the program
///   32 bytes                 SHA-256 of all before
#pragma once

#include <string>

#include "libmpm/solver/checkpoint.hpp"

namespace mpm {

struct CheckpointFile {
  Checkpoint checkpoint;
  std::string scene_text;  ///< the resolved scene
  std::string remarks;     ///< what else the caller wants to find again
};

/// Write a checkpoint: to a temporary name, flushed and renamed, the folder flushed.   @throws FileError.
void write_checkpoint(const std::string& path, const Checkpoint& checkpoint, const std::string& scene_text,
                      const std::string& remarks);

/// Nothing in the file is looked at before its digest is found right.
/// @throws FileError naming the file and what is wrong: it cannot be read, is none, damaged or of another
/// version.
[[nodiscard]] CheckpointFile read_checkpoint(const std::string& path);

}  // namespace mpm
