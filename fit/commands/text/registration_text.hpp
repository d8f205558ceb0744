#pragma once

#include "commands/text/output.hpp"
#include "registration/register_trunk.hpp"

namespace trunk {

/// Whether a registration is what was asked for.
struct RegistrationVerdict {
  std::string status;   // "registered", "beyond_tolerance", "unsound_mesh"
  std::string message;  // why, in words

  bool done() const { return status == "registered"; }
};

/// Of every target as a whole: RMS distance within the tolerance, m, and 95th percentile within twice that,
/// both ways, where there are data; triangles that are sound; and a length of the zone of apposition, where
/// one was asked for, within the tolerance.
RegistrationVerdict verdict_of(const Registration& found, double tolerance);

/// What a user ought to know of a registration that was done, one sentence each.
std::vector<std::string> warnings_of(const Registration& found);

Json registration_json(const Registration& found, const RegistrationVerdict& verdict);
std::string registration_text(const Registration& found, const RegistrationVerdict& verdict);

}  // namespace trunk
