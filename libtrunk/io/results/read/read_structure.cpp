#include "results/hdf5/read.hpp"
#include "results/read/read_parts.hpp"

namespace trunk::layout {

Structure read_structure(hid_t group) {
  Structure s;
  if (!hdf5::has_link(group, "structure")) return s;
  const hdf5::Group structure = hdf5::open_group(group, "structure");
  if (hdf5::has_link(structure, "left_out")) s.left_out = hdf5::read_texts(structure, "left_out");
  if (!hdf5::has_link(structure, "choice")) return s;
  s.measures = hdf5::read_texts(structure, "measure");
  s.shares = hdf5::read_doubles(structure, "share");
  const auto names = hdf5::read_texts(structure, "choice");
  const auto texts = [&](const char* name) {
    auto all = hdf5::read_texts(structure, name);
    if (all.size() != names.size())
      throw hdf5::Error(std::string("structure/") + name + " has the wrong length");
    return all;
  };
  const auto numbers = [&](const char* name) {
    auto all = hdf5::read_doubles(structure, name);
    if (all.size() != names.size())
      throw hdf5::Error(std::string("structure/") + name + " has the wrong length");
    return all;
  };
  const auto keys = texts("keys"), unit = texts("unit"), source = texts("source");
  const auto low = numbers("low"), value = numbers("value"), high = numbers("high");
  if (s.shares.size() != names.size() * s.measures.size())
    throw hdf5::Error("structure/share has the wrong shape");
  for (std::size_t i = 0; i < names.size(); ++i)
    s.choices.push_back({names[i], keys[i], unit[i], source[i], low[i], value[i], high[i]});
  return s;
}

}  // namespace trunk::layout
