#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace trunk::pml {

/// One attribute of an element; what it means is up to whoever uses the model.
struct Attribute {
  std::string name, value;
  bool operator==(const Attribute&) const = default;
};

/// In the order of the file; no name occurs twice.
using Attributes = std::vector<Attribute>;

/// The value of an attribute, nullptr without it.
inline const std::string* find(const Attributes& attributes, std::string_view name) {
  const auto at = std::find_if(attributes.begin(), attributes.end(),
                               [&](const Attribute& attribute) { return attribute.name == name; });
  return at == attributes.end() ? nullptr : &at->value;
}

}  // namespace trunk::pml
