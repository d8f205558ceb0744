#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace trunk::pml {

/// One attribute of an element. The user of the model gives it its meaning.
struct Attribute {
  std::string name, value;
  bool operator==(const Attribute&) const = default;
};

/// The attributes in the order of the file. No name occurs twice.
using Attributes = std::vector<Attribute>;

/// Returns the value of an attribute, or nullptr if there is none of that name.
inline const std::string* find(const Attributes& attributes, std::string_view name) {
  const auto at = std::find_if(attributes.begin(), attributes.end(),
                               [&](const Attribute& attribute) { return attribute.name == name; });
  return at == attributes.end() ? nullptr : &at->value;
}

}  // namespace trunk::pml
