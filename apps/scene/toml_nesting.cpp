#include "apps/scene/toml_nesting.hpp"

#include <algorithm>
#include <string_view>

#include "apps/text/complaint.hpp"

namespace app {
namespace {

constexpr int most_parts = 16, most_levels = 32;

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
    throw Rejected(Exit::data, {place, "nested too deep", "",
                                "a key has at most 16 parts, and a list lies within at most 32 others", ""});
  }

  std::string_view text_;
  const std::string& path_;
  std::size_t at_ = 0;
  int parts_ = 1;  ///< of the key that is being read
  int level_ = 0;  ///< lists and tables that are open
};

}  // namespace

void check_nesting(const std::string& text, const std::string& path) { Nesting(text, path).check(); }

}  // namespace app
