/// How settings of each kind are read from values of a scene file and written back.
///
/// A codec has kind(), type() (as the help shows it), read(), which throws Mistake, and write(); what write()
/// gives, read() turns into the same setting.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/text/complaint.hpp"
#include "apps/text/quantity.hpp"
#include "apps/text/words.hpp"
#include "specimen/convert/convert.hpp"
#include "specimen/pack/grading.hpp"

namespace app {

enum class Kind { quantity, integer, boolean, choice, text, path, list };

/// Value of a text on the command line: lists are split at commas, numbers and booleans told by the kind.
[[nodiscard]] Value from_command_line(Kind kind, const std::string& text);

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

/// A word that stands for a special number, such as "auto" for 0.
struct Word {
  std::string word;
  double stands_for = 0;
};

struct Quantity {
  Dimension dimension = Dimension::ratio;
  Bounds bounds;
  std::optional<Word> word;

  [[nodiscard]] static Kind kind() { return Kind::quantity; }
  [[nodiscard]] std::string type() const;
  [[nodiscard]] double read(const Value& value) const;
  [[nodiscard]] Value write(double number) const;
};

/// A quantity that may be absent, which `word` says.
struct OptionalQuantity {
  Quantity quantity;
  std::string word;

  [[nodiscard]] static Kind kind() { return Kind::quantity; }
  [[nodiscard]] std::string type() const { return quantity.type() + "|" + word; }
  [[nodiscard]] std::optional<double> read(const Value& value) const;
  [[nodiscard]] Value write(const std::optional<double>& number) const;
};

/// A whole number, whatever the type it is kept in.
struct WholeNumber {
  Bounds bounds;
  std::optional<Word> word;

  [[nodiscard]] std::string type() const;
  [[nodiscard]] std::int64_t read(const Value& value) const;
  [[nodiscard]] Value write(std::int64_t number) const;
};

/// A whole number that is kept as T.
template <class T = int>
struct Integer {
  WholeNumber number;

  [[nodiscard]] static Kind kind() { return Kind::integer; }
  [[nodiscard]] std::string type() const { return number.type(); }
  [[nodiscard]] T read(const Value& value) const { return static_cast<T>(number.read(value)); }
  [[nodiscard]] Value write(T value) const { return number.write(static_cast<std::int64_t>(value)); }
};

struct Boolean {
  [[nodiscard]] static Kind kind() { return Kind::boolean; }
  [[nodiscard]] static std::string type() { return {}; }
  [[nodiscard]] bool read(const Value& value) const;
  [[nodiscard]] Value write(bool value) const { return {value}; }
};

/// One of a few words.
struct Name {
  std::vector<std::string> names;

  [[nodiscard]] static Kind kind() { return Kind::choice; }
  [[nodiscard]] std::string type() const;
  [[nodiscard]] std::string read(const Value& value) const;
  [[nodiscard]] Value write(const std::string& name) const { return {name}; }
};

/// One of a few words, each an enumerator.
template <class E>
struct Choice {
  std::vector<std::pair<std::string, E>> choices;

  [[nodiscard]] static Kind kind() { return Kind::choice; }
  [[nodiscard]] std::string type() const { return name().type(); }
  [[nodiscard]] E read(const Value& value) const {
    const std::string word = name().read(value);
    for (const auto& [choice, enumerator] : choices)
      if (choice == word) return enumerator;
    throw Mistake("must be one of the choices");  // not reached: name() has accepted the word
  }
  // cppcheck-suppress passedByValue ; an enumeration
  [[nodiscard]] Value write(E wanted) const {
    for (const auto& [choice, enumerator] : choices)
      if (enumerator == wanted) return {choice};
    throw Mistake("not among the choices of the schema");
  }
  [[nodiscard]] Name name() const {
    Name result;
    for (const auto& [choice, enumerator] : choices) result.names.push_back(choice);
    return result;
  }
};

struct Text {
  [[nodiscard]] static Kind kind() { return Kind::text; }
  [[nodiscard]] static std::string type() { return "TEXT"; }
  [[nodiscard]] std::string read(const Value& value) const;
  [[nodiscard]] Value write(const std::string& text) const { return {text}; }
};

/// A file name; in a scene file relative to the folder of the scene.
struct Path : Text {
  [[nodiscard]] static Kind kind() { return Kind::path; }
  [[nodiscard]] static std::string type() { return "FILE"; }
};

struct Numbers {
  [[nodiscard]] static Kind kind() { return Kind::list; }
  [[nodiscard]] static std::string type() { return "NUMBER,..."; }
  [[nodiscard]] std::vector<double> read(const Value& value) const;
  [[nodiscard]] Value write(const std::vector<double>& numbers) const;
};

struct Texts {
  [[nodiscard]] static Kind kind() { return Kind::list; }
  [[nodiscard]] static std::string type() { return "NAME,..."; }
  [[nodiscard]] std::vector<std::string> read(const Value& value) const;
  [[nodiscard]] Value write(const std::vector<std::string>& texts) const;
};

/// [x, y, width, height]; an empty list is the whole picture.
struct Rectangle {
  static constexpr int most = 1'000'000;  ///< [pixels]
  [[nodiscard]] static Kind kind() { return Kind::list; }
  [[nodiscard]] static std::string type() { return "X,Y,WIDTH,HEIGHT"; }
  [[nodiscard]] specimen::Crop read(const Value& value) const;
  [[nodiscard]] Value write(const specimen::Crop& crop) const;
};

/// ["0: void", "1: mortar"].
struct LabelNames {
  using Names = std::vector<std::pair<std::int64_t, std::string>>;
  [[nodiscard]] static Kind kind() { return Kind::list; }
  [[nodiscard]] static std::string type() { return "LABEL:NAME,..."; }
  [[nodiscard]] Names read(const Value& value) const;
  [[nodiscard]] Value write(const Names& names) const;
};

/// ["5 mm .. 10 mm: 40 %", "10 mm .. 20 mm: 60 %"].
struct SizeClasses {
  [[nodiscard]] static Kind kind() { return Kind::list; }
  [[nodiscard]] static std::string type() { return "LENGTH..LENGTH:SHARE,..."; }
  [[nodiscard]] specimen::Grading read(const Value& value) const;
  [[nodiscard]] Value write(const specimen::Grading& classes) const;
};

}  // namespace app
