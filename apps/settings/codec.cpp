#include "apps/settings/codec.hpp"

#include <algorithm>
#include <cmath>

#include "apps/text/text_parts.hpp"

namespace app {
namespace {

/// Items of a list may be numbers or texts; only a text that is a number throughout counts as one.
Value list_item(const std::string& text) {
  if (const auto number = whole_number(text)) return {*number};
  const bool decimal = !text.empty() && text.find_first_not_of("+-.0123456789eE") == std::string::npos;
  if (!decimal) return {text};
  try {
    return {parse_quantity(text, Dimension::ratio)};
  } catch (const Mistake&) {
    return {text};
  }
}

Value list_from_command_line(const std::string& text) {
  Value::List items;
  if (trimmed(text).empty()) return {items};
  for (const std::string& item : items_between(text, ',')) items.push_back(list_item(item));
  return {items};
}

const std::string* as_text(const Value& value) { return std::get_if<std::string>(&value.data); }

bool is_word(const Value& value, const std::optional<Word>& word) {
  const std::string* text = as_text(value);
  return word && text != nullptr && *text == word->word;
}

std::string or_word(const std::string& allowed, const std::optional<Word>& word) {
  return word ? allowed + ", or " + quoted(word->word) : allowed;
}

/// A number without a unit, with or without a text round it.
double read_ratio(const Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&value.data)) {
    if (!std::isfinite(*number)) throw Mistake("must be a finite number");
    return *number;
  }
  if (const std::string* text = as_text(value)) return parse_quantity(*text, Dimension::ratio);
  throw NoQuantity(Dimension::ratio);
}

double read_dimensional(const Value& value, Dimension dimension) {
  if (const std::string* text = as_text(value)) return parse_quantity(*text, dimension);
  if (const auto* number = std::get_if<double>(&value.data); number != nullptr && !std::isfinite(*number))
    throw Mistake("must be a finite number");
  if (std::holds_alternative<double>(value.data) || std::holds_alternative<std::int64_t>(value.data))
    throw Mistake("needs a unit", "write e.g. " + quoted(example(dimension)));
  throw NoQuantity(dimension);
}

std::vector<std::string> word_of(const std::optional<Word>& word) {
  return word ? std::vector{word->word} : std::vector<std::string>();
}

}  // namespace

Value from_command_line(Kind kind, const std::string& text) {
  if (kind == Kind::list) return list_from_command_line(text);
  if (kind == Kind::boolean && (text == "true" || text == "false")) return {text == "true"};
  if (kind == Kind::integer)
    if (const auto number = whole_number(text)) return {*number};
  return {text};
}

Form QuantityCodec::form() const {
  return {.kind = Kind::quantity,
          .name = upper(name(dimension)),
          .words = word_of(word),
          .measure = Measure{dimension, bounds}};
}

double QuantityCodec::read(const Value& value) const {
  if (is_word(value, word)) return word->stands_for;
  double number = 0;
  try {
    number = dimension == Dimension::ratio ? read_ratio(value) : read_dimensional(value, dimension);
  } catch (const NoQuantity& mistake) {
    throw Mistake(or_word(mistake.allowed, word), mistake.cure);
  }
  if (!bounds.contains(number)) throw Mistake(or_word(bounds.text(dimension), word));
  return number;
}

Value QuantityCodec::write(double number) const {
  if (word && number == word->stands_for) return {word->word};
  if (dimension == Dimension::ratio) return {number};
  return {format_quantity(number, dimension)};
}

Form OptionalQuantityCodec::form() const {
  Form form = quantity.form();
  form.words.push_back(word);
  return form;
}

std::optional<double> OptionalQuantityCodec::read(const Value& value) const {
  if (is_word(value, Word{word})) return std::nullopt;
  try {
    return quantity.read(value);
  } catch (const Mistake& mistake) {
    throw Mistake(or_word(mistake.allowed, Word{word}), mistake.cure);
  }
}

Value OptionalQuantityCodec::write(const std::optional<double>& number) const {
  return number ? quantity.write(*number) : Value{word};
}

Form WholeNumberCodec::form() const {
  return {.kind = Kind::integer, .name = "N", .words = word_of(word), .whole = bounds};
}

std::int64_t WholeNumberCodec::read(const Value& value) const {
  if (is_word(value, word)) return static_cast<std::int64_t>(word->stands_for);
  const auto* number = std::get_if<std::int64_t>(&value.data);
  if (number == nullptr) throw Mistake(or_word("must be a whole number", word));
  if (!bounds.contains(static_cast<double>(*number)))
    throw Mistake(or_word(bounds.text(Dimension::ratio), word));
  return *number;
}

Value WholeNumberCodec::write(std::int64_t number) const {
  if (word && number == static_cast<std::int64_t>(word->stands_for)) return {word->word};
  return {number};
}

bool BooleanCodec::read(const Value& value) const {
  const auto* boolean = std::get_if<bool>(&value.data);
  if (boolean == nullptr) throw Mistake("must be true or false");
  return *boolean;
}

std::string WordCodec::read(const Value& value) const {
  const std::string* text = as_text(value);
  const std::string allowed = "must be " + listed(words);
  if (text == nullptr) throw Mistake(allowed);
  if (std::find(words.begin(), words.end(), *text) == words.end())
    throw Mistake(allowed, did_you_mean(*text, words));
  return *text;
}

std::string TextCodec::read(const Value& value) const {
  const std::string* text = as_text(value);
  if (text == nullptr) throw Mistake("must be a text in quotes");
  if (!is_utf8(*text)) throw Mistake("must be text in UTF-8");
  return *text;
}

}  // namespace app
