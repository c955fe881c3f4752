/// Pictures in another size, by whole factors only, and what stands below those of a specimen.
#pragma once

#include <string>
#include <vector>

#include "apps/drawing/drawing.hpp"
#include "specimen/picture/picture.hpp"

namespace output {

/// Every pixel becomes factor x factor pixels.   @pre factor >= 1.
[[nodiscard]] specimen::Raster<specimen::Rgb> magnified(const specimen::Raster<specimen::Rgb>& picture,
                                                        int factor);

/// Every factor x factor pixels (fewer at the right and bottom edge) become their mean.   @pre factor >= 1.
[[nodiscard]] specimen::Raster<specimen::Rgb> shrunk(const specimen::Raster<specimen::Rgb>& picture,
                                                     int factor);

/// Smallest whole factor that brings a picture to at least 600 pixels in width without bringing its height
/// above 4000; 1 where it has them.
[[nodiscard]] int file_magnification(int rows, int cols);

/// Smallest whole factor that brings both sides to at most `most` pixels.
[[nodiscard]] int shrink_factor(int rows, int cols, int most);

inline constexpr double picture_width = 480;  ///< of a specimen on a drawing [px]
inline constexpr double text_line = 22;       ///< from line to line of words of the usual size [px]

/// Whole factor that gives a picture so many pixels that viewers which smooth pictures leave sharp edges; for
/// the sake of memory no more than 8000 rows of them, unless it has more itself.
[[nodiscard]] int crisp_factor(int rows, int cols);

/// The picture over the whole width, framed.
/// @return its height on the drawing [px].
double add_picture(Drawing& drawing, specimen::Raster<specimen::Rgb> picture);

/// A bar of a round length with what it is, and a line of words at the other end, or below where both do not
/// fit beside each other.
/// @param px_per_metre  of the specimen.   @param y  of the bar.   @return y of the last line.
double add_scale_bar(Drawing& drawing, double px_per_metre, double y, const std::string& words);

/// Words from the left edge on, in as many lines as they need, the first of them at y.
/// @param size  [px].   @return y of the last line.
double add_words(Drawing& drawing, const std::string& words, double y, double size, Ink ink = Ink::text);

/// A colour of the picture and what it is.
struct LegendEntry {
  specimen::Rgb colour;
  std::string name;
};

/// In as many lines as they need, the first of them at y.
/// @return y of the last line.
double add_legend(Drawing& drawing, const std::vector<LegendEntry>& entries, double y);

}  // namespace output
