#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# lib3MF 1.8.1 (lib3mf-dev 1.8.1+ds-4), writing 3MF, and Draco 1.5.5 (draco 1.5.5+dfsg-2), draco_decoder writing OBJ
# after draco_encoder -qp 0, that is without quantization.
#
# Guess: nine significant digits, so that each float is read as it was.
# What happens: both print six decimals behind the point, whatever the size of the body. A tetrahedron of 1/3 micrometre
# in the unit metre, 3.3e-7, is written by lib3MF as four vertices at one place, and lib3MF reads that back without an
# error and calls it manifold and oriented. Draco's OBJ loses the tetrahedron as well, after a compression that was told
# to lose nothing; its PLY keeps the floats.
#
# Why it matters: 3MF and OBJ have no unit that a user is aware of, and pores or vessels in metres are this small. The
# zero-length edges that remain are a defect that the program here names, with the place.
. "$(dirname "$0")/lib/packages.sh"
debian lib3mf-dev=1.8.1+ds-4 draco=1.5.5+dfsg-2

cd "$work"
cat > write.cpp << 'END'
#define __GCC
#include <Model/COM/NMR_DLLInterfaces.h>
#include <cstdio>
#include <set>
#include <vector>

using namespace NMR;

int main()
{
  for(float size : {1.f / 3, 1e-6f / 3})
  {
    PLib3MFModel* model;
    PLib3MFModelMeshObject* mesh;
    lib3mf_createmodel(&model);
    lib3mf_model_addmeshobject(model, &mesh);
    const float points[4][3] = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
    const DWORD faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    DWORD index;
    for(const auto& p : points)
    {
      MODELMESHVERTEX vertex{{p[0], p[1], p[2]}};
      lib3mf_meshobject_addvertex(mesh, &vertex, &index);
    }
    for(const auto& f : faces)
    {
      MODELMESHTRIANGLE triangle{{f[0], f[1], f[2]}};
      lib3mf_meshobject_addtriangle(mesh, &triangle, &index);
    }
    MODELTRANSFORM identity{};
    for(int i = 0; i < 3; ++i)
      identity.m_fFields[i][i] = 1;
    PLib3MFModelBuildItem* item;
    lib3mf_model_addbuilditem(model, mesh, &identity, &item);
    PLib3MFModelWriter* writer;
    lib3mf_model_querywriter(model, "3mf", &writer);
    const bool written = lib3mf_writer_writetofileutf8(writer, "out.3mf") == 0;

    PLib3MFModel* again;
    PLib3MFModelReader* reader;
    PLib3MFModelResourceIterator* resources;
    PLib3MFModelResource* object;
    BOOL found = 0, oriented = 0;
    lib3mf_createmodel(&again);
    lib3mf_model_queryreader(again, "3mf", &reader);
    const bool read = lib3mf_reader_readfromfileutf8(reader, "out.3mf") == 0;
    lib3mf_model_getmeshobjects(again, &resources);
    lib3mf_resourceiterator_movenext(resources, &found);
    lib3mf_resourceiterator_getcurrent(resources, &object);
    std::set<std::vector<float>> places;
    for(DWORD i = 0; i < 4; ++i)
    {
      MODELMESHVERTEX v;
      lib3mf_meshobject_getvertex(object, i, &v);
      places.insert({v.m_fPosition[0], v.m_fPosition[1], v.m_fPosition[2]});
    }
    lib3mf_meshobject_ismanifoldandoriented(object, &oriented);
    std::printf("3MF, size %.9g: written %d, read %d, vertices at %zu places, the size is now %.9g, manifold %d\n",
                size, written, read, places.size(), (*places.rbegin())[0], oriented);
  }
}
END
CPLUS_INCLUDE_PATH="$work/root/usr/include/lib3mf:$CPLUS_INCLUDE_PATH" compile write 3MF
cat > draco.py << 'END'
import subprocess
import meshes

for size in (1 / 3, 1e-6 / 3):
    points, faces = meshes.tetrahedron(size)
    meshes.write_obj("in.obj", points, faces)
    for command in ("draco_encoder -i in.obj -o in.drc -qp 0", "draco_decoder -i in.drc -o out.obj"):
        subprocess.run(command.split(), check=True, stdout=subprocess.DEVNULL)
    new_points, _ = meshes.read_obj("out.obj")
    print("OBJ, size %.9g: vertices at %d places" % (size, len(set(new_points))))
END
verdict "$(./write; python3 draco.py)" \
"3MF, size 0.333333343: written 1, read 1, vertices at 4 places, the size is now 0.333332986, manifold 1
3MF, size 3.33333332e-07: written 1, read 1, vertices at 1 places, the size is now 0, manifold 1
OBJ, size 0.333333333: vertices at 4 places
OBJ, size 3.33333333e-07: vertices at 1 places"
