#include "results/inspect/print_inspection.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "results/inspect/inspection.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

using layout::Inspection;
using Texts = std::vector<std::pair<std::string, std::string>>;

std::string file_size(std::uint64_t bytes) {
  if (bytes < 10000) return fmt::format("{} bytes", bytes);
  if (bytes < 10000000) return fmt::format("{:.1f} kB", static_cast<double>(bytes) * 1e-3);
  return fmt::format("{:.1f} MB", static_cast<double>(bytes) * 1e-6);
}

std::string print_texts(const std::string& title, const Texts& texts) {
  std::string out = title;
  for (const auto& [name, text] : texts)
    out += fmt::format("  {:<14} {}\n", without_controls(name), without_controls(text));
  return out;
}

std::string print_numbers(const std::string& title, const std::vector<NamedValue>& numbers) {
  if (numbers.empty()) return "";
  std::string out = title + "\n";
  for (const NamedValue& number : numbers) {
    const std::string value = std::isfinite(number.value) ? fmt::format("{:.6g}", number.value) : "not known";
    out += fmt::format("  {:<32} {:>14} {}\n", without_controls(number.name), value,
                       without_controls(number.unit));
  }
  return out;
}

std::string print_fitted(const FitRecord& fit) {
  const auto& parameters = fit.parameters;
  if (parameters.empty()) return "";
  std::string out = "parameters: best, standard error, 95 % interval\n";
  for (const auto& parameter : parameters) {
    out += fmt::format("  {:<24} {:>12.6g}", without_controls(parameter.name), parameter.best);
    if (!parameter.free && !parameter.beside)
      out += " fixed";
    else if (!fit.gates.empty())
      out += " (of the simulation, not a result: a gate stands against it)";
    else if (std::isfinite(parameter.stderr_))
      out +=
          fmt::format(" ± {:.3g} [{:.6g}, {:.6g}]", parameter.stderr_, parameter.lower95, parameter.upper95);
    else
      out += " uncertainty not known";
    out +=
        fmt::format(" {}{}\n", without_controls(parameter.unit), parameter.at_bound ? ", AT ITS BOUND" : "");
  }
  return out;
}

/// Returns what a result stands on, or why it is not determined: a gate by its name, as its sentence stands
/// above.
std::string why(const FitRecord::Result& r, const std::vector<FitRecord::Gate>& gates) {
  for (const FitRecord::Gate& gate : gates)
    if (gate.sentence == r.reason) return "gate " + gate.name;
  return r.reason.empty() ? r.assumption : r.reason;
}

/// "0.503 [0.202, 1.7] s, assumption: the airway …"
std::string print_result(const FitRecord::Result& r, const std::vector<FitRecord::Gate>& gates) {
  const std::string unit = r.unit == "1" ? "" : " " + without_controls(r.unit);
  std::string out = fmt::format("  {:<36} ", without_controls(r.name));
  if (!std::isfinite(r.value))
    out += fmt::format("{:>10}", "withheld");
  else if (std::isnan(r.lower95) || std::isnan(r.upper95))
    out += fmt::format("{:>10.4g}{}", r.value, unit);
  else
    out += fmt::format("{:>10.4g} [{:.4g}, {:.4g}]{}", r.value, r.lower95, r.upper95, unit);
  out += ", " + without_controls(r.grade);
  const std::string reason = why(r, gates);
  return out + (reason.empty() ? "" : ": " + without_controls(reason)) + "\n";
}

std::string print_results(const FitRecord& fit) {
  std::string out;
  for (const FitRecord::Gate& gate : fit.gates)
    out += fmt::format("gate {}: {}\n", without_controls(gate.name), without_controls(gate.sentence));
  if (!fit.results.empty()) out += "results: value, 95 % interval, grade\n";
  for (const FitRecord::Result& r : fit.results) out += print_result(r, fit.gates);
  if (!fit.straight.empty())
    out += fmt::format("with an activation of straight lines (residual {:.3g} % of tidal volume)\n",
                       fit.straight_nrmse_percent);
  for (const FitRecord::Result& r : fit.straight) out += print_result(r, fit.gates);
  for (const std::string& note : fit.notes) out += "note: " + without_controls(note) + "\n";
  return out;
}

std::string print_runs(const std::vector<std::pair<std::string, std::size_t>>& counts) {
  if (counts.empty()) return "";
  std::string out = "runs\n";
  for (const auto& [status, count] : counts)
    out += fmt::format("  {:<14} {}\n", without_controls(status), count);
  return out;
}

