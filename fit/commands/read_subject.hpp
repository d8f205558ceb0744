#pragma once

#include <filesystem>

#include "commands/options/register_options.hpp"
#include "registration/register_trunk.hpp"

namespace trunk {

/// The surfaces and landmarks that a registration aims at, and the files that they come from.
struct RegistrationSubject {
  SubjectMeasurements measurements;
  std::vector<std::filesystem::path> files;
  std::vector<std::string> notes;  ///< what the readers did, one sentence each, with the name of the file
};

/// Returns what the user gave for `register`. Landmarks are in the unit and axes of the first file, and the
/// other files have its axes if they do not say theirs. Throws InputError.
RegistrationSubject read_subject(const RegisterRequest& request);

}  // namespace trunk
