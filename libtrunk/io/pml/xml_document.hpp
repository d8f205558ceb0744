#pragma once

#include <cstddef>
#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "errors/input_error.hpp"
#include "pml/attributes.hpp"

/// Private to the pml layer and io/surfaces: strict reading of small XML languages. Every error has its line.
namespace trunk::pml {

/// The longest text that is read, in bytes.
inline constexpr std::size_t largest_text = 100'000'000;

/// A parsed XML text. The text must outlive this object. The constructor throws InputError unless the text is
/// well-formed XML in UTF-8 with one outermost element and without DOCTYPE. Nothing is expanded or fetched.
class XmlDocument {
 public:
  /// Messages name the `language`, such as "PML".
  XmlDocument(std::string_view text, std::string file, std::string language);

  pugi::xml_node root() const { return document_.document_element(); }
  const std::string& language() const noexcept { return language_; }

  /// Returns the line of a node, counted from 1.
  std::size_t line(pugi::xml_node at) const;
  /// Returns the file and the line of a node.
  Place place(pugi::xml_node at) const;

  /// Throws InputError at the line of a node.
  [[noreturn]] void fail(pugi::xml_node at, std::string found, std::string expected = "",
                         std::string remedy = "") const;

  // The functions below throw InputError if the content is not as described.

  /// Returns the elements inside; throws if there is text between them.
  std::vector<pugi::xml_node> elements(pugi::xml_node parent) const;
  /// Throws if there is an element with a name that is not listed, or text between elements.
  void allow_elements(pugi::xml_node parent, std::initializer_list<std::string_view> names) const;
  /// Returns the one element of this name; throws if there is none or more than one.
  pugi::xml_node only(pugi::xml_node parent, const char* name) const;
  /// Returns the element of this name, or an empty node if there is none; throws if there is more than one.
  pugi::xml_node at_most_one(pugi::xml_node parent, const char* name) const;
  /// Returns the text inside, without white space around it; throws if there are elements.
  std::string text(pugi::xml_node parent) const;

  /// Returns all attributes except those in `but`; throws if a name occurs twice.
  Attributes attributes(pugi::xml_node at, std::initializer_list<std::string_view> but = {}) const;
  /// Throws if there is an attribute with a name that is not listed.
  void allow_attributes(pugi::xml_node at, std::initializer_list<std::string_view> names) const;
  /// Returns the value of an attribute as text, as a finite number or as an index; throws if the attribute is
  /// missing or its value is of another kind.
  std::string_view value(pugi::xml_node at, const char* name) const;
  double number(pugi::xml_node at, const char* name) const;
  std::size_t index(pugi::xml_node at, const char* name) const;

 private:
  [[noreturn]] void fail_at(std::size_t offset, std::string found, std::string expected,
                            std::string remedy) const;
  std::size_t line_at(std::size_t offset) const;
  void check_text() const;
  void parse();
  void check_top() const;

  std::string_view text_;
  std::string file_, language_;
  pugi::xml_document document_;
};

}  // namespace trunk::pml
