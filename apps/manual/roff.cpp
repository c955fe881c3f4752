#include "apps/manual/roff.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "apps/text/version.hpp"

namespace manual {
namespace {

std::string escaped(char letter) {
  switch (letter) {
    case '\\':
      return "\\e";
    case '-':
      return "\\-";
    case '\'':
      return "\\(aq";
    case '`':
      return "\\(ga";
    case '^':
      return "\\(ha";
    case '~':
      return "\\(ti";
    default:
      return std::string(1, letter);
  }
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// In lines of less than 80 letters, none of which is a request; roff fills them anew.
std::string wrapped(const std::string& formatted) {
  constexpr std::size_t longest = 78;
  std::string text;
  std::size_t line = 0;
  std::istringstream words(formatted);
  for (std::string word; words >> word;) {
    const bool breaks = line > 0 && line + 1 + word.size() > longest;
    if (line > 0) text += breaks ? "\n" : " ";
    if (breaks && word.front() == '.') text += "\\&";
    line = breaks || line == 0 ? word.size() : line + 1 + word.size();
    text += word;
  }
  return text + "\n";
}

std::string heading(const std::string& name, int section, const std::string& about) {
  const std::string shelf = section == 1 ? "User Commands" : "File Formats";
  return ".TH " + upper(roff(name)) + " " + std::to_string(section) + " \"\" \"mesopix " + app::version() +
         "\" \"" + shelf + "\"\n.SH NAME\n" + roff(name) + " \\- " + roff(about) + "\n";
}

}  // namespace

std::string roff(const std::string& text) {
  std::string made = !text.empty() && text.front() == '.' ? "\\&" : "";  // else it would be a request
  for (const char letter : text) made += escaped(letter);
  return made;
}

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }

std::string italic(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

ManPage::ManPage(const std::string& name, int section, const std::string& about)
    : text_(heading(name, section, about)) {}

void ManPage::section(const std::string& title) {
  text_ += ".SH " + roff(title) + "\n";
  fresh_ = true;
}

void ManPage::subsection(const std::string& title) {
  text_ += ".SS " + roff(title) + "\n";
  fresh_ = true;
}

void ManPage::paragraph(const std::string& formatted) {
  text_ += (fresh_ ? "" : ".PP\n") + wrapped(formatted);
  fresh_ = false;
}

void ManPage::item(const std::string& term, const std::string& formatted) {
  text_ += ".TP\n" + term + "\n" + (formatted.empty() ? "\\&\n" : wrapped(formatted));
  fresh_ = false;
}

void ManPage::verbatim(const std::vector<std::string>& lines) {
  text_ += fresh_ ? "" : ".PP\n";
  text_ += ".RS 4\n.nf\n";
  for (const std::string& line : lines) text_ += (line.empty() ? "\\&" : roff(line)) + "\n";
  text_ += ".fi\n.RE\n";
  fresh_ = false;
}

}  // namespace manual
