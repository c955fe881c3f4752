#include "apps/settings/form.hpp"

#include <fmt/format.h>

#include <cmath>

#include "apps/text/words.hpp"

namespace app {
namespace {

std::string with_range(const std::string& what, const std::string& range) {
  return range.empty() ? what : what + " " + range;
}

/// A list, by what the command line calls it.
std::string list_text(const Items& items) {
  if (items.number > 0) return "[x, y, width, height]";
  return items.pattern.empty() ? "list of numbers" : "list of texts";
}

std::string text_without_words(const Form& form) {
  if (form.measure)
    return with_range(name(form.measure->dimension), form.measure->bounds.range(form.measure->dimension));
  if (form.whole) return with_range("whole number", form.whole->range(Dimension::ratio));
  if (form.items) return list_text(*form.items);
  if (form.kind == Kind::boolean) return "true or false";
  return form.kind == Kind::path ? "name of a file" : "text";
}

}  // namespace

std::string Bounds::range(Dimension dimension) const {
  const auto shown = [dimension](double limit) {
    return limit == 0 ? std::string("0") : format_quantity(limit, dimension);
  };
  if (std::isinf(low) && std::isinf(high)) return {};
  if (std::isinf(low)) return (high_open ? "< " : "<= ") + shown(high);
  if (std::isinf(high)) return (low_open ? "> " : ">= ") + shown(low);
  return fmt::format("in {}{}, {}{}", low_open ? '(' : '[', shown(low), shown(high), high_open ? ')' : ']');
}

std::string Bounds::text(Dimension dimension) const {
  return (std::isinf(low) || std::isinf(high) ? "must be " : "must lie ") + range(dimension);
}

std::string type(const Form& form) {
  std::string shown = form.name;
  for (const std::string& word : form.words) shown += (shown.empty() ? "" : "|") + word;
  return shown;
}

std::string text(const Form& form) {
  if (form.kind == Kind::choice) return listed(form.words);
  std::string what = text_without_words(form);
  for (const std::string& word : form.words) what += ", or " + word;
  return what;
}

Form one_of(std::vector<std::string> words) { return {.kind = Kind::choice, .words = std::move(words)}; }

Form text_form(std::string name, std::vector<std::string> words) {
  return {.name = std::move(name), .words = std::move(words)};
}

Form file_form(std::vector<std::string> endings, std::string name) {
  return {.kind = Kind::path, .name = std::move(name), .endings = std::move(endings)};
}

Form folder_form() { return {.kind = Kind::folder, .name = "DIR"}; }

std::vector<std::string> picture_endings(std::vector<std::string> others) {
  others.insert(others.end(), {"png", "tif", "tiff", "jpg", "jpeg", "bmp", "pgm", "ppm"});
  return others;
}

}  // namespace app
