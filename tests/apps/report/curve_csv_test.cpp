#include "apps/report/key_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "libmpm/scene/result.hpp"

namespace curve_csv_test {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

TEST(CurveCsv, NamesEveryColumnWithItsUnit) {
  EXPECT_EQ(output::curve_csv({}),
            "time_s,strain,stress_Pa,stress_top_Pa,stress_bottom_Pa,platen_work_J_per_m,kinetic_J_per_m,"
            "elastic_J_per_m,released_J_per_m,damped_J_per_m,left_J_per_m,tension_failures,shear_failures,"
            "left_points,moving_points\n");
}

TEST(CurveCsv, ReadsBackAsTheSameNumbers) {
  const std::vector<mpm::HistoryRow> history{
      {0.1, 1.0 / 3, -1e6 / 7, 5e-324, 1e300, 0, -0.0, 1e-17, 2.0 / 3, 1e22, std::int64_t{1} << 60, 3},
      {std::nan(""), 1, 2, 3, 4, 5, 6, 7, 8, 9, -1, 0}};
  const std::vector<std::string> lines = split(output::curve_csv(history), '\n');
  ASSERT_EQ(lines.size(), 3U);
  for (std::size_t i = 0; i < history.size(); ++i) {
    const std::vector<std::string> cells = split(lines[i + 1], ',');
    ASSERT_EQ(cells.size(), mpm::history_columns().size());
    for (std::size_t k = 0; k < cells.size(); ++k)
      std::visit(
          [&](auto member) {
            const auto expected = history[i].*member;
            if constexpr (std::is_same_v<decltype(expected), const std::int64_t>)
              EXPECT_EQ(std::strtoll(cells[k].c_str(), nullptr, 10), expected);
            else if (std::isnan(expected))
              EXPECT_EQ(cells[k], "nan");
            else
              EXPECT_EQ(std::strtod(cells[k].c_str(), nullptr), expected);
          },
          mpm::history_columns()[k].member);
  }
}

}  // namespace curve_csv_test
