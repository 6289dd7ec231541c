// SPDX-License-Identifier: GPL-3.0-or-later
// What fuzzing has found, and what reaches most of the code with few small meshes, against an oracle that shares no code
// with the library. scripts/fuzz.sh goes on from here.
#include "include/exact_models.h"

#include "fuzz/corpus.h"
#include "fuzz/mesh_target.h"
#include "fuzz/second_witness.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test_fuzz_corpus {

using exact_models::Position;
using exact_models::Soup;

fuzz::Body body_of(const Soup& soup)
{
  fuzz::Body body;
  body.points.assign(soup.points.begin(), soup.points.end());
  for(const test_meshes::Triangle& t : soup.faces)
    body.faces.push_back({{static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2])}});
  return body;
}

std::vector<fuzz::Node> loop_of(const Soup& soup, const std::vector<Position>& positions)
{
  std::vector<fuzz::Node> result;
  for(std::size_t v : exact_models::vertices_at(soup, positions))
    result.push_back({static_cast<int>(v), -1, -1});
  return result;
}

fuzz::Oracle::Answer answer(const Soup& soup, const std::vector<Position>& positions)
{
  const fuzz::Body body = body_of(soup);
  return fuzz::Oracle(body).examine(loop_of(soup, positions));
}

TEST(FuzzOracle, KnowsModels)
{
  using fuzz::Finding;
  const Soup waist = exact_models::waist(1), tube = test_meshes::boxes_with_tube(4), box = test_meshes::box(3, 2, 2);
  const auto ring = exact_models::ring(exact_models::square(), 1, 5);
  EXPECT_EQ(answer(waist, ring).finding, Finding::STRICT);
  EXPECT_NEAR(static_cast<double>(answer(waist, ring).length), 8, 1e-14);
  EXPECT_EQ(answer(waist, exact_models::ring(exact_models::square(), 3, 0)).finding, Finding::SMALL_ANGLE);
  EXPECT_EQ(answer(waist, {ring[0], ring[1], ring[3]}).finding, Finding::NOT_CLOSED);
  EXPECT_EQ(answer(waist, {ring[0], ring[1]}).finding, Finding::SMALL_ANGLE) << "an edge to and fro";
  for(double x : {2, 3, 4, 5, 6})
    EXPECT_EQ(answer(tube, {{{x, 1, 1}}, {{x, 2, 1}}, {{x, 2, 2}}, {{x, 1, 2}}}).finding, Finding::CONSTRICTION) << x;
  EXPECT_EQ(
      answer(box,
             {{{1, 0, 0}}, {{1, 1, 0}}, {{1, 2, 0}}, {{1, 2, 1}}, {{1, 2, 2}}, {{1, 1, 2}}, {{1, 0, 2}}, {{1, 0, 1}}})
          .finding,
      Finding::LEAKS);
  std::vector<Position> twice = ring;
  twice.insert(twice.end(), ring.begin(), ring.end());
  EXPECT_EQ(answer(waist, twice).finding, Finding::NOT_SIMPLE);
}

// What the library proves is told from each other verdict.
TEST(FuzzOracle, ContradictsAWrongCertificate)
{
  namespace SMC = CGAL::Surface_mesh_constrictions;
  const Soup soup = exact_models::waist(1);
  const fuzz::Body body = body_of(soup);
  const fuzz::Mesh mesh = fuzz::mesh_of(body);
  fuzz::Tally tally;
  fuzz::Certificate_comparison comparison(body, mesh, tally);
  const auto curve = exact_models::curve_of_loop(
      mesh, exact_models::vertices_at(soup, exact_models::ring(exact_models::square(), 1, 5)));
  SMC::Certificate certificate = certify_constriction(mesh, curve);
  EXPECT_NO_THROW(comparison.compare(curve, certificate));
  for(auto wrong : {SMC::Certificate_verdict::CONSTRICTION, SMC::Certificate_verdict::LEAKY_BAND,
                    SMC::Certificate_verdict::NOT_A_CLOSED_CURVE, SMC::Certificate_verdict::NOT_STRAIGHT,
                    SMC::Certificate_verdict::ANGLE_BELOW_PI, SMC::Certificate_verdict::CROSSES_ITSELF,
                    SMC::Certificate_verdict::TOUCHES_ITSELF, SMC::Certificate_verdict::NOT_COMPUTED})
  {
    certificate.verdict = wrong;
    EXPECT_THROW(comparison.compare(curve, certificate), fuzz::Failure);
  }
  EXPECT_EQ(tally.certified, 2u);
}

// A geodesic and a curve that bends, both of pivots, are told from each other.
TEST(FuzzSecondWitness, ContradictsAWrongAnswer)
{
  const Soup soup = exact_models::waist(1);
  const fuzz::Body body = body_of(soup);
  const fuzz::Mesh mesh = fuzz::mesh_of(body);
  fuzz::Tally tally;
  fuzz::Second_witness witness(mesh, tally);
  const auto narrow = exact_models::ring(exact_models::square(), 1, 5),
             wide = exact_models::ring(exact_models::square(), 3, 0);
  const fuzz::Oracle::Answer is_geodesic = answer(soup, narrow), bends = answer(soup, wide);
  EXPECT_LT(bends.least_angle, 3);
  EXPECT_GT(is_geodesic.least_angle, 3.2);
  const auto curve_of = [&](const std::vector<Position>& positions) {
    return exact_models::curve_of_loop(mesh, exact_models::vertices_at(soup, positions));
  };
  EXPECT_NO_THROW(witness.compare(curve_of(narrow), is_geodesic));
  EXPECT_NO_THROW(witness.compare(curve_of(wide), bends));
  EXPECT_THROW(witness.compare(curve_of(narrow), bends), fuzz::Failure);
  EXPECT_THROW(witness.compare(curve_of(wide), is_geodesic), fuzz::Failure);
  EXPECT_EQ(tally.witnessed, 4u);
}

TEST(FuzzCorpus, TheOracleAgreesOnAllMeshes)
{
  fuzz::Tally tally;
  std::size_t number = 0;
  for(const std::vector<std::uint8_t>& input : fuzz::read_corpus(CONSTRICTIONS_FUZZ_CORPUS_DIR "/meshes.hex"))
  {
    EXPECT_NO_THROW(fuzz::run_mesh_target(input.data(), input.size(), tally)) << "input " << number;
    ++number;
  }
  EXPECT_GT(tally.meshes, 0u);
  EXPECT_GT(tally.certified, tally.open);
  EXPECT_GT(tally.refused, tally.open);
  EXPECT_GT(tally.witnessed, tally.meshes);
  EXPECT_GT(2 * tally.compared_selections, tally.meshes);
}

} // namespace test_fuzz_corpus
