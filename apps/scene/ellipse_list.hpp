/// Ellipses that the user gives one by one: a CSV file, or [[ellipses]] in the scene.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "apps/text/complaint.hpp"
#include "apps/text/quantity.hpp"
#include "specimen/body/ellipse.hpp"

namespace app {

/// A property of an ellipse in a list.
struct EllipseColumn {
  const char* name;
  Dimension dimension;
  double specimen::Ellipse::*member;
  bool required;
};

/// x, y: centre from the bottom left corner; a >= b: semi-axes; angle: of a against x, counter-clockwise.
inline constexpr std::array ellipse_columns{
    EllipseColumn{"x", Dimension::length, &specimen::Ellipse::x, true},
    EllipseColumn{"y", Dimension::length, &specimen::Ellipse::y, true},
    EllipseColumn{"a", Dimension::length, &specimen::Ellipse::a, true},
    EllipseColumn{"b", Dimension::length, &specimen::Ellipse::b, true},
    EllipseColumn{"angle", Dimension::angle, &specimen::Ellipse::angle, false},
};

/// @throws Mistake unless a >= b > 0.
void check_axes(const specimen::Ellipse& ellipse);

/// Read a list with commas between the columns and their units in the header:
/// "x_mm,y_mm,a_mm,b_mm,angle_deg". Empty lines and lines that begin with # are passed over. `angle` may be
/// missing: 0.
/// @throws Rejected with every mistake and its line.
[[nodiscard]] std::vector<specimen::Ellipse> read_ellipse_list(const std::string& path);

/// The same from text; `path` is for the messages.
[[nodiscard]] std::vector<specimen::Ellipse> parse_ellipse_list(const std::string& text,
                                                                const std::string& path);

}  // namespace app
