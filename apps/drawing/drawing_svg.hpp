/// A drawing as inline SVG.
#pragma once

#include <string>

#include "apps/drawing/drawing.hpp"

namespace output {

/// SVG element that scales with its column. Colours come from the classes "stroke-NAME" and "fill-NAME" of
/// the page's style sheet (NAME = name_of(ink)), so that they follow light and dark paper.
[[nodiscard]] std::string svg_of(const Drawing& drawing);

}  // namespace output
