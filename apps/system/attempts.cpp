#include "apps/system/attempts.hpp"

#include <utility>

#include "specimen/body/error.hpp"

NotWritten::NotWritten(std::vector<mpm::FileError> all)
    : mpm::FileError(all.front()), files(std::move(all)) {}

void Attempts::operator()(const std::function<void()>& write) {
  try {
    write();
  } catch (const mpm::FileError& error) {
    failures_.push_back(error);
  } catch (const specimen::Error& error) {
    if (error.fault != specimen::Fault::write) throw;
    failures_.emplace_back(error.field, error.value, error.allowed, error.cure);
  }
}

void Attempts::conclude() const {
  if (!failures_.empty()) throw NotWritten(failures_);
}
