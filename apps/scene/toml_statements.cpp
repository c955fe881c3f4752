#include "apps/scene/toml_statements.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "apps/text/text_parts.hpp"

namespace app {
namespace {

/// Lines from first to before last, counted from 0.
struct Statement {
  std::size_t first = 0;
  std::size_t last = 0;
  bool head = false;      ///< of a table: [name]
  bool unclosed = false;  ///< has more [ and { than ] and }
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find('\n', from), text.size());
    lines.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) text += (i > 0 ? "\n" : "") + lines[i];
  return text;
}

/// Brackets that a line opens less those that it closes; those in texts and comments do not count.
int brackets_opened(std::string_view line) {
  int opened = 0;
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote != 0) {
      if (c == '\\' && quote == '"') ++i;
      if (c == quote) quote = 0;
    } else if (c == '#') {
      break;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else {
      opened += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
    }
  }
  return opened;
}

bool may_stand_in_key(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
}

/// "[name", whatever follows: an item of a list begins with a digit, a quote or a bracket.
bool looks_like_head(std::string_view line) {
  const std::string_view name = trimmed(line).substr(std::min<std::size_t>(1, trimmed(line).size()));
  const std::size_t letter = name.find_first_not_of("[ \t");
  return !trimmed(line).empty() && trimmed(line).front() == '[' && letter != std::string_view::npos &&
         std::isalpha(static_cast<unsigned char>(name[letter])) != 0;
}

/// "key ="
bool looks_like_setting(std::string_view line) {
  const std::string_view cut = trimmed(line);
  const auto end = std::find_if_not(cut.begin(), cut.end(), may_stand_in_key);
  const std::string_view rest = trimmed(cut.substr(static_cast<std::size_t>(end - cut.begin())));
  return end != cut.begin() && !rest.empty() && rest.front() == '=';
}

std::vector<Statement> statements_of(const std::vector<std::string>& lines) {
  std::vector<Statement> statements;
  int open = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool head = looks_like_head(lines[i]);
    // No setting and no head stands within a list or a table in braces: the one before was not closed.
    const bool interrupts = open > 0 && (head || looks_like_setting(lines[i]));
    if (interrupts) statements.back().unclosed = true;
    if (open <= 0 || interrupts) {
      statements.push_back({i, i, head, false});
      open = 0;
    }
    statements.back().last = i + 1;
    if (!head) open += brackets_opened(lines[i]);
  }
  return statements;
}

/// The statement that is at fault when the parser stumbles at a line; with what stands below it when it is
/// the head of a table.
Statement culprit(const std::vector<Statement>& statements, std::size_t line) {
  std::size_t at = 0;
  while (at + 1 < statements.size() && statements[at].last <= line) ++at;
  if (at > 0 && statements[at - 1].unclosed) return statements[at - 1];
  Statement found = statements[at];
  if (found.head)
    while (++at < statements.size() && !statements[at].head) found.last = statements[at].last;
  return found;
}

/// @return what stood there.
std::string empty_out(std::vector<std::string>& lines, const Statement& statement) {
  std::string gone;
  for (std::size_t i = statement.first; i < statement.last; ++i) {
    gone += lines[i].empty() ? "" : lines[i] + "\n";
    lines[i].clear();
  }
  return gone;
}

}  // namespace

Parseable parseable(std::string text, const std::function<void(const std::string&)>& parse) {
  constexpr std::size_t most = 20, longest = std::size_t{1} << 20U;
  Parseable result{std::move(text), {}, {}};
  for (;;) {
    Place place;
    try {
      parse(result.text);
      return result;
    } catch (const Rejected& rejected) {
      result.complaints.push_back(rejected.complaints.front());
      place = rejected.complaints.front().place;
    }
    std::vector<std::string> lines = lines_of(result.text);
    const std::size_t line = std::min(static_cast<std::size_t>(std::max(place.line, 1)), lines.size()) - 1;
    const bool goes_on = result.complaints.size() < most && result.text.size() < longest;
    const std::string gone = goes_on ? empty_out(lines, culprit(statements_of(lines), line)) : std::string();
    if (gone.empty()) return {"", result.left_out + result.text, std::move(result.complaints)};
    result.left_out += gone;
    result.text = joined(lines);
  }
}

}  // namespace app
