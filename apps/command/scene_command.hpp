/// mesopix scene: begin a scene, look through it, describe it to editors.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "apps/command/command.hpp"

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

}  // namespace app
