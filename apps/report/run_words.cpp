#include "apps/report/run_words.hpp"

namespace output {

std::string word_of(mpm::Direction direction) {
  switch (direction) {
    case mpm::Direction::tension:
      return "tension";
    case mpm::Direction::compression:
      return "compression";
    case mpm::Direction::none:
      return "none";
  }
  return {};
}

std::string word_of(mpm::Platen platen) { return platen == mpm::Platen::smooth ? "smooth" : "rough"; }

std::string word_of(mpm::Plane plane) {
  return plane == mpm::Plane::strain ? "plane strain" : "plane stress";
}

std::string word_of(mpm::Precision precision) {
  return precision == mpm::Precision::single ? "single" : "double";
}

std::string word_of(mpm::CrackClosure law) {
  switch (law) {
    case mpm::CrackClosure::off:
      return "off";
    case mpm::CrackClosure::clipped:
      return "clipped";
    case mpm::CrackClosure::unilateral:
      return "unilateral";
  }
  return {};
}

std::string word_of(mpm::Kinematics kinematics) {
  switch (kinematics) {
    case mpm::Kinematics::small_strain:
      return "small_strain";
    case mpm::Kinematics::moving:
      return "moving";
    case mpm::Kinematics::automatic:
      return "auto";
  }
  return {};
}

std::string word_of(mpm::StopReason reason) {
  switch (reason) {
    case mpm::StopReason::strain:
      return "strain";
    case mpm::StopReason::time:
      return "time";
    case mpm::StopReason::drop:
      return "drop";
    case mpm::StopReason::interrupted:
      return "interrupted";
  }
  return {};
}

std::string phrase_of(mpm::StopReason reason) {
  switch (reason) {
    case mpm::StopReason::strain:
      return "the final strain was reached";
    case mpm::StopReason::time:
      return "its time was over";
    case mpm::StopReason::drop:
      return "the stress had dropped";
    case mpm::StopReason::interrupted:
      return "it was interrupted";
  }
  return {};
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string phase_word(const std::string& phase) { return phase == "itz" ? "ITZ" : phase; }

}  // namespace output
