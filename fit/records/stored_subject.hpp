#pragma once

#include <filesystem>
#include <optional>

#include "problem/free_parameters.hpp"
#include "results/records.hpp"
#include "scenarios/read_scenario.hpp"

namespace trunk {

/// A subject as a fit or a run left it.
struct StoredSubject {
  std::vector<NamedValue> parameters;
  std::optional<ScenarioFile> own;     // of a fit: how the subject breathes, in the scenario of the fit
  std::vector<Candidate> draws;        // of a fit; none in a file of version 1
  std::vector<FitRecord::Gate> gates;  // of a fit: why it withholds what a muscle and a recoil explain
};

/// Reads a subject; throws InputError if the file holds neither a fit nor a run.
StoredSubject read_stored_subject(const std::filesystem::path& path);

/// Makes a scenario breathe as the subject does. Of a fit that is the parameters, the activation, the period
/// and whether breathing repeats, and the lung or that there is none; the airway stays that of the scenario.
/// Of a run it is the parameters and the activation (see adopt_parameters).
/// => scenario
void breathe_as(const StoredSubject& subject, Scenario& scenario);
void breathe_as(const Scenario& subject, Scenario& scenario);

/// Returns the numbers that draws are stored as. Their names are those of parameters_of.
FitRecord::Draws draws_record(const std::vector<Candidate>& draws);

}  // namespace trunk
