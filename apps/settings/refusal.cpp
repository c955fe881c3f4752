#include "apps/settings/refusal.hpp"

#include <filesystem>
#include <new>

#include "apps/system/attempts.hpp"
#include "libmpm/scene/error.hpp"
#include "specimen/body/error.hpp"

namespace app {
namespace {

template <class Error>
Complaint complaint_of(const Error& error) {
  return complaint(error.field, error.value, error.allowed, error.cure);
}

std::vector<Complaint> complaints_of(const std::vector<mpm::FileError>& files) {
  std::vector<Complaint> complaints;
  for (const mpm::FileError& file : files) complaints.push_back(complaint_of(file));
  return complaints;
}

Rejected unplaced(const std::exception_ptr& exception) {
  try {
    std::rethrow_exception(exception);
  } catch (const Rejected& rejected) {
    return rejected;
  } catch (const specimen::Error& error) {
    return {error.fault == specimen::Fault::write ? Exit::io : Exit::data, complaint_of(error)};
  } catch (const NotWritten& missing) {
    return {Exit::io, complaints_of(missing.files)};
  } catch (const mpm::FileError& error) {
    return {Exit::io, complaint_of(error)};
  } catch (const mpm::Error& error) {
    return {Exit::data, complaint_of(error)};
  } catch (const std::filesystem::filesystem_error& error) {
    return {Exit::io, complaint("", error.what(), "")};
  } catch (const std::bad_alloc&) {
    return {Exit::data, complaint("memory", "not enough", "", "use fewer, larger pixels")};
  } catch (const std::exception& error) {
    return {Exit::internal, complaint("internal error", error.what(), "", "please report it")};
  }
}

}  // namespace

Rejected refusal_of(const std::exception_ptr& exception, const Origins& origins) {
  const Rejected found = unplaced(exception);
  std::vector<Complaint> placed;
  for (const Complaint& complaint : found.complaints) placed.push_back(locate(origins, complaint));
  return {found.code, std::move(placed)};
}

}  // namespace app
