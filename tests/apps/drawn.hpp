/// What is on a drawing.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "apps/drawing/drawing.hpp"

namespace test {

/// Its shapes of a kind.
template <class T>
std::vector<T> drawn(const output::Drawing& drawing) {
  std::vector<T> found;
  for (const output::Shape& shape : drawing.shapes)
    if (const T* item = std::get_if<T>(&shape)) found.push_back(*item);
  return found;
}

inline bool says(const output::Drawing& drawing, const std::string& text) {
  const std::vector<output::Words> words = drawn<output::Words>(drawing);
  return std::any_of(words.begin(), words.end(), [&](const output::Words& w) { return w.text == text; });
}

}  // namespace test
