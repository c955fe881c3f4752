/// Settings whose effect cannot be judged because one that decides it was refused: they are not complained
/// about.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "apps/text/complaint.hpp"

namespace app {

class SceneDoubt {
 public:
  /// @param complaints  about keys and values of a scene.   @param left_out  its lines that are no TOML.
  SceneDoubt(const std::vector<Complaint>& complaints, const std::string& left_out);

  /// Whether it is open that a setting has an effect, or whether what the libraries say of it holds.
  [[nodiscard]] bool is_about(std::string_view key) const;

  /// Whether it is open what the specimen is made from.
  [[nodiscard]] bool is_about_specimen() const;

 private:
  void add(std::string_view key);
  void add_group(const std::string& group);  ///< empty = all there are
  void add_complaint(const Complaint& complaint);
  void add_line(std::string_view line);

  std::string left_out_;
  std::set<std::string, std::less<>> deciding_;  ///< keys that decide, and are in doubt
};

}  // namespace app
