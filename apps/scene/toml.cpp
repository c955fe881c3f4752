#include "apps/scene/toml.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "apps/text/complaint.hpp"
#include "apps/text/text_parts.hpp"

namespace app {
namespace {

constexpr int most_parts = 16, most_levels = 32;

Complaint no_toml(const Place& place, std::string why) {
  Complaint complaint;
  complaint.place = place;
  complaint.defect = std::move(why);
  return complaint;
}

/// Goes through the text as a parser does, as far as it must to tell strings and comments from keys.
class Nesting {
 public:
  Nesting(std::string_view text, const std::string& path) : text_(text), path_(path) {}

  void check() {
    while (at_ < text_.size()) take(text_[at_]);
  }

 private:
  void take(char c) {
    if (c == '"' || c == '\'') return skip_string(c);
    if (c == '#') {
      at_ = std::min(text_.find('\n', at_), text_.size());
      return;
    }
    if (c == '.' && ++parts_ > most_parts) refuse();
    if ((c == '[' || c == '{') && ++level_ > most_levels) refuse();
    if (c == ']' || c == '}') --level_;
    if (c == '\n' || c == '=' || c == ',' || c == '[' || c == '{') parts_ = 1;
    ++at_;
  }

  [[nodiscard]] bool is_triple(char quote) const {
    return at_ + 2 < text_.size() && text_[at_] == quote && text_[at_ + 1] == quote &&
           text_[at_ + 2] == quote;
  }

  void skip_string(char quote) {
    const bool many_lines = is_triple(quote);
    at_ += many_lines ? 3 : 1;
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\\' && quote == '"')
        ++at_;
      else if (many_lines ? is_triple(quote) : text_[at_] == quote || text_[at_] == '\n')
        break;
    }
    // A string of many lines may end in two quotes of its own.
    at_ += many_lines ? 3 : 1;
    for (int i = 0; many_lines && i < 2 && at_ < text_.size() && text_[at_] == quote; ++i) ++at_;
  }

  [[noreturn]] void refuse() const {
    const std::string_view before = text_.substr(0, at_);
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    const Place place{path_, static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1,
                      static_cast<int>(at_ - line_start) + 1};
    throw Rejected(Exit::data, no_toml(place,
                                       "nested too deep: a key has at most 16 parts, and a list lies "
                                       "within at most 32 others"));
  }

  std::string_view text_;
  const std::string& path_;
  std::size_t at_ = 0;
  int parts_ = 1;  ///< of the key that is being read
  int level_ = 0;  ///< lists and tables that are open
};

}  // namespace

void check_nesting(const std::string& text, const std::string& path) { Nesting(text, path).check(); }

toml::table parse_toml(const std::string& text, const std::string& path) try {
  check_nesting(text, path);
  return toml::parse(text, path);
} catch (const toml::parse_error& error) {
  throw Rejected(Exit::data,
                 no_toml(place_of(error.source(), path), "not TOML: " + std::string(error.description())));
}

Place place_of(const toml::source_region& source, const std::string& path) {
  return {path, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

std::optional<Value> value_of(const toml::node& node) {
  if (const auto* boolean = node.as_boolean()) return Value{boolean->get()};
  if (const auto* integer = node.as_integer()) return Value{integer->get()};
  if (const auto* number = node.as_floating_point()) return Value{number->get()};
  if (const auto* text = node.as_string()) return Value{text->get()};
  const auto* array = node.as_array();
  if (array == nullptr) return std::nullopt;
  Value::List items;
  for (const toml::node& item : *array) {
    auto value = value_of(item);
    if (!value) return std::nullopt;
    items.push_back(std::move(*value));
  }
  return Value{std::move(items)};
}

bool stands_before(const Place& a, const Place& b) {
  return std::pair(a.line, a.column) < std::pair(b.line, b.column);
}

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
    result.text = fmt::format("{}", fmt::join(lines, "\n"));
  }
}

}  // namespace app
