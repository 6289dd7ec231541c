// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_PYTHON_ATTRIBUTES_H
#define CONSTRICTIONS_PYTHON_ATTRIBUTES_H

#include <pybind11/pybind11.h>

#include <vector>

namespace constrictions {

/// What Python gets to know of an object: as a property, and as a member of a dict.
template <class T>
struct Attribute
{
  const char* name;
  const char* documentation;
  pybind11::object (*get)(const T&);

  /// null if there is one value an object; else there is an array an object, and where those of an object begin, in the
  /// arrays of several objects one behind the other, is told by a member of this name
  const char* offsets = nullptr;
};

/// defines a property for each attribute, and as_dict().
template <class Class, class T>
void define_attributes(Class& its_class, const std::vector<Attribute<T>>& attributes, const char* documentation)
{
  for(const Attribute<T>& a : attributes)
    its_class.def_property_readonly(a.name, a.get, a.documentation);
  its_class.def(
      "as_dict",
      [attributes](const T& object) {
        pybind11::dict result;
        for(const Attribute<T>& a : attributes)
          result[a.name] = a.get(object);
        return result;
      },
      documentation);
}

} // namespace constrictions

#endif // CONSTRICTIONS_PYTHON_ATTRIBUTES_H
