// The codecs of codec.hpp whose values are lists.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/settings/codec.hpp"
#include "apps/text/quantity.hpp"
#include "apps/text/text_parts.hpp"

namespace app {
namespace {

const std::string* as_words(const Value& value) { return std::get_if<std::string>(&value.data); }

const Value::List& as_list(const Value& value, const std::string& allowed) {
  const auto* list = std::get_if<Value::List>(&value.data);
  if (list == nullptr) throw Mistake(allowed);
  return *list;
}

/// The two sides of a separator.   @throws Mistake where it does not occur.
std::pair<std::string, std::string> cut_at(const std::string& text, const std::string& separator,
                                           const std::string& allowed) {
  const std::size_t at = text.find(separator);
  if (at == std::string::npos) throw Mistake(quoted(text) + " does not fit", allowed);
  const std::string_view whole = text;
  return {std::string(trimmed(whole.substr(0, at))),
          std::string(trimmed(whole.substr(at + separator.size())))};
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

}  // namespace

std::vector<double> Numbers::read(const Value& value) const {
  std::vector<double> numbers;
  for (const Value& item : as_list(value, "must be a list of numbers, e.g. [80, 160]"))
    numbers.push_back(Quantity{}.read(item));
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
    const std::string* text = as_words(item);
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
    if (number == nullptr || *number < 0 || *number > most) throw Mistake(allowed);
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
    const std::string* text = as_words(item);
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
    const std::string* text = as_words(item);
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
