#include "apps/settings/form.hpp"

namespace app {
namespace {

Form of_kind(Kind kind) {
  Form form;
  form.kind = kind;
  return form;
}

Form list_of(Items items) {
  Form form = of_kind(Kind::list);
  form.items = std::move(items);
  return form;
}

std::vector<std::string> word_of(const std::optional<Word>& word) {
  return word ? std::vector{word->word} : std::vector<std::string>();
}

std::string with_bounds(const std::string& what, const Bounds& bounds, Dimension dimension) {
  const std::string range = bounds.range(dimension);
  return range.empty() ? what : what + " " + range;
}

/// A list, by what the command line calls it.
std::string list_text(const Items& items) {
  if (items.number > 0) return "[x, y, width, height]";
  return items.pattern.empty() ? "list of numbers" : "list of texts";
}

std::string text_without_words(const Form& form) {
  if (form.measure)
    return with_bounds(name(form.measure->dimension), form.measure->bounds, form.measure->dimension);
  if (form.whole) return with_bounds("whole number", *form.whole, Dimension::ratio);
  if (form.items) return list_text(*form.items);
  if (form.kind == Kind::boolean) return "true or false";
  return form.kind == Kind::path ? "name of a file" : "text";
}

}  // namespace

std::string text(const Form& form) {
  if (form.kind == Kind::choice) return listed(form.words);
  std::string what = text_without_words(form);
  for (const std::string& word : form.words) what += ", or " + word;
  return what;
}

Form form_of(const Quantity& codec) {
  Form form = of_kind(Kind::quantity);
  form.measure = Measure{codec.dimension, codec.bounds};
  form.words = word_of(codec.word);
  return form;
}

Form form_of(const OptionalQuantity& codec) {
  Form form = form_of(codec.quantity);
  form.words.push_back(codec.word);
  return form;
}

Form form_of(const WholeNumber& codec) {
  Form form = of_kind(Kind::integer);
  form.whole = codec.bounds;
  form.words = word_of(codec.word);
  return form;
}

Form form_of(const Boolean&) { return of_kind(Kind::boolean); }

Form form_of(const Name& codec) {
  Form form = of_kind(Kind::choice);
  form.words = codec.names;
  return form;
}

Form form_of(const Text&) { return of_kind(Kind::text); }

Form form_of(const Path&) { return of_kind(Kind::path); }

Form form_of(const Numbers&) { return list_of({}); }

Form form_of(const Texts&) { return list_of({{}, ".", 0}); }

Form form_of(const Rectangle&) { return list_of({between(0, Rectangle::most), {}, 4}); }

Form form_of(const LabelNames&) { return list_of({{}, R"(^\s*[-+]?[0-9]+\s*:\s*\S)", 0}); }

Form form_of(const SizeClasses&) { return list_of({{}, R"(^.*[0-9].*\.\..*[0-9].*:.*[0-9].*$)", 0}); }

}  // namespace app