std::string print_datasets(const Inspection& file) {
  std::string out = "datasets (all read, checksums agree)\n";
  for (const auto& dataset : file.datasets) {
    out += fmt::format("  {:<44} {:<8} {:<16} {:<8} {:>12}\n", without_controls(dataset.path), dataset.type,
                       fmt::format("[{}]", fmt::join(dataset.shape, ", ")), without_controls(dataset.units),
                       file_size(dataset.stored_bytes));
  }
  return out;
}

nlohmann::json to_json(const std::vector<NamedValue>& numbers) {
  nlohmann::json out = nlohmann::json::object();
  for (const NamedValue& number : numbers)
    out[number.name] = {{"value", number.value}, {"unit", number.unit}};
  return out;
}

nlohmann::json to_json(const FitRecord::Parameter& parameter) {
  return {{"value", parameter.best},      {"unit", parameter.unit},       {"stderr", parameter.stderr_},
          {"lower95", parameter.lower95}, {"upper95", parameter.upper95}, {"initial", parameter.initial},
          {"lower", parameter.lower},     {"upper", parameter.upper},     {"at_bound", parameter.at_bound},
          {"free", parameter.free},       {"beside", parameter.beside}};
}

nlohmann::json to_json(const std::vector<FitRecord::Result>& results) {
  const auto text = [](const std::string& words) {
    return words.empty() ? nlohmann::json(nullptr) : nlohmann::json(words);
  };
  nlohmann::json out = nlohmann::json::object();
  for (const FitRecord::Result& r : results)
    out[r.name] = {{"value", r.value},         {"unit", r.unit},
                   {"lower95", r.lower95},     {"upper95", r.upper95},
                   {"grade", r.grade},         {"assumption", text(r.assumption)},
                   {"reason", text(r.reason)}, {"meaning", text(r.meaning)}};
  return out;
}

/// => the keys that `fit --json` has as well
void add_fit(const FitRecord& fit, nlohmann::json& out) {
  out["results"] = to_json(fit.results);
  out["gates"] = nlohmann::json::array();
  for (const FitRecord::Gate& gate : fit.gates) out["gates"].push_back(gate.name);
  out["notes"] = fit.notes;
  if (fit.straight.empty()) return;
  out["straight_activation"] = to_json(fit.straight);
  out["straight_activation"]["nrmse_percent"] = fit.straight_nrmse_percent;
}

}  // namespace

std::string inspection_text(const std::filesystem::path& path) {
  const Inspection file = layout::inspect_results(path);
  return fmt::format("{}: a {}, {}\n", path.string(), file.kind, file_size(file.file_bytes)) +
         print_texts("", file.heading) + print_runs(file.run_status) + print_results(file.fit) +
         print_fitted(file.fit) + print_numbers("parameters", file.parameters) +
         print_numbers("statistics", file.statistics) + print_numbers("measures", file.measures) +
         print_texts("made by\n", file.provenance) + print_datasets(file);
}

std::string inspection_json(const std::filesystem::path& path) {
  const Inspection file = layout::inspect_results(path);
  nlohmann::json out = {{"schema", "trunk.inspect/1"}, {"file", path.string()}, {"kind", file.kind}};
  out["file_bytes"] = file.file_bytes;
  for (const auto& [name, text] : file.heading) out[name] = text;
  out["parameters"] = to_json(file.parameters);
  for (const auto& parameter : file.fit.parameters) out["parameters"][parameter.name] = to_json(parameter);
  if (file.kind == "fit") add_fit(file.fit, out);
  out["statistics"] = to_json(file.statistics);
  out["measures"] = to_json(file.measures);
  out["runs"] = nlohmann::json::object();
  for (const auto& [status, count] : file.run_status) out["runs"][status] = count;
  out["provenance"] = nlohmann::json::object();
  for (const auto& [name, text] : file.provenance) out["provenance"][name] = text;
  out["datasets"] = nlohmann::json::array();
  for (const auto& dataset : file.datasets) {
    out["datasets"].push_back({{"path", dataset.path},
                               {"type", dataset.type},
                               {"shape", dataset.shape},
                               {"units", dataset.units},
                               {"long_name", dataset.long_name},
                               {"stored_bytes", dataset.stored_bytes}});
  }
  // Another program may have written text that is not UTF-8.
  return out.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace trunk
