#include "results/write/layout.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <cstdlib>
#include <ctime>
#include <new>
#include <stdexcept>
#include <string_view>

#include "files/replace_file.hpp"
#include "math/units.hpp"
#include "results/hdf5/image.hpp"
#include "results/hdf5_version.hpp"
#include "results/seal.hpp"

namespace trunk::layout {
namespace {

using hdf5::write_attribute;

/// Returns one pair per line: "first second", or "second  first" as `sha256sum` prints it.
std::string lines(const std::vector<std::pair<std::string, std::string>>& pairs, bool second_first) {
  std::string text;
  for (const auto& [first, second] : pairs) {
    if (!text.empty()) text += '\n';
    text += second_first ? fmt::format("{}  {}", second, first) : fmt::format("{} {}", first, second);
  }
  return text;
}

/// Returns the present time, or the time of SOURCE_DATE_EPOCH in seconds since 1970.
std::time_t creation_time() {
  const char* given = std::getenv("SOURCE_DATE_EPOCH");
  if (!given || !*given) return std::time(nullptr);
  const std::string_view text(given);
  long long seconds = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw hdf5::Error(fmt::format("SOURCE_DATE_EPOCH is '{}'; expected whole seconds since 1970", text));
  }
  return static_cast<std::time_t>(seconds);
}

std::string utc(std::time_t moment) {
  std::tm parts{};
  gmtime_r(&moment, &parts);
  std::array<char, 64> text{};
  const std::size_t size = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return {text.data(), size};
}

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

}  // namespace

void store(const std::filesystem::path& path, const std::string& kind,
           const std::function<void(hid_t root)>& fill) {
  try {
    const hdf5::Session session;
    const hdf5::Image image = hdf5::build_image([&](hid_t root) {
      write_schema(root, kind);
      fill(root);
      write_attribute(root, "complete", std::int32_t{1});
    });
    const std::string seal = seal_of(image.bytes());
    replace_file(path, image.bytes(), std::as_bytes(std::span(seal)));
  } catch (const hdf5::Error& error) {
    throw std::runtime_error(fmt::format("{}: {}", path.string(), error.what()));
  } catch (const std::bad_alloc&) {
    throw std::runtime_error(fmt::format("{}: out of memory while preparing this file", path.string()));
  }
}

void write_schema(hid_t group, const std::string& kind) {
  write_attribute(group, "schema", "trunk." + kind);
  write_attribute(group, "schema_version", schema_version(kind));
}

void write_provenance(hid_t group, const Provenance& provenance) {
  const hdf5::Group to = hdf5::create_group(group, "provenance");
  write_attribute(to, "software", "trunk");
  write_attribute(to, "version", provenance.version);
  write_attribute(to, "git_sha", provenance.git_sha);
  write_attribute(to, "git_dirty", std::int32_t{provenance.git_dirty});
  write_attribute(to, "compiler", provenance.compiler);
  write_attribute(to, "build_type", provenance.build_type);
  write_attribute(to, "hdf5_version", hdf5_version());
  write_attribute(to, "libraries", lines(provenance.libraries, false));
  write_attribute(to, "seed", provenance.seed);
  write_attribute(to, "input_sha256", lines(provenance.input_sha256, true));
  write_attribute(to, "created", utc(creation_time()));
  if (is_reproducible()) return;
  write_attribute(to, "argv", provenance.argv);
  write_attribute(to, "host", host_name());
}

void write_numbers(hid_t group, const std::vector<NamedValue>& numbers) {
  for (const NamedValue& number : numbers) {
    if (is_reproducible() && is_clock_time(number.name)) continue;
    hdf5::write_number(group, {number.name, file_unit(number.unit), ""}, number.value);
  }
}

bool is_reproducible() {
  const char* given = std::getenv("SOURCE_DATE_EPOCH");
  return given && *given;
}

bool is_clock_time(const std::string& name) {
  return name == "wall_s" || name == "latency_ms";
}

std::string file_unit(const std::string& unit) {
  const auto slash = unit.find('/');
  if (slash != std::string::npos) return unit.substr(0, slash) + " " + unit.substr(slash + 1) + "-1";
  return unit.empty() ? "1" : unit;
}

std::vector<double> to_ml(const std::vector<double>& volumes_m3) {
  std::vector<double> volumes_ml = volumes_m3;
  for (double& volume : volumes_ml) volume *= ml_per_m3;
  return volumes_ml;
}

}  // namespace trunk::layout
