// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_DRAW_CONSTRICTIONS_H
#define CGAL_DRAW_CONSTRICTIONS_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>

#include <CGAL/IO/Color.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/version.h>

#include <cstddef>
#include <iterator>
#include <vector>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/Graphics_scene.h>
#endif

#ifdef CGAL_USE_BASIC_VIEWER
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/Qt/Basic_viewer.h>
#else
#include <CGAL/Qt/Basic_viewer_qt.h>
#include <CGAL/Qt/init_ogl_context.h>
#endif
#endif

namespace CGAL {

template <class P>
class Surface_mesh;

namespace Surface_mesh_constrictions {
namespace internal {

// Of Okabe and Ito, so that people with any kind of colour vision can tell them apart.
inline IO::Color side_color(Side side)
{
  return side == Side::OBJECT       ? IO::Color(0xd5, 0x5e, 0x00)
         : side == Side::COMPLEMENT ? IO::Color(0x00, 0x72, 0xb2)
                                    : IO::Color(0x00, 0x9e, 0x73);
}

// Adds the faces of the mesh, and the curves, to what CGAL's viewer draws: a `Graphics_scene`, or before CGAL 6 the
// viewer itself.
template <class TriangleMesh, class Scene>
void add_to_scene(const TriangleMesh& tm, const std::vector<Constriction<TriangleMesh>>& constrictions, Scene& scene)
{
  const auto vpm = get(CGAL::vertex_point, tm);
  for(auto f : faces(tm))
  {
    scene.face_begin(IO::Color(0x90, 0x96, 0x9e));
    for(auto v : vertices_around_face(halfedge(f, tm), tm))
      scene.add_point_in_face(get(vpm, v));
    scene.face_end();
  }
  for(const Constriction<TriangleMesh>& c : constrictions)
  {
    std::vector<typename boost::property_traits<decltype(vpm)>::value_type> points;
    c.points(tm, std::back_inserter(points));
    for(std::size_t i = 0; i < points.size(); ++i)
      scene.add_segment(points[i], points[(i + 1) % points.size()], side_color(c.side()));
  }
}

#if defined(CGAL_USE_BASIC_VIEWER) && CGAL_VERSION_NR < 1060000000
class Constrictions_viewer : public Basic_viewer_qt
{
public:
  template <class TriangleMesh>
  Constrictions_viewer(QWidget* parent, const TriangleMesh& tm,
                       const std::vector<Constriction<TriangleMesh>>& constrictions, const char* title)
    : Basic_viewer_qt(parent, title, false, true, true, false, false)
  {
    add_to_scene(tm, constrictions, *this);
  }
};
#endif

} // namespace internal
} // namespace Surface_mesh_constrictions

#if CGAL_VERSION_NR >= 1060000000 || defined(DOXYGEN_RUNNING)
/// \ingroup PkgSurfaceMeshConstrictionsRef
/// adds the faces of a mesh, and its constrictions in the colour of what they choke, to a graphics scene (CGAL 6).
///
/// \param tm the mesh that the constrictions were computed on
/// \param constrictions its constrictions
/// \param scene is not cleared before
/// \cost linear in the size of the mesh and the curves
template <class TriangleMesh>
void add_to_graphics_scene(const TriangleMesh& tm,
                           const std::vector<Surface_mesh_constrictions::Constriction<TriangleMesh>>& constrictions,
                           Graphics_scene& scene)
{
  Surface_mesh_constrictions::internal::add_to_scene(tm, constrictions, scene);
}
#endif

#if defined(CGAL_USE_BASIC_VIEWER) || defined(DOXYGEN_RUNNING)
/// \ingroup PkgSurfaceMeshConstrictionsRef
/// opens a window that shows a mesh and its constrictions: in vermillion those that choke the object, in blue those
/// that choke the space around it, in green those that do both. Returns when the window is closed.
///
/// Needs CGAL's viewer: link with the target `CGAL::CGAL_Basic_viewer`, which defines `CGAL_USE_BASIC_VIEWER`.
///
/// \param tm the mesh that the constrictions were computed on
/// \param constrictions its constrictions
/// \param title of the window
/// \cost linear in the size of the mesh and the curves
template <class TriangleMesh>
void draw(const TriangleMesh& tm,
          const std::vector<Surface_mesh_constrictions::Constriction<TriangleMesh>>& constrictions,
          const char* title = "Constrictions")
{
#if CGAL_VERSION_NR >= 1060000000
  Graphics_scene scene;
  add_to_graphics_scene(tm, constrictions, scene);
  draw_graphics_scene(scene, title);
#else
#if defined(CGAL_TEST_SUITE)
  const bool is_test = true;
#else
  const bool is_test = qEnvironmentVariableIsSet("CGAL_TEST_SUITE");
#endif
  if(is_test)
    return;
  Qt::init_ogl_context(4, 3);
  int argc = 1;
  char name[] = "constrictions_viewer";
  char* argv[] = {name, nullptr};
  QApplication app(argc, argv);
  Surface_mesh_constrictions::internal::Constrictions_viewer window(app.activeWindow(), tm, constrictions, title);
  window.show();
  app.exec();
#endif
}

// The same, where CGAL's own functions for `Surface_mesh` would do as well as the one above.
template <class P>
void draw(const Surface_mesh<P>& sm,
          const std::vector<Surface_mesh_constrictions::Constriction<Surface_mesh<P>>>& constrictions,
          const char* title = "Constrictions")
{
  draw<Surface_mesh<P>>(sm, constrictions, title);
}
#endif

} // namespace CGAL

#endif // CGAL_DRAW_CONSTRICTIONS_H
