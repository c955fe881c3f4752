/// The exceptions of the solver.
#pragma once

#include <stdexcept>
#include <string>

namespace mpm {

/// A user's mistake: which field, the value met, what is allowed, and how to cure it.
/// what() reads "field: value; allowed; cure" with the empty parts left out.
struct Error : std::runtime_error {
  Error(std::string field_name, std::string value_met, std::string what_is_allowed,
        std::string how_to_cure = {});

  std::string field;    ///< path in the scene, e.g. "phases.mortar.young"
  std::string value;    ///< the value met, with its unit
  std::string allowed;  ///< what would have been accepted
  std::string cure;     ///< what to try
};

/// A file could not be written or read.
struct FileError : Error {
  using Error::Error;
};

}  // namespace mpm
