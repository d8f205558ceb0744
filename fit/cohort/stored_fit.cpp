#include "cohort/stored_fit.hpp"

#include "errors/input_error.hpp"

namespace trunk {

std::string text_of(const StoredFit& fit, Json details) {
  details.update(to_json(fit.summary));
  details["notes"] = fit.notes;
  details["fingerprint"] = fit.fingerprint;
  return details.dump(2);
}

StoredFit stored_fit(const std::string& text, const std::filesystem::path& file) {
  try {
    const Json json = Json::parse(text);
    return {summary_from_json(json), json.at("notes").get<std::vector<std::string>>(),
            json.at("fingerprint").get<std::string>()};
  } catch (const Json::exception&) {
    throw InputError({file.string()}, "this is not the summary of a fit of this version of trunk", "",
                     "delete it together with its fit, or give --force, which fits every subject again");
  }
}

}  // namespace trunk
