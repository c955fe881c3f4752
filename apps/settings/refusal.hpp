/// What every exception of the libraries means to who asked: the exit code, and the complaints.
#pragma once

#include <exception>

#include "apps/settings/assignment.hpp"
#include "apps/text/complaint.hpp"

namespace app {

/// The exception as a refusal, its complaints at the places where the user set what they are about. What none
/// of ours is becomes an internal error.   @pre there is an exception.
[[nodiscard]] Rejected refusal_of(const std::exception_ptr& exception, const Origins& origins);

}  // namespace app
