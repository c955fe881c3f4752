/// Several files, of which a disk that fails takes what it can.
#pragma once

#include <functional>
#include <vector>

#include "libmpm/scene/error.hpp"

/// Files that could not be written; all others were. As an error it reads like the first of them.
struct NotWritten : mpm::FileError {
  explicit NotWritten(std::vector<mpm::FileError> all);
  std::vector<mpm::FileError> files;  ///< one at least
};

/// Writes that are each tried, whatever became of those before: where a large file does not fit on a disk any
/// more, a small one may.
class Attempts {
 public:
  /// Calls `write` and keeps what it throws when the disk fails; its other exceptions pass.
  void operator()(const std::function<void()>& write);
  /// @throws NotWritten when any write failed.
  void conclude() const;

 private:
  std::vector<mpm::FileError> failures_;
};
