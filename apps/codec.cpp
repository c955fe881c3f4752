#include "apps/codec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace app {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::optional<std::int64_t> whole_number(const std::string& text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Items between commas, without the blanks round them.
std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> items;
  std::size_t from = 0;
  while (from <= text.size()) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    items.push_back(trimmed(text.substr(from, comma - from)));
    from = comma + 1;
  }
  if (items.size() == 1 && items.front().empty()) items.clear();
  return items;
}

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
  for (const std::string& item : split(text)) items.push_back(list_item(item));
  return {items};
}

const std::string* as_text(const Value& value) { return std::get_if<std::string>(&value.data); }

const Value::List& as_list(const Value& value, const std::string& allowed) {
  const auto* list = std::get_if<Value::List>(&value.data);
  if (list == nullptr) throw Mistake(allowed);
  return *list;
}

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
  throw Mistake(must_be(Dimension::ratio));
}

double read_dimensional(const Value& value, Dimension dimension) {
  if (const std::string* text = as_text(value)) return parse_quantity(*text, dimension);
  if (const auto* number = std::get_if<double>(&value.data); number != nullptr && !std::isfinite(*number))
    throw Mistake("must be a finite number");
  if (std::holds_alternative<double>(value.data) || std::holds_alternative<std::int64_t>(value.data))
    throw Mistake("needs a unit", "write e.g. " + quoted(example(dimension)));
  throw Mistake(must_be(dimension));
}

/// The two sides of a separator.   @throws Mistake where it does not occur.
std::pair<std::string, std::string> cut_at(const std::string& text, const std::string& separator,
                                           const std::string& allowed) {
  const std::size_t at = text.find(separator);
  if (at == std::string::npos) throw Mistake(quoted(text) + " does not fit", allowed);
  return {trimmed(text.substr(0, at)), trimmed(text.substr(at + separator.size()))};
}

constexpr const char* size_class_form = "write each class as \"5 mm .. 10 mm: 40 %\"";
constexpr const char* label_name_form = "write each label as \"1: mortar\"";

specimen::SizeClass read_size_class(const std::string& text) {
  const auto [range, share] = cut_at(text, ":", size_class_form);
  const auto [from, to] = cut_at(range, "..", size_class_form);
  const specimen::SizeClass result{parse_quantity(from, Dimension::length),
                                   parse_quantity(to, Dimension::length),
                                   parse_quantity(share, Dimension::ratio)};
  if (!(result.d_min > 0 && result.d_min < result.d_max))
    throw Mistake(quoted(range) + " is no range", "write the smaller diameter first, both > 0");
  if (!(result.share > 0 && result.share <= 1)) throw Mistake("a share must lie in (0, 1]");
  return result;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

}  // namespace

Value from_command_line(Kind kind, const std::string& text) {
  if (kind == Kind::list) return list_from_command_line(text);
  if (kind == Kind::boolean && (text == "true" || text == "false")) return {text == "true"};
  if (kind == Kind::integer)
    if (const auto number = whole_number(text)) return {*number};
  return {text};
}

std::string Bounds::text(Dimension dimension) const {
  const auto shown = [dimension](double limit) {
    return limit == 0 ? std::string("0") : format_quantity(limit, dimension);
  };
  if (std::isinf(low)) return std::string("must be ") + (high_open ? "< " : "<= ") + shown(high);
  if (std::isinf(high)) return std::string("must be ") + (low_open ? "> " : ">= ") + shown(low);
  return fmt::format("must lie in {}{}, {}{}", low_open ? '(' : '[', shown(low), shown(high),
                     high_open ? ')' : ']');
}

std::string Quantity::type() const { return upper(name(dimension)) + (word ? "|" + word->word : ""); }

double Quantity::read(const Value& value) const {
  if (is_word(value, word)) return word->stands_for;
  double number = 0;
  try {
    number = dimension == Dimension::ratio ? read_ratio(value) : read_dimensional(value, dimension);
  } catch (const Mistake& mistake) {
    const bool told = mistake.allowed == must_be(dimension);
    throw Mistake(told ? or_word(mistake.allowed, word) : mistake.allowed, mistake.cure);
  }
  if (!bounds.contains(number)) throw Mistake(or_word(bounds.text(dimension), word));
  return number;
}

Value Quantity::write(double number) const {
  if (word && number == word->stands_for) return {word->word};
  if (dimension == Dimension::ratio) return {number};
  return {format_quantity(number, dimension)};
}

std::optional<double> OptionalQuantity::read(const Value& value) const {
  if (is_word(value, Word{word})) return std::nullopt;
  try {
    return quantity.read(value);
  } catch (const Mistake& mistake) {
    throw Mistake(or_word(mistake.allowed, Word{word}), mistake.cure);
  }
}

Value OptionalQuantity::write(const std::optional<double>& number) const {
  return number ? quantity.write(*number) : Value{word};
}

std::string WholeNumber::type() const { return std::string("N") + (word ? "|" + word->word : ""); }

std::int64_t WholeNumber::read(const Value& value) const {
  if (is_word(value, word)) return static_cast<std::int64_t>(word->stands_for);
  const auto* number = std::get_if<std::int64_t>(&value.data);
  if (number == nullptr) throw Mistake(or_word("must be a whole number", word));
  if (!bounds.contains(static_cast<double>(*number)))
    throw Mistake(or_word(bounds.text(Dimension::ratio), word));
  return *number;
}

