/// What a value of a setting, an option or an argument may be, as data: for help, manual pages and
/// completions, comments in scenes and their JSON Schema.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "apps/text/quantity.hpp"

namespace app {

enum class Kind { quantity, integer, boolean, choice, text, path, folder, list };

/// An interval of allowed numbers, in SI units.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;

  [[nodiscard]] bool contains(double value) const {
    return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
  }
  /// "> 0", "in [0, 1)"; empty where every number is allowed.
  [[nodiscard]] std::string range(Dimension dimension) const;
  /// "must be > 0", "must lie in [0, 1)".
  [[nodiscard]] std::string text(Dimension dimension) const;
};

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr Bounds above(double low) { return {low, unlimited, true, true}; }
constexpr Bounds at_least(double low) { return {low, unlimited, false, true}; }
constexpr Bounds between(double low, double high) { return {low, high, false, false}; }
/// [low, high)
constexpr Bounds below(double low, double high) { return {low, high, false, true}; }
/// (low, high]
constexpr Bounds up_to(double low, double high) { return {low, high, true, false}; }
/// (low, high)
constexpr Bounds inside(double low, double high) { return {low, high, true, true}; }

/// What a number measures, and how large it may be.
struct Measure {
  Dimension dimension = Dimension::ratio;
  Bounds bounds = {};
};

/// Items of a list.
struct Items {
  std::optional<Bounds> whole = {};  ///< they are whole numbers
  std::string pattern = {};          ///< they are texts that this regular expression describes
  int number = 0;                    ///< the list has none of them or so many; 0 = any number
};

/// Of a kind of its own, or one of the words.
struct Form {
  Kind kind = Kind::text;
  std::string name = {};  ///< what the help calls it: "LENGTH", "FILE"; empty of a choice and of a switch
  std::vector<std::string> words = {};  ///< all that a choice has; of others what may stand in place of them
  std::optional<Measure> measure = {};  ///< of a quantity
  std::optional<Bounds> whole = {};     ///< of a whole number
  std::optional<Items> items = {};      ///< of a list; without a pattern and whole numbers they are numbers
  std::vector<std::string> endings = {};  ///< of a file: "h5"; none = any
  std::vector<std::string> hints = {};    ///< what may be typed too, of which the help shows nothing
};

/// As the help shows it: "VELOCITY", "smooth|rough", "LENGTH|auto"; empty of a switch.
[[nodiscard]] std::string type(const Form& form);

/// What is allowed, in a few words: "length > 0, or auto", "tension, compression or none".
[[nodiscard]] std::string text(const Form& form);

/// Of what is no setting.   @param name  as type() has it.
[[nodiscard]] Form one_of(std::vector<std::string> words);
[[nodiscard]] Form text_form(std::string name, std::vector<std::string> words = {});
[[nodiscard]] Form file_form(std::vector<std::string> endings = {}, std::string name = "FILE");
[[nodiscard]] Form folder_form();

/// Endings of pictures that can be read, and of others.
[[nodiscard]] std::vector<std::string> picture_endings(std::vector<std::string> others = {});

}  // namespace app
