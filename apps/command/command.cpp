#include "apps/command/command.hpp"

namespace app {

const std::vector<ExitMeaning>& exit_meanings() {
  static const std::vector<ExitMeaning> all{
      {Exit::ok, "EX_OK", "done", "What was asked for is done."},
      {Exit::usage, "EX_USAGE", "wrong usage",
       "The command line is wrong: an unknown command or option, a value that is not allowed, or options "
       "that "
       "contradict each other. Nothing was written."},
      {Exit::data, "EX_DATAERR", "wrong data or physics",
       "A scene, a picture, a specimen or another file is wrong, or the physics went wrong; what was "
       "computed "
       "until then is kept. Studies and calibrations end so too when members failed or a target was not "
       "met."},
      {Exit::internal, "EX_SOFTWARE", "a bug of ours",
       "A mistake of the program itself: please report it with the message. So ends mesopix bench where a "
       "case "
       "does not hold."},
      {Exit::io, "EX_IOERR", "input or output failed",
       "A file cannot be read or written, or the disk is full. What the disk took is kept, and the rest is "
       "named."},
      {Exit::interrupted, "EX_TEMPFAIL", "interrupted with what was computed kept",
       "Ended by Ctrl-C, SIGTERM, SIGHUP or the button of the live report; members of a study are still "
       "open; or "
       "another program writes the folder. The same command, or mesopix simulate --resume, goes on."},
  };
  return all;
}

std::string exit_summary() {
  constexpr std::size_t longest = 99;
  std::string text;
  std::size_t line = 0;
  for (const ExitMeaning& meaning : exit_meanings()) {
    const std::string part = std::to_string(static_cast<int>(meaning.code)) + " " + meaning.brief;
    if (!text.empty()) {
      text += line + 2 + part.size() < longest ? ", " : ",\n";
      line = text.back() == '\n' ? 0 : line + 2;
    }
    text += part;
    line += part.size();
  }
  return text;
}

Exit Command::execute(Console& console) {
  for (const CommandPointer& command : below_)
    if (command->options().parsed()) {
      refuse_remaining(command->options());
      return command->execute(console);
    }
  console.quiet = quiet_;
  return run(console);
}

void Command::require(const std::string& argument, const std::string& name, const std::string& usage) {
  if (argument.empty()) throw Rejected(Exit::usage, name, "missing", "", usage);
}

}  // namespace app
