/// mesopix plot: pictures of a run for papers and slides.
#pragma once

#include <string>
#include <vector>

#include "apps/command/command.hpp"

namespace app {

class PlotCommand : public Command {
 public:
  explicit PlotCommand(CLI::App& program);
  Exit run(Console& console) override;

 private:
  /// An option of some of the kinds of pictures.
  struct Special {
    CLI::Option* option;
    std::vector<std::string> fits;
  };
  void add(const char* name, std::string& text, const char* type, const char* help,
           std::vector<std::string> fits);
  void check_fit() const;

  std::vector<Special> special_;
  std::string run_;
  std::string what_ = "damage";
  std::string at_ = "100%peak";
  std::string look_ = "grey";
  std::string component_ = "yy";
  std::string range_ = "auto";
  std::string output_;
  bool json_ = false;
  bool quiet_ = false;
};

}  // namespace app
