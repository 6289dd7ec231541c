// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/open_meshes.h"
#include "include/real_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Constriction_query.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_query_file {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace params = CGAL::Surface_mesh_constrictions::parameters;
using test_meshes::Mesh;
typedef SMC::Constriction_query<Mesh> Query;

struct No_seeds
{
  template <class OutputIterator>
  OutputIterator operator()(const SMC::Progressive_mesh&, const SMC::Seed_level&, OutputIterator out) const
  {
    return out;
  }
};

std::string file_of(const Query& query)
{
  std::ostringstream out;
  EXPECT_TRUE(query.write(out));
  return out.str();
}

template <class NamedParameters = CGAL::parameters::Default_named_parameters>
std::string refusal(const Mesh& mesh, const std::string& file,
                    const NamedParameters& np = CGAL::parameters::default_values())
{
  try
  {
    std::istringstream in(file);
    const Query query(mesh, in, np);
  }
  catch(const SMC::Invalid_query_file& e)
  {
    return e.what();
  }
  return "";
}

// All that a curve tells, with each bit of its lengths and parameters.
void describe(const SMC::Constriction<Mesh>& curve, std::ostream& out)
{
  out << curve.length() << ':';
  for(const auto& pivot : curve.pivots())
    out << ' ' << pivot.vertex;
  for(const auto& location : curve.locations())
    out << ' ' << location.parameter;
  out << '\n';
}

std::string answers(const Mesh& mesh, const Query& query)
{
  std::ostringstream out;
  out << std::hexfloat;
  std::vector<SMC::Constriction<Mesh>> curves;
  query.constrictions(std::back_inserter(curves), params::all_constrictions(true));
  for(const SMC::Constriction<Mesh>& c : curves)
    out << c.prominence() << ' ' << static_cast<int>(c.certificate().verdict) << ' ';
  const std::size_t step = mesh.number_of_vertices() / 3;
  for(std::size_t i = 0; i < mesh.number_of_vertices(); i += step)
  {
    const Mesh::Vertex_index v(static_cast<Mesh::size_type>(i));
    query.constrictions_near(mesh.point(v), std::back_inserter(curves));
    if(const auto girth = query.girth(v))
    {
      out << girth->length << ':';
      for(const auto& location : girth->locations)
        out << ' ' << location.first << ' ' << location.second[0] << ' ' << location.second[1];
      out << '\n';
    }
    std::vector<Mesh::Vertex_index> triangle;
    for(Mesh::Vertex_index w : mesh.vertices_around_face(mesh.halfedge(*mesh.faces().begin())))
      triangle.push_back(w);
    out << static_cast<int>(query.tighten(triangle).verdict) << '\n';
  }
  for(const SMC::Constriction<Mesh>& c : curves)
    describe(c, out);
  return out.str();
}

// With the checksum that belongs to it, as somebody would make it who means harm.
std::string with_checksum(std::string file)
{
  file.resize(file.size() - 8);
  SMC::internal::Fnv_hash hash;
  for(char c : file)
    hash.add_byte(static_cast<unsigned char>(c));
  for(int i = 0; i < 8; ++i)
    file.push_back(static_cast<char>(static_cast<unsigned char>(hash.value() >> (8 * i))));
  return file;
}

TEST(QueryFile, AnswersAreTheSameAfterReading)
{
  const std::vector<Mesh> meshes = {
      test_meshes::make_mesh(test_meshes::chain_of_necks(0.005, 1)), test_meshes::make_mesh(test_meshes::torus(0.1, 3)),
      test_meshes::make_mesh(open_meshes::with_random_holes(test_meshes::dumbbell(0.1, 4), 3, 1)),
      test_meshes::make_mesh(test_meshes::joined(test_meshes::boxes_with_tube(2), test_meshes::torus(0.1, 5), 30))};
  for(const Mesh& mesh : meshes)
  {
    const Query query(mesh);
    const std::string file = file_of(query);
    std::istringstream in(file);
    const Query read(mesh, in);
    EXPECT_EQ(answers(mesh, query), answers(mesh, read));
    EXPECT_EQ(file, file_of(read));
  }
}

