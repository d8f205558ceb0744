#include "report/contents.hpp"

#include <cmath>

#include "errors/input_error.hpp"

namespace trunk {

using Json = Packed::Json;

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double v : values) list.push_back(std::isfinite(v) ? Json(v) : Json(nullptr));
  return list;
}

const StoredArray& of_size(std::size_t size, const StoredArray& array, const std::string& path) {
  if (array.values.size() != size)
    throw InputError("is damaged: " + path + " has " + std::to_string(array.values.size()) +
                     " values, expected " + std::to_string(size));
  return array;
}

Json numbers_in(const StoredFile& file, const std::string& group) {
  Json list = Json::array();
  for (const std::string& name : file.datasets(group)) {
    if (file.attribute(group + "/" + name, "units").empty()) continue;  // a text
    const StoredArray number = file.array(group + "/" + name);
    if (number.shape.empty() && number.values.size() == 1)
      list.push_back({{"name", name}, {"unit", number.unit}, {"value", numbers(number.values)[0]}});
  }
  return list;
}

namespace {

Json contents_of(const StoredFile& file, const std::filesystem::path& path, std::size_t trajectory_bytes,
                 Packed& packed) {
  Json contents{{"name", path.filename().string()}, {"kind", file.kind()}};
  for (const char* name : {"title", "status", "message"}) contents[name] = file.attribute("", name);
  for (const std::string& name : file.attributes("provenance"))
    contents["provenance"][name] = file.attribute("provenance", name);
  if (file.kind() == "fit") contents["fit"] = fit_contents(file, packed);
  if (file.kind() == "sweep")
    contents["sweep"] = sweep_contents(file, packed);
  else
    contents["run"] =
        run_contents(file, file.kind() == "fit" ? "best_run/" : "", path.string(), trajectory_bytes, packed);
  return contents;
}

}  // namespace

Json file_contents(const std::filesystem::path& path, std::size_t trajectory_bytes, Packed& packed) {
  Json contents;
  read_stored(path, [&](const StoredFile& file) {
    try {
      contents = contents_of(file, path, trajectory_bytes, packed);
    } catch (const InputError& error) {
      throw InputError(path.string(), 0, error.what());
    }
  });
  return contents;
}

}  // namespace trunk
