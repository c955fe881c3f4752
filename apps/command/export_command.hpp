/// mesopix export: specimens and runs in the formats of other programs.
#pragma once

#include "apps/command/command.hpp"

namespace app {

class ExportCommand : public Command {
 public:
  explicit ExportCommand(CLI::App& program);
  Exit run(Console& console) override;

 private:
  void tell(const std::vector<std::string>& files, Console& console) const;
  Exit export_run(const std::string& result_file, Console& console) const;

  std::string input_;
  std::string format_;
  std::string output_;
  std::string plane_;
  bool json_ = false;
  bool quiet_ = false;
};

}  // namespace app
