// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_TEST_CHAINED_PARAMETERS_H
#define CONSTRICTIONS_TEST_CHAINED_PARAMETERS_H

// What is tested with the headers included in each order.

#include <CGAL/version.h>

#include <gtest/gtest.h>

namespace chained_parameters {

// Named parameters with these values, whatever the order in which they were given.
template <class NamedParameters>
void expect_values(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  EXPECT_EQ(choose_parameter(get_parameter(np, CGAL::internal_np::minimum_prominence), 0.5), 0.125);
  EXPECT_FALSE(choose_parameter(get_parameter(np, CGAL::internal_np::certify), true));
  EXPECT_EQ(choose_parameter(get_parameter(np, CGAL::internal_np::visitor), 1), 7);
  EXPECT_EQ(choose_parameter(get_parameter(np, CGAL::internal_np::vertex_index), 1), 11);
  EXPECT_EQ(choose_parameter(get_parameter(np, CGAL::internal_np::choked_side), 3), 3);
  static_assert(!CGAL::parameters::is_default_parameter<NamedParameters, CGAL::internal_np::certify_t>::value);
  static_assert(CGAL::parameters::is_default_parameter<NamedParameters, CGAL::internal_np::choked_side_t>::value);
}

inline void expect_any_order()
{
  using namespace CGAL::parameters;
  expect_values(minimum_prominence(0.125).certify(false).visitor(7).vertex_index_map(11));
  expect_values(certify(false).vertex_index_map(11).minimum_prominence(0.125).visitor(7));
  expect_values(certify(false).visitor(7).vertex_index_map(11).minimum_prominence(0.125));
  expect_values(minimum_prominence(0.125, vertex_index_map(11)).certify(false).visitor(7));
  expect_values(minimum_prominence(0.125, certify(false, visitor(7).vertex_index_map(11))));
  expect_values(minimum_prominence(0.125, certify(false).vertex_index_map(11).visitor(7)));
  // those that no function of the package takes end the chain of the package's own
  expect_values(certify(false).minimum_prominence(0.125).number_of_iterations(5).vertex_index_map(11).visitor(7));
  // of a parameter that is given twice the outer one counts
  expect_values(
      certify(true).certify(false).visitor(7).vertex_index_map(11).minimum_prominence(0.5).minimum_prominence(0.125));
#if CGAL_VERSION_NR >= 1060000000
  expect_values(vertex_index_map(11).combine(minimum_prominence(0.125), visitor(7), certify(false)));
#endif
}

} // namespace chained_parameters

#endif // CONSTRICTIONS_TEST_CHAINED_PARAMETERS_H
