/// What files of meshes are written with: text too large to be held in memory, numbers, names of phases.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "specimen/body/files.hpp"

namespace exchange {

/// Collects text and hands it on in large pieces.
class TextStream {
 public:
  explicit TextStream(const specimen::ByteSink& sink) : sink_(sink) {}
  TextStream(const TextStream&) = delete;
  TextStream& operator=(const TextStream&) = delete;

  TextStream& operator<<(std::string_view text);
  TextStream& operator<<(std::int64_t number);
  /// Hand on what is left; to be called at the end.
  void flush();

 private:
  const specimen::ByteSink& sink_;
  std::string text_;
};

/// Put text on disk as `path`, wholly or not at all.   @throws specimen::Error (Fault::write).
void write_text(const std::string& path, const std::function<void(TextStream&)>& write);

/// A length [m] with 12 significant digits, within the 20 characters that a number may have in a mesh file.
[[nodiscard]] std::string length_text(double length);

/// Names of sets for Abaqus and CalculiX, which know no upper and lower case: capitals, digits and
/// underscores, a letter first, at most 80 characters; "fly ash 2" becomes FLY_ASH_2. No two are the same: a
/// name that is taken gets a number behind it.
[[nodiscard]] std::vector<std::string> set_names(const std::vector<std::string>& phases);

/// Names of physical groups for Gmsh, which stand between quotes on one line: only quotes and control
/// characters are replaced, by underscores. At most 120 bytes; no two are the same.
[[nodiscard]] std::vector<std::string> group_names(const std::vector<std::string>& phases);

}  // namespace exchange
