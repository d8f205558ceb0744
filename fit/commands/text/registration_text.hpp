#pragma once

#include "commands/text/output.hpp"
#include "registration/register_trunk.hpp"

namespace trunk {

/// Whether a registration is what the user asked for.
struct RegistrationVerdict {
  /// "registered", "mostly_extrapolated", "beyond_tolerance", "implausible" or "unsound_mesh"
  std::string status;
  std::string message;  ///< the reason, as a sentence without its full stop

  bool done() const { return status == "registered"; }
};

/// Returns whether the triangles are sound, turn, scale and stretch of the lung are those of a subject, every
/// target as a whole is near enough, and the zone of apposition has the length that the user gave. Near
/// means: where there are data, both ways, the RMS distance is at most `tolerance`, m, and the 95th
/// percentile at most twice that.
RegistrationVerdict verdict_of(const Registration& found, double tolerance);

/// Returns what a user should know about a finished registration, one sentence or two for each point.
std::vector<std::string> warnings_of(const Registration& found);

Json registration_json(const Registration& found, const RegistrationVerdict& verdict);
std::string registration_text(const Registration& found, const RegistrationVerdict& verdict);

}  // namespace trunk
