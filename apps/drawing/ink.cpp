#include "apps/drawing/ink.hpp"

#include <fmt/format.h>

namespace output {

using specimen::Rgb;

Rgb on_light_paper(Ink ink) {
  switch (ink) {
    case Ink::text:
      return {0x1c, 0x20, 0x24};
    case Ink::muted:
      return {0x5a, 0x62, 0x6a};
    case Ink::grid:
      return {0xe4, 0xe7, 0xea};
    case Ink::axis:
      return {0x8a, 0x92, 0x9a};
    case Ink::first:
      return {0x00, 0x60, 0xa8};
    case Ink::second:
      return {0xc8, 0x4b, 0x00};
    case Ink::third:
      return {0x00, 0x80, 0x60};
    case Ink::fourth:
      return {0xa8, 0x4a, 0x86};
    case Ink::fifth:
      return {0x7a, 0x6a, 0x2c};
  }
  return {};
}

Rgb on_dark_paper(Ink ink) {
  switch (ink) {
    case Ink::text:
      return {0xe6, 0xe8, 0xea};
    case Ink::muted:
      return {0xa0, 0xa8, 0xb0};
    case Ink::grid:
      return {0x2c, 0x32, 0x38};
    case Ink::axis:
      return {0x70, 0x78, 0x80};
    case Ink::first:
      return {0x5a, 0xb4, 0xf0};
    case Ink::second:
      return {0xf5, 0x95, 0x50};
    case Ink::third:
      return {0x2c, 0xc4, 0x9c};
    case Ink::fourth:
      return {0xe0, 0x94, 0xc4};
    case Ink::fifth:
      return {0xd8, 0xc4, 0x70};
  }
  return {};
}

std::string_view name_of(Ink ink) {
  switch (ink) {
    case Ink::text:
      return "text";
    case Ink::muted:
      return "muted";
    case Ink::grid:
      return "grid";
    case Ink::axis:
      return "axis";
    case Ink::first:
      return "first";
    case Ink::second:
      return "second";
    case Ink::third:
      return "third";
    case Ink::fourth:
      return "fourth";
    case Ink::fifth:
      return "fifth";
  }
  return {};
}

std::string hex(Rgb colour) { return fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b); }

}  // namespace output
