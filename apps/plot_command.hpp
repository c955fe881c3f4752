/// mesopix plot: pictures of a run for papers and slides.
#pragma once

#include "apps/command.hpp"

namespace app {

class PlotCommand : public Command {
 public:
  explicit PlotCommand(CLI::App& program);
  Exit run(Console& console) override;

 private:
  std::string run_;
  std::string what_ = "damage";
  std::string at_ = "100%peak";
  std::string look_ = "grey";
  std::string output_;
};

}  // namespace app
