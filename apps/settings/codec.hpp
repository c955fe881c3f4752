/// How settings of each kind are read from values of a scene file and written back.
///
/// A codec has form(), read(), which throws Mistake, and write(); what write() gives, read() turns into the
/// same setting.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/settings/form.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/quantity.hpp"
#include "apps/text/words.hpp"
#include "specimen/convert/convert.hpp"
#include "specimen/pack/grading.hpp"

namespace app {

/// Value of a text on the command line: lists are split at commas, numbers and booleans told by the kind.
[[nodiscard]] Value from_command_line(Kind kind, const std::string& text);

/// A word that stands for a special number, such as "auto" for 0.
struct Word {
  std::string word;
  double stands_for = 0;
};

struct QuantityCodec {
  Dimension dimension = Dimension::ratio;
  Bounds bounds = {};
  std::optional<Word> word = {};

  [[nodiscard]] Form form() const;
  [[nodiscard]] double read(const Value& value) const;
  [[nodiscard]] Value write(double number) const;
};

/// A quantity that may be absent, which `word` says.
struct OptionalQuantityCodec {
  QuantityCodec quantity;
  std::string word;

  [[nodiscard]] Form form() const;
  [[nodiscard]] std::optional<double> read(const Value& value) const;
  [[nodiscard]] Value write(const std::optional<double>& number) const;
};

/// A whole number, whatever the type it is kept in.
struct WholeNumberCodec {
  Bounds bounds = {};
  std::optional<Word> word = {};

  [[nodiscard]] Form form() const;
  [[nodiscard]] std::int64_t read(const Value& value) const;
  [[nodiscard]] Value write(std::int64_t number) const;
};

/// A whole number that is kept as T.
template <class T = int>
struct IntegerCodec : WholeNumberCodec {
  [[nodiscard]] T read(const Value& value) const { return static_cast<T>(WholeNumberCodec::read(value)); }
  [[nodiscard]] Value write(T value) const {
    return WholeNumberCodec::write(static_cast<std::int64_t>(value));
  }
};

struct BooleanCodec {
  [[nodiscard]] static Form form() { return {.kind = Kind::boolean}; }
  [[nodiscard]] bool read(const Value& value) const;
  [[nodiscard]] Value write(bool value) const { return {value}; }
};

/// One of a few words.
struct WordCodec {
  std::vector<std::string> words;

  [[nodiscard]] Form form() const { return one_of(words); }
  [[nodiscard]] std::string read(const Value& value) const;
  [[nodiscard]] Value write(const std::string& word) const { return {word}; }
};

/// One of a few words, each an enumerator.
template <class E>
struct ChoiceCodec {
  std::vector<std::pair<std::string, E>> choices;

  [[nodiscard]] Form form() const { return words().form(); }
  [[nodiscard]] E read(const Value& value) const {
    const std::string word = words().read(value);
    for (const auto& [choice, enumerator] : choices)
      if (choice == word) return enumerator;
    throw Mistake("must be one of the choices");  // not reached: words() has accepted the word
  }
  // cppcheck-suppress passedByValue ; an enumeration
  [[nodiscard]] Value write(E wanted) const {
    for (const auto& [choice, enumerator] : choices)
      if (enumerator == wanted) return {choice};
    throw Mistake("not among the choices of the schema");
  }
  [[nodiscard]] WordCodec words() const {
    WordCodec codec;
    for (const auto& [choice, enumerator] : choices) codec.words.push_back(choice);
    return codec;
  }
};

struct TextCodec {
  [[nodiscard]] static Form form() { return text_form("TEXT"); }
  [[nodiscard]] std::string read(const Value& value) const;
  [[nodiscard]] Value write(const std::string& text) const { return {text}; }
};

/// A file name; in a scene file relative to the folder of the scene.
struct PathCodec {
  std::vector<std::string> endings;

  [[nodiscard]] Form form() const { return file_form(endings); }
  [[nodiscard]] std::string read(const Value& value) const { return TextCodec().read(value); }
  [[nodiscard]] Value write(const std::string& path) const { return {path}; }
};

struct NumbersCodec {
  [[nodiscard]] static Form form();
  [[nodiscard]] std::vector<double> read(const Value& value) const;
  [[nodiscard]] Value write(const std::vector<double>& numbers) const;
};

struct TextsCodec {
  [[nodiscard]] static Form form();
  [[nodiscard]] std::vector<std::string> read(const Value& value) const;
  [[nodiscard]] Value write(const std::vector<std::string>& texts) const;
};

/// [x, y, width, height]; an empty list is the whole picture.
struct RectangleCodec {
  [[nodiscard]] static Form form();
  [[nodiscard]] specimen::Crop read(const Value& value) const;
  [[nodiscard]] Value write(const specimen::Crop& crop) const;
};

/// Lengths, as ["98 mm", "0 mm"]: so many of them, or none.
struct LengthsCodec {
  int number = 0;
  std::string name;     ///< "X,Y"
  std::string allowed;  ///< "must be x and y, e.g. ..."

  [[nodiscard]] Form form() const;
  [[nodiscard]] std::vector<double> read(const Value& value) const;
  [[nodiscard]] Value write(const std::vector<double>& lengths) const;
};

/// ["0: void", "1: mortar"].
struct LabelNamesCodec {
  using Names = std::vector<std::pair<std::int64_t, std::string>>;
  [[nodiscard]] static Form form();
  [[nodiscard]] Names read(const Value& value) const;
  [[nodiscard]] Value write(const Names& names) const;
};

/// ["5 mm .. 10 mm: 40 %", "10 mm .. 20 mm: 60 %"].
struct SizeClassesCodec {
  [[nodiscard]] static Form form();
  [[nodiscard]] specimen::Grading read(const Value& value) const;
  [[nodiscard]] Value write(const specimen::Grading& classes) const;
};

}  // namespace app
