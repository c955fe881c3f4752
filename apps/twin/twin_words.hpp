/// What is said of twins, for the terminal and the report.
#pragma once

#include <string>
#include <vector>

#include "apps/twin/twinning.hpp"

namespace app {

/// A figure of the original beside those of its twins, as text in the unit of its name.
struct FigureRow {
  std::string name;  ///< "Median diameter, by area (mm)"
  std::string original;
  std::string mean;       ///< of the twins
  std::string deviation;  ///< from twin to twin
  std::string range;      ///< "9.1 to 9.8"
  std::string difference;
};
[[nodiscard]] std::vector<FigureRow> figure_rows(const TwinTask& task, const specimen::Misfit& misfit);

/// How far a curve of the original is from the mean of the twins, beside a twin from the others.
struct CurveRow {
  std::string name;  ///< "S2, root mean square (%)"
  std::string original;
  std::string mean;     ///< of the twins
  std::string largest;  ///< of the twins
  std::string verdict;  ///< "within the twins"; empty where there is a single twin
};
[[nodiscard]] std::vector<CurveRow> curve_rows(const specimen::Misfit& misfit);

/// What was measured on what, and what to keep in mind; one sentence each.
[[nodiscard]] std::vector<std::string> twin_notes(const TwinTask& task, const std::vector<TwinRecord>& twins);

/// "10 twins of photo, 150 mm x 150 mm, pixels of 0.5 mm, seeds 1 to 10".
[[nodiscard]] std::string twins_text(const TwinTask& task, std::size_t count);

/// Both tables as lines for a terminal.
[[nodiscard]] std::vector<std::string> misfit_lines(const TwinTask& task, const specimen::Misfit& misfit);

}  // namespace app
