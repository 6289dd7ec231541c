// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"

#include <string>

namespace constrictions {

namespace {

namespace py = pybind11;

std::string as_text(const py::handle& object) { return py::cast<std::string>(py::str(object)); }

// Elements of a kind that is not among `kinds` are refused, instead of being cut off or taken for numbers.
py::array checked_array(const py::object& values, const std::string& name, std::size_t columns,
                        const std::string& kinds, const std::string& wanted)
{
  const py::array array = py::array::ensure(values);
  if(!array)
    throw py::type_error(name + ": it is no array");
  const bool is_list = columns == 0;
  if(is_list ? array.ndim() != 1 : array.ndim() != 2 || array.shape(1) != static_cast<py::ssize_t>(columns))
    throw py::value_error(name + ": the shape is " + as_text(array.attr("shape")) + ", it must be " +
                          (is_list ? "(n,)" : "(n, " + std::to_string(columns) + ")"));
  const bool is_of_kind = kinds.find(array.dtype().kind()) != std::string::npos;
  const bool is_list_of_nothing = is_list && array.size() == 0; // numpy takes [] for doubles
  if((!is_of_kind || static_cast<std::size_t>(array.itemsize()) > sizeof(double)) && !is_list_of_nothing)
    throw py::type_error(name + ": the elements are of the type " + as_text(array.dtype()) + ", they must be " +
                         wanted);
  return array;
}

} // namespace

Double_array as_doubles(const py::object& values, const std::string& name, std::size_t columns)
{
  return Double_array::ensure(checked_array(values, name, columns, "fiu", "float64"));
}

Integer_array as_integers(const py::object& values, const std::string& name, std::size_t columns)
{
  return Integer_array::ensure(checked_array(values, name, columns, "iu", "integers"));
}

} // namespace constrictions
