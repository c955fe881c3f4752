/// A drawing: lines, dots and words with their places. Renderers turn it into SVG or pixels.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "apps/drawing/colours.hpp"

namespace output {

/// Place on the drawing, x to the right, y DOWN [px of the drawing].
struct Place {
  double x = 0;
  double y = 0;
};

struct Stroke {
  std::vector<Place> places;
  Ink ink = Ink::text;
  double width = 1;
  bool dashed = false;
};

struct Dot {
  Place centre;
  double radius = 1;
  Ink ink = Ink::text;
};

enum class Anchor { start, middle, end };

struct Words {
  Place at;  ///< on the base line
  std::string text;
  double size = 13;
  Anchor anchor = Anchor::start;
  Ink ink = Ink::text;
};

/// A filled rectangle.
struct Block {
  Place corner;  ///< upper left
  double width = 0, height = 0;
  specimen::Rgb colour;
  bool outlined = false;  ///< with a thin line round it
};

/// A filled area within straight edges.
struct Area {
  std::vector<Place> corners;
  specimen::Rgb colour;
};

/// A picture whose pixels stay squares.
struct Pixels {
  Place corner;  ///< upper left
  double width = 0, height = 0;
  specimen::Raster<specimen::Rgb> picture;
};

using Shape = std::variant<Stroke, Dot, Words, Block, Area, Pixels>;

struct Drawing {
  double width = 0;
  double height = 0;
  std::string title;
  std::vector<Shape> shapes;  ///< later ones lie on top
  double text = 1;            ///< size of the words over the usual one
};

}  // namespace output
