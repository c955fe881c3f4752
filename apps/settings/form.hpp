/// What a value of a setting may be, as data: for comments in scenes and for their JSON Schema.
/// One setting: its key, what it may be, and how it is read into and written from the settings.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "apps/settings/codec.hpp"
#include "apps/text/quantity.hpp"

namespace app {

/// What a setting that is a number measures, and how large it may be.
struct Measure {
  Dimension dimension = Dimension::ratio;
  Bounds bounds;
};

/// Items of a list.
struct Items {
  std::optional<Bounds> whole;  ///< they are whole numbers
  std::string pattern;          ///< they are texts that this regular expression describes
  int number = 0;               ///< the list has none of them or so many; 0 = any number
};

/// Of a kind of its own, or one of the words.
struct Form {
  Kind kind = Kind::text;
  std::vector<std::string> words;  ///< all that a choice has; of a number those that stand for special ones
  std::optional<Measure> measure;  ///< of a quantity
  std::optional<Bounds> whole;     ///< of a whole number
  std::optional<Items> items;      ///< of a list; without a pattern and whole numbers they are numbers
};

/// What is allowed, in a few words: "length > 0, or auto", "tension, compression or none".
[[nodiscard]] std::string text(const Form& form);

[[nodiscard]] Form form_of(const Quantity& codec);
[[nodiscard]] Form form_of(const OptionalQuantity& codec);
[[nodiscard]] Form form_of(const WholeNumber& codec);
[[nodiscard]] Form form_of(const Boolean& codec);
[[nodiscard]] Form form_of(const Name& codec);
[[nodiscard]] Form form_of(const Text& codec);
[[nodiscard]] Form form_of(const Path& codec);
[[nodiscard]] Form form_of(const Numbers& codec);
[[nodiscard]] Form form_of(const Texts& codec);
[[nodiscard]] Form form_of(const Rectangle& codec);
[[nodiscard]] Form form_of(const LabelNames& codec);
[[nodiscard]] Form form_of(const SizeClasses& codec);

template <class T>
Form form_of(const Integer<T>& codec) {
  return form_of(codec.number);
}

template <class E>
Form form_of(const Choice<E>& codec) {
  return form_of(codec.name());
}

/// A setting held in an object of type T (Settings, or mpm::Phase for the properties of every phase).
template <class T>
struct FieldOf {
  std::string key;   ///< "loading.velocity"; "young" for a property of phases
  std::string help;  ///< one line, without the default
  Kind kind;
  std::string type;                           ///< as the help shows it: "VELOCITY", "smooth|rough"
  std::function<void(T&, const Value&)> set;  ///< throws Mistake
  std::function<Value(const T&)> get;
  std::optional<Measure> measure;  ///< of a quantity; none of whole numbers and all others
  Form form = {};
};

template <class Codec>
std::optional<Measure> measure_of(const Codec& codec) {
  if constexpr (std::is_same_v<Codec, Quantity>)
    return Measure{codec.dimension, codec.bounds};
  else
    return std::nullopt;
}

/// @param access  generic lambda that gives the member of a T, const or not.
template <class T, class Codec, class Access>
FieldOf<T> make_field(std::string key, std::string help, Codec codec, Access access) {
  return {std::move(key),
          std::move(help),
          codec.kind(),
          codec.type(),
          [codec, access](T& object, const Value& value) { access(object) = codec.read(value); },
          [codec, access](const T& object) { return codec.write(access(object)); },
          measure_of(codec),
          form_of(codec)};
}

}  // namespace app
