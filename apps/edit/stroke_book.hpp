/// Strokes as they grow on the page, kept in a file at every step.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "specimen/convert/convert.hpp"
#include "specimen/convert/strokes.hpp"

namespace app {

/// Strokes with undo and redo. A change is on the disk before it holds: a program that is killed leaves the
/// strokes before it or after it, never a part.
class StrokeBook {
 public:
  /// @param file  CSV that takes the strokes; it is removed where none are left.
  /// @param rows, cols  of the picture.
  StrokeBook(std::string file, const std::vector<specimen::StrokeLine>& lines, int rows, int cols);

  [[nodiscard]] std::vector<specimen::StrokeLine> lines() const;
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] std::int64_t version() const { return version_; }  ///< grows with every change
  [[nodiscard]] bool can_undo() const { return !before_.empty(); }
  [[nodiscard]] bool can_redo() const { return !after_.empty(); }

  /// @throws Rejected (Exit::data) for a stroke that is no stroke on this picture, and when there are too
  /// many; specimen::Error when the disk fails. Nothing has changed then, which holds for all that follows.
  void add(const specimen::StrokeLine& line);
  /// @param numbers  of strokes, from 0.   @throws Rejected for a number that no stroke has.
  void remove(const std::vector<std::size_t>& numbers);
  void undo();
  void redo();
  /// Write the strokes to their file, which a new book has not done yet.
  void keep() const;

 private:
  using Pages = std::vector<std::shared_ptr<const specimen::StrokeLine>>;
  void keep(const Pages& pages) const;
  void turn_to(Pages pages);
  void step(std::vector<Pages>& from, std::vector<Pages>& to);

  std::string file_;
  int rows_, cols_;
  Pages pages_;
  std::vector<Pages> before_, after_;
  std::int64_t version_ = 1;
};

/// Painted strokes as lines that cover the same pixels: one of width 1 for each run in a row.
[[nodiscard]] std::vector<specimen::StrokeLine> lines_of(const specimen::Strokes& painted);

}  // namespace app
