// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_READ_XML_H
#define CONSTRICTIONS_READ_XML_H

#include "input/input_file.h"

#include <optional>
#include <string>
#include <string_view>

namespace constrictions {

/// An element of XML where it begins. The name of an element or attribute in a namespace has that in front, with a blank
/// between the two.
class Xml_element
{
public:
  /// \param attributes names and values in turn, and a null pointer at the end
  Xml_element(const char* name, const char** attributes) : m_name(name), m_attributes(attributes) {}

  std::string_view name() const { return m_name; }

  /// nothing if it has no attribute of that name
  std::optional<std::string_view> attribute(std::string_view name) const
  {
    for(const char** a = m_attributes; *a != nullptr; a += 2)
      if(name == a[0])
        return a[1];
    return std::nullopt;
  }

private:
  std::string_view m_name;
  const char** m_attributes;
};

/// Thrown by a handler; becomes an `Input_file_error` with the place in the file.
struct Xml_failure
{
  std::string reason;
};

/// What is called while XML is read.
class Xml_handler
{
public:
  virtual ~Xml_handler() = default;

  virtual void begin(const Xml_element& element) = 0;
  virtual void end(std::string_view name) = 0;

  /// a piece of the text between
  virtual void text(std::string_view) {}
};

/// reads XML from the beginning of a text, in memory that does not grow with its length.
/// \param file what the text belongs to
/// \param place what messages call it inside the file, such as "part of it, "; may be empty
/// \param is_whole whether all elements must end in the text
///
/// Throws `Input_file_error` with the number of the line for what is not XML, and for what a handler throws; and without
/// it if the program was built without a reader of XML.
void read_xml(const Input_file& file, std::string_view text, const std::string& place, bool is_whole,
              Xml_handler& handler);

} // namespace constrictions

#endif // CONSTRICTIONS_READ_XML_H