Value WholeNumber::write(std::int64_t number) const {
  if (word && number == static_cast<std::int64_t>(word->stands_for)) return {word->word};
  return {number};
}

bool Boolean::read(const Value& value) const {
  const auto* boolean = std::get_if<bool>(&value.data);
  if (boolean == nullptr) throw Mistake("must be true or false");
  return *boolean;
}

std::string Name::type() const {
  std::string type;
  for (const std::string& name : names) type += (type.empty() ? "" : "|") + name;
  return type;
}

std::string Name::read(const Value& value) const {
  const std::string* text = as_text(value);
  const std::string allowed = "must be " + listed(names);
  if (text == nullptr) throw Mistake(allowed);
  if (std::find(names.begin(), names.end(), *text) == names.end())
    throw Mistake(allowed, did_you_mean(*text, names));
  return *text;
}

std::string Text::read(const Value& value) const {
  const std::string* text = as_text(value);
  if (text == nullptr) throw Mistake("must be a text in quotes");
  if (!is_utf8(*text)) throw Mistake("must be text in UTF-8");
  return *text;
}

std::vector<double> Numbers::read(const Value& value) const {
  std::vector<double> numbers;
  for (const Value& item : as_list(value, "must be a list of numbers, e.g. [80, 160]"))
    numbers.push_back(read_ratio(item));
  return numbers;
}

Value Numbers::write(const std::vector<double>& numbers) const {
  Value::List items;
  for (const double number : numbers) items.push_back({number});
  return {items};
}

std::vector<std::string> Texts::read(const Value& value) const {
  const std::string allowed = "must be a list of names, e.g. [\"void\", \"mortar\", \"aggregate\"]";
  std::vector<std::string> texts;
  for (const Value& item : as_list(value, allowed)) {
    const std::string* text = as_text(item);
    if (text == nullptr || text->empty()) throw Mistake(allowed);
    texts.push_back(*text);
  }
  return texts;
}

Value Texts::write(const std::vector<std::string>& texts) const {
  Value::List items;
  for (const std::string& text : texts) items.push_back({text});
  return {items};
}

specimen::Crop Rectangle::read(const Value& value) const {
  const std::string allowed = "must be x, y, width and height in pixels, e.g. [10, 20, 400, 300]";
  const Value::List& items = as_list(value, allowed);
  if (items.empty()) return {};
  if (items.size() != 4) throw Mistake(allowed);
  std::vector<int> numbers;
  for (const Value& item : items) {
    const auto* number = std::get_if<std::int64_t>(&item.data);
    if (number == nullptr || *number < 0 || *number > 1'000'000) throw Mistake(allowed);
    numbers.push_back(static_cast<int>(*number));
  }
  if (numbers[2] == 0 || numbers[3] == 0) throw Mistake("width and height must be > 0");
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

Value Rectangle::write(const specimen::Crop& crop) const {
  Value::List items;
  if (crop.width > 0)
    for (const std::int64_t number : {crop.x, crop.y, crop.width, crop.height}) items.push_back({number});
  return {items};
}

LabelNames::Names LabelNames::read(const Value& value) const {
  const std::string allowed = "must be a list of labels and names, e.g. [\"0: void\", \"1: mortar\"]";
  Names names;
  for (const Value& item : as_list(value, allowed)) {
    const std::string* text = as_text(item);
    if (text == nullptr) throw Mistake(allowed);
    const auto [label, phase] = cut_at(*text, ":", label_name_form);
    const auto number = whole_number(label);
    if (!number || phase.empty()) throw Mistake(quoted(*text) + " does not fit", label_name_form);
    names.emplace_back(*number, phase);
  }
  return names;
}

Value LabelNames::write(const Names& names) const {
  Value::List items;
  for (const auto& [label, phase] : names) items.push_back({fmt::format("{}: {}", label, phase)});
  return {items};
}

specimen::Grading SizeClasses::read(const Value& value) const {
  const std::string allowed = "must be a list of size classes, e.g. [\"10 mm .. 20 mm: 60 %\", ...]";
  specimen::Grading classes;
  for (const Value& item : as_list(value, allowed)) {
    const std::string* text = as_text(item);
    if (text == nullptr) throw Mistake(allowed);
    classes.push_back(read_size_class(*text));
  }
  std::sort(classes.begin(), classes.end(), [](const auto& a, const auto& b) { return a.d_max > b.d_max; });
  double sum = 0;
  for (const auto& size_class : classes) sum += size_class.share;
  if (!classes.empty() && std::abs(sum - 1) > 1e-9)
    throw Mistake(fmt::format("the shares add up to {:.6g} %", 100 * sum), "make them add up to 100 %");
  return classes;
}

Value SizeClasses::write(const specimen::Grading& classes) const {
  Value::List items;
  for (const auto& size_class : classes)
    items.push_back(
        {fmt::format("{} .. {}: {}", format_quantity(size_class.d_min, Dimension::length),
                     format_quantity(size_class.d_max, Dimension::length), format_number(size_class.share))});
  return {items};
}

}  // namespace app
