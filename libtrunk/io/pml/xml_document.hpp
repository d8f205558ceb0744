#pragma once

#include <cstddef>
#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "pml/attributes.hpp"

/// Private to the pml layer: strict reading of small XML languages, every error with its line.
namespace trunk::pml {

/// The most that is read.
inline constexpr std::size_t largest_text = 100'000'000;  // bytes

/// A parsed text that outlives it. Throws InputError unless the text is well-formed XML in UTF-8 with one
/// element at the top and without DOCTYPE: nothing is ever expanded or fetched.
class XmlDocument {
 public:
  /// `language` is named in messages: "PML".
  XmlDocument(std::string_view text, std::string file, std::string language);

  pugi::xml_node root() const { return document_.document_element(); }
  const std::string& language() const noexcept { return language_; }

  /// Of a node, counted from 1.
  std::size_t line(pugi::xml_node at) const;

  /// Throws InputError at the line of a node.
  [[noreturn]] void fail(pugi::xml_node at, const std::string& text) const;

  /// The elements inside; fails when there is text between them.
  std::vector<pugi::xml_node> elements(pugi::xml_node parent) const;
  /// Fails at the first element that is none of these, and at text between elements.
  void allow_elements(pugi::xml_node parent, std::initializer_list<std::string_view> names) const;
  /// The one element of this name; fails when there is none or a second.
  pugi::xml_node only(pugi::xml_node parent, const char* name) const;
  /// The same, or an empty node when there is none.
  pugi::xml_node at_most_one(pugi::xml_node parent, const char* name) const;
  /// The text inside, without white space around it; fails when there are elements.
  std::string text(pugi::xml_node parent) const;

  /// All attributes but these; fails when a name comes twice.
  Attributes attributes(pugi::xml_node at, std::initializer_list<std::string_view> but = {}) const;
  /// Fails when there is any attribute but these.
  void allow_attributes(pugi::xml_node at, std::initializer_list<std::string_view> names) const;
  /// The value of an attribute; fails when it is missing or anything else.
  std::string_view value(pugi::xml_node at, const char* name) const;
  double number(pugi::xml_node at, const char* name) const;
  std::size_t index(pugi::xml_node at, const char* name) const;

 private:
  [[noreturn]] void fail_at(std::size_t offset, const std::string& text) const;
  std::size_t line_at(std::size_t offset) const;
  void check_text() const;
  void parse();
  void check_top() const;

  std::string_view text_;
  std::string file_, language_;
  pugi::xml_document document_;
};

}  // namespace trunk::pml
