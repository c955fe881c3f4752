#include "apps/text/json_text.hpp"

#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/text/complaint.hpp"

namespace app {

std::string json_text(const nlohmann::ordered_json& json) {
  std::istringstream written(json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  std::string text;
  for (std::string line; std::getline(written, line);) text += escaped_controls(line) + '\n';
  return text;
}

}  // namespace app
