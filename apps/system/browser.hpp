/// The browser of the person at this machine.
#pragma once

#include <string>

namespace app {

/// Shows an address in the browser where there is a screen, and a person at the terminal; else it does
/// nothing. The address may hold a secret: it is handed over in a file that no other user can read, since
/// they see the arguments of programs. The file is gone with the object.
class OpenedBrowser {
 public:
  explicit OpenedBrowser(const std::string& address);
  ~OpenedBrowser();
  OpenedBrowser(const OpenedBrowser&) = delete;
  OpenedBrowser& operator=(const OpenedBrowser&) = delete;

 private:
  std::string file_;  ///< empty = there is none
};

/// A page that leads to an address.
[[nodiscard]] std::string page_that_leads_to(const std::string& address);

}  // namespace app
