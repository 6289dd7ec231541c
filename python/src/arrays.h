// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_PYTHON_ARRAYS_H
#define CONSTRICTIONS_PYTHON_ARRAYS_H

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace constrictions {

typedef pybind11::array_t<double, pybind11::array::forcecast> Double_array;
typedef pybind11::array_t<std::int64_t, pybind11::array::forcecast> Integer_array;

/// an array of numbers that can be taken as doubles. Throws a Python exception that calls the array by its name: a
/// TypeError for other elements, a ValueError for another shape. The number of columns of a list is 0.
Double_array as_doubles(const pybind11::object& values, const std::string& name, std::size_t columns);

/// as above, of integers
Integer_array as_integers(const pybind11::object& values, const std::string& name, std::size_t columns);

/// an array that nobody can change, as several share it
inline pybind11::array read_only(pybind11::array array)
{
  array.attr("setflags")(pybind11::arg("write") = false);
  return array;
}

/// an array of the numbers of a vector that lives as long as `owner`, without a copy: rows of the same length, or, with
/// 0 columns, a list
template <class T>
pybind11::array view_of(const std::vector<T>& values, std::size_t columns, const pybind11::object& owner)
{
  const pybind11::ssize_t n = static_cast<pybind11::ssize_t>(values.size());
  const pybind11::ssize_t width = static_cast<pybind11::ssize_t>(columns);
  const std::vector<pybind11::ssize_t> shape =
      columns == 0 ? std::vector<pybind11::ssize_t>{n} : std::vector<pybind11::ssize_t>{n / width, width};
  return read_only(pybind11::array_t<T>(shape, values.data(), owner));
}

/// an array that takes over the numbers of a vector, without a copy
template <class T>
pybind11::array array_of(std::vector<T> values, std::size_t columns = 0)
{
  auto numbers = std::make_unique<std::vector<T>>(std::move(values));
  const pybind11::capsule owner(numbers.get(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return view_of(*numbers.release(), columns, owner);
}

/// the object of Python that has been made of an object
template <class T>
pybind11::object owner_of(const T& object)
{
  return pybind11::cast(&object, pybind11::return_value_policy::reference);
}

} // namespace constrictions

#endif // CONSTRICTIONS_PYTHON_ARRAYS_H
