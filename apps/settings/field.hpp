/// One setting: its key, what it may be, and how it is read into and written from the settings.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "apps/settings/codec.hpp"
#include "apps/settings/form.hpp"
#include "apps/text/value.hpp"

namespace app {

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
