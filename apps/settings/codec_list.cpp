// The codecs of codec.hpp whose values are lists.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>

#include "apps/settings/codec.hpp"
#include "apps/text/quantity.hpp"
#include "apps/text/text_parts.hpp"

namespace app {
namespace {

Form list_form(const char* name, Items items) {
  return {.kind = Kind::list, .name = name, .items = std::move(items)};
}

const Value::List& as_list(const Value& value, const std::string& allowed) {
  const auto* list = std::get_if<Value::List>(&value.data);
  if (list == nullptr) throw Mistake(allowed);
  return *list;
}

/// @throws Mistake for a value that is no list, and for an item that is no text.
std::vector<std::string> as_texts(const Value& value, const std::string& allowed) {
  std::vector<std::string> texts;
  for (const Value& item : as_list(value, allowed)) {
    const auto* text = std::get_if<std::string>(&item.data);
    if (text == nullptr) throw Mistake(allowed);
    texts.push_back(*text);
  }
  return texts;
}

template <class Items, class Write>
Value list_of(const Items& items, const Write& write) {
  Value::List list;
  for (const auto& item : items) list.push_back({write(item)});
  return {list};
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

constexpr int most_pixels = 1'000'000;  // of a side of a rectangle
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

Form NumbersCodec::form() { return list_form("NUMBER,...", {}); }

std::vector<double> NumbersCodec::read(const Value& value) const {
  std::vector<double> numbers;
  for (const Value& item : as_list(value, "must be a list of numbers, e.g. [80, 160]"))
    numbers.push_back(QuantityCodec{}.read(item));
  return numbers;
}

Value NumbersCodec::write(const std::vector<double>& numbers) const {
  return list_of(numbers, std::identity());
}

Form TextsCodec::form() { return list_form("NAME,...", {.pattern = "."}); }

std::vector<std::string> TextsCodec::read(const Value& value) const {
  const std::string allowed = "must be a list of names, e.g. [\"void\", \"mortar\", \"aggregate\"]";
  std::vector<std::string> texts = as_texts(value, allowed);
  if (std::find(texts.begin(), texts.end(), "") != texts.end()) throw Mistake(allowed);
  return texts;
}

Value TextsCodec::write(const std::vector<std::string>& texts) const {
  return list_of(texts, std::identity());
}

Form LengthsCodec::form() const { return list_form(name.c_str(), {.pattern = ".", .number = number}); }

std::vector<double> LengthsCodec::read(const Value& value) const {
  std::vector<double> lengths;
  for (const std::string& text : as_texts(value, allowed))
    lengths.push_back(parse_quantity(text, Dimension::length));
  if (!lengths.empty() && lengths.size() != static_cast<std::size_t>(number)) throw Mistake(allowed);
  return lengths;
}

Value LengthsCodec::write(const std::vector<double>& lengths) const {
  return list_of(lengths, [](double length) { return format_quantity(length, Dimension::length); });
}

Form RectangleCodec::form() {
  return list_form("X,Y,WIDTH,HEIGHT", {.whole = between(0, most_pixels), .number = 4});
}

specimen::Crop RectangleCodec::read(const Value& value) const {
  const std::string allowed = "must be x, y, width and height in pixels, e.g. [10, 20, 400, 300]";
  const Value::List& items = as_list(value, allowed);
  if (items.empty()) return {};
  if (items.size() != 4) throw Mistake(allowed);
  std::vector<int> numbers;
  for (const Value& item : items) {
    const auto* number = std::get_if<std::int64_t>(&item.data);
    if (number == nullptr || *number < 0 || *number > most_pixels) throw Mistake(allowed);
    numbers.push_back(static_cast<int>(*number));
  }
  if (numbers[2] == 0 || numbers[3] == 0) throw Mistake("width and height must be > 0");
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

Value RectangleCodec::write(const specimen::Crop& crop) const {
  std::vector<std::int64_t> numbers;
  if (crop.width > 0) numbers = {crop.x, crop.y, crop.width, crop.height};
  return list_of(numbers, std::identity());
}

namespace {

/// "#ff8000", as notes write the colours of a map.
bool is_colour(std::string_view text) {
  constexpr std::size_t length = 7;
  return text.size() == length && text.front() == '#' &&
         text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string_view::npos;
}

std::optional<std::int64_t> colour_number(std::string_view text) {
  std::int64_t number = 0;
  std::from_chars(text.data() + 1, text.data() + text.size(), number, 16);
  return number;
}

}  // namespace

Form LabelNamesCodec::form() {
  return list_form("LABEL:NAME,...", {.pattern = R"(^\s*([-+]?[0-9]+|#[0-9a-fA-F]{6})\s*:\s*\S)"});
}

LabelNamesCodec::Names LabelNamesCodec::read(const Value& value) const {
  Names names;
  for (const std::string& text :
       as_texts(value, "must be a list of labels and names, e.g. [\"0: void\", \"1: mortar\"]")) {
    const auto [label, phase] = cut_at(text, ":", label_name_form);
    const auto number = is_colour(label) ? colour_number(label) : whole_number(label);
    if (!number || phase.empty()) throw Mistake(quoted(text) + " does not fit", label_name_form);
    names.emplace_back(*number, phase);
  }
  return names;
}

Value LabelNamesCodec::write(const Names& names) const {
  return list_of(names, [](const auto& name) { return fmt::format("{}: {}", name.first, name.second); });
}

Form SizeClassesCodec::form() {
  return list_form("LENGTH..LENGTH:SHARE,...", {.pattern = R"(^.*[0-9].*\.\..*[0-9].*:.*[0-9].*$)"});
}

specimen::Grading SizeClassesCodec::read(const Value& value) const {
  specimen::Grading classes;
  for (const std::string& text :
       as_texts(value, "must be a list of size classes, e.g. [\"10 mm .. 20 mm: 60 %\", ...]"))
    classes.push_back(read_size_class(text));
  std::sort(classes.begin(), classes.end(), [](const auto& a, const auto& b) { return a.d_max > b.d_max; });
  double sum = 0;
  for (const auto& size_class : classes) sum += size_class.share;
  if (!classes.empty() && std::abs(sum - 1) > 1e-9)
    throw Mistake(fmt::format("the shares add up to {:.6g} %", 100 * sum), "make them add up to 100 %");
  return classes;
}

Value SizeClassesCodec::write(const specimen::Grading& classes) const {
  return list_of(classes, [](const auto& one) {
    return fmt::format("{} .. {}: {}", format_quantity(one.d_min, Dimension::length),
                       format_quantity(one.d_max, Dimension::length), format_number(one.share));
  });
}

}  // namespace app
