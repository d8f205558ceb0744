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

std::string print_fitted(const std::vector<FitRecord::Parameter>& parameters) {
  if (parameters.empty()) return "";
  std::string out = "parameters: best, standard error, 95 % interval\n";
  for (const auto& parameter : parameters) {
    out += fmt::format("  {:<24} {:>12.6g}", without_controls(parameter.name), parameter.best);
    if (!parameter.free && !parameter.beside)
      out += " fixed";
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

}  // namespace

std::string inspection_text(const std::filesystem::path& path) {
  const Inspection file = layout::inspect_results(path);
  return fmt::format("{}: a {}, {}\n", path.string(), file.kind, file_size(file.file_bytes)) +
         print_texts("", file.heading) + print_runs(file.run_status) + print_fitted(file.fitted) +
         print_numbers("parameters", file.parameters) + print_numbers("statistics", file.statistics) +
         print_numbers("measures", file.measures) + print_texts("made by\n", file.provenance) +
         print_datasets(file);
}

std::string inspection_json(const std::filesystem::path& path) {
  const Inspection file = layout::inspect_results(path);
  nlohmann::json out = {{"schema", "trunk.inspect/1"}, {"file", path.string()}, {"kind", file.kind}};
  out["file_bytes"] = file.file_bytes;
  for (const auto& [name, text] : file.heading) out[name] = text;
  out["parameters"] = to_json(file.parameters);
  for (const auto& parameter : file.fitted) out["parameters"][parameter.name] = to_json(parameter);
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
