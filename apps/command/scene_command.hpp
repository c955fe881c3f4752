/// mesopix scene: begin a scene, look through it, describe it to editors.
/// All that is wrong with a scene or a study, in one go.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/command/command.hpp"
#include "apps/text/complaint.hpp"

namespace app {

class SceneCommand : public Command {
 public:
  explicit SceneCommand(CLI::App& program);
  std::vector<std::string> prepare(const std::vector<std::string>& arguments) override;
  Exit run(Console& console) override;

 private:
  [[nodiscard]] std::vector<std::string> names() const;

  std::vector<std::unique_ptr<Command>> below_;  ///< init, check, schema
};

/// mesopix scene init: a scene to begin with.
class SceneInitCommand : public Command {
 public:
  explicit SceneInitCommand(CLI::App& scene);
  Exit run(Console& console) override;

 private:
  void check_options() const;
  [[nodiscard]] std::string file() const;
  void write_schema() const;

  std::string argument_;
  std::string output_;
  std::string picture_;
  std::string width_;
  std::string specimen_;
  std::string loading_;
  std::string schema_;
  bool overwrite_ = false;
  bool quiet_ = false;
};

/// mesopix scene check: all that is wrong, in one go.
class SceneCheckCommand : public Command {
 public:
  explicit SceneCheckCommand(CLI::App& scene);
  Exit run(Console& console) override;

 private:
  std::vector<std::string> files_;
  bool json_ = false;
  bool quiet_ = false;
};

/// mesopix scene schema: the JSON Schema of scenes.
class SceneSchemaCommand : public Command {
 public:
  explicit SceneSchemaCommand(CLI::App& scene);
  Exit run(Console& console) override;
};

struct CheckedFile {
  std::string file;
  std::vector<Complaint> complaints;  ///< in the order of the file; none: it can be solved
  bool readable = true;
  std::string what;                ///< what it is, in one line; where nothing is wrong
  std::vector<std::string> notes;  ///< on the specimen, one sentence each
};

/// Read the file, make its specimen and plan its run; of a study, those of its scene and of all members.
/// Nothing is solved, and nothing thrown for what the file says. What follows from other mistakes is left
/// out.
[[nodiscard]] CheckedFile check_file(const std::string& path);

/// For editors: a list with file, line and column (from 1), key, value, problem (the whole message), allowed
/// and cure, each null where there is none.
[[nodiscard]] nlohmann::ordered_json complaints_json(const std::vector<CheckedFile>& files);

}  // namespace app
