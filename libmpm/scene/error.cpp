#include "libmpm/scene/error.hpp"

#include <utility>

namespace mpm {
namespace {

std::string sentence(const std::string& field, const std::string& value, const std::string& allowed,
                     const std::string& cure) {
  std::string text = field + ": " + value;
  if (!allowed.empty()) text += "; " + allowed;
  if (!cure.empty()) text += "; " + cure;
  return text;
}

}  // namespace

Error::Error(std::string field_name, std::string value_met, std::string what_is_allowed,
             std::string how_to_cure)
    : std::runtime_error(sentence(field_name, value_met, what_is_allowed, how_to_cure)),
      field(std::move(field_name)),
      value(std::move(value_met)),
      allowed(std::move(what_is_allowed)),
      cure(std::move(how_to_cure)) {}

}  // namespace mpm
