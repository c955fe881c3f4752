/// The inks that charts are drawn in, on light and on dark paper.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "specimen/picture/picture.hpp"

namespace output {

/// What a line or a word is for; the colour follows from the paper.
enum class Ink { text, muted, grid, axis, first, second, third, fourth, fifth };

inline constexpr std::array all_inks{Ink::text,   Ink::muted, Ink::grid,   Ink::axis, Ink::first,
                                     Ink::second, Ink::third, Ink::fourth, Ink::fifth};

/// Colours from Okabe and Ito's list, which stays apart for colour-blind eyes, made darker or lighter until
/// lines have a contrast of at least 3:1 to the paper and words 4.5:1.
[[nodiscard]] specimen::Rgb on_light_paper(Ink ink);
[[nodiscard]] specimen::Rgb on_dark_paper(Ink ink);

/// Name in style sheets, e.g. "first".
[[nodiscard]] std::string_view name_of(Ink ink);

/// "#0072b2".
[[nodiscard]] std::string hex(specimen::Rgb colour);

}  // namespace output