TEST(QueryFile, TheOrderOfFacesIsKept)
{
  const Mesh mesh = real_meshes::read("cactus.off");
  SMC::internal::Query_record record;
  for(SMC::Index f = 0; f < mesh.number_of_faces(); ++f)
    record.order.push_back(static_cast<SMC::Index>(mesh.number_of_faces()) - 1 - f);
  typedef boost::property_map<Mesh, CGAL::vertex_point_t>::const_type Point_map;
  typedef SMC::internal::Prepared_surface<Mesh, Point_map> Prepared;
  Prepared reversed(mesh, get(CGAL::vertex_point, mesh), get(boost::vertex_index, mesh));
  const SMC::internal::Query_file_key key = reversed.key();
  reversed.restore(record);
  const std::pair<SMC::internal::Query_file_key, SMC::internal::Query_record> written = reversed.record();
  EXPECT_EQ(written.second.order, record.order);
  EXPECT_EQ(written.first.hash, key.hash);
}

TEST(QueryFile, AFileThatIsCutOffOrDamagedAnywhereIsRefused)
{
  SMC::internal::Query_file_key key;
  key.vertices = key.faces = 4;
  SMC::internal::Query_record record;
  record.order = {2, 0, 3, 1};
  record.collapses = {{1, 2, SMC::Progressive_mesh::Point(1, 2, 3)}};
  record.seeds = {{1, {0, 2, 3}, SMC::Seed_origin::CUT_LOCUS}};
  std::ostringstream out;
  SMC::internal::Query_file_writer(out).put(key, record);
  const std::string file = out.str();
  const auto read = [&key](const std::string& bytes) {
    std::istringstream in(bytes);
    return SMC::internal::Query_file_reader(in).get(key);
  };
  for(std::size_t size = 0; size < file.size(); ++size)
    EXPECT_THROW(read(file.substr(0, size)), SMC::Invalid_query_file) << size;
  for(std::size_t i = 0; i < file.size(); ++i)
  {
    std::string damaged = file;
    damaged[i] = static_cast<char>(damaged[i] ^ (1 << i % 8));
    EXPECT_THROW(read(damaged), SMC::Invalid_query_file) << i;
  }
  EXPECT_THROW(read(file + "x"), SMC::Invalid_query_file);
  EXPECT_EQ(read(file).seeds.front().vertices, record.seeds.front().vertices);
}

TEST(QueryFile, AFileThatWasMadeToHarmIsRefusedOrAnswers)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(2));
  const std::string file = file_of(Query(mesh));
  std::size_t refused = 0;
  for(std::size_t i = 0; i + 8 < file.size(); i += 1 + file.size() / 40)
    for(int flip : {1, 128})
    {
      std::string forged = file;
      forged[i] = static_cast<char>(forged[i] ^ flip);
      forged = with_checksum(forged);
      const std::string reason = refusal(mesh, forged);
      refused += !reason.empty();
      if(reason.empty() && flip == 1)
      {
        std::istringstream in(forged);
        const Query query(mesh, in);
        std::vector<SMC::Constriction<Mesh>> curves;
        query.constrictions(std::back_inserter(curves));
        for(const SMC::Constriction<Mesh>& c : curves)
          EXPECT_TRUE(c.certificate().verdict == SMC::Certificate_verdict::STRICT_CONSTRICTION ||
                      c.certificate().verdict == SMC::Certificate_verdict::CONSTRICTION);
      }
    }
  EXPECT_GT(refused, 0u);
}

TEST(QueryFile, AnotherMeshVersionOrParameterIsNamed)
{
  Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(2));
  const std::string file = file_of(Query(mesh));
  std::string later = file;
  later[20] = 2;
  EXPECT_EQ(refusal(mesh, later), "query file, byte 20: version 2 of the format; this is version 1");
  EXPECT_NE(refusal(mesh, "OFF\n").find("not the file of a prepared mesh"), std::string::npos);
  EXPECT_NE(refusal(mesh, file, params::seed_sources(No_seeds())).find("other parameters"), std::string::npos);
  const std::string without_seeds = file_of(Query(mesh, params::seed_sources(No_seeds())));
  EXPECT_NE(refusal(mesh, without_seeds).find("other parameters"), std::string::npos);
  EXPECT_EQ(refusal(mesh, without_seeds, params::seed_sources(No_seeds())), "");
  const Mesh other = test_meshes::make_mesh(test_meshes::torus(0.1, 3));
  EXPECT_NE(refusal(other, file).find("prepared for another mesh: it has"), std::string::npos);
  const Mesh::Vertex_index v(3);
  mesh.point(v) = mesh.point(v) + Mesh::Point::R::Vector_3(1e-9, 0, 0);
  EXPECT_NE(refusal(mesh, file).find("of other points or faces"), std::string::npos);
}

} // namespace test_query_file
