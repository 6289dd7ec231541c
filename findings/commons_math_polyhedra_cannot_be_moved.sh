#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Apache Commons Math 3.6.1 (libcommons-math3-java 3.6.1-3), PolyhedronsSet: of facets and moved.
#
# Guess: a closed mesh becomes a polyhedron whatever its size, as long as the tolerance, which is given, is between the
# rounding errors and the details; a polyhedron can be moved, and keeps its volume.
# What happens: a cube can be moved and turned. Of an octahedron, two cubes, or a torus translate() and rotate() throw
# NullPointerException, though their volumes and their unions are right. A torus of 576 triangles is built if it is 60
# long or less. If it is 120 or 6000 long, or lies 1000 beside the origin, there is an IndexOutOfBoundsException or a
# NullPointerException, and in between, 600 long, one is built without a word, with a volume 2% too small. A tolerance
# 10000 times as large changes none of it.
#
# Why it matters: this is a kernel for solids that is at hand in Java, and parts in millimetres are a hundred long.
# Bodies have to be scaled and moved before they are made, and their volumes compared with those by the faces.
. "$(dirname "$0")/lib/packages.sh"
debian libcommons-math3-java=3.6.1-3 openjdk-17-jdk-headless
java=$(echo "$work"/root/usr/lib/jvm/java-17-openjdk-*)
find "$java/" -lname '*/etc/java-17-openjdk/*' | while read -r link; do
  ln -sfr "$work/root/etc/java-17-openjdk/$(readlink "$link" | sed 's|.*/etc/java-17-openjdk/||')" "$link"
done

cd "$work"
cat > Moved.java << 'END'
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import org.apache.commons.math3.geometry.euclidean.threed.Euclidean3D;
import org.apache.commons.math3.geometry.euclidean.threed.PolyhedronsSet;
import org.apache.commons.math3.geometry.euclidean.threed.Rotation;
import org.apache.commons.math3.geometry.euclidean.threed.RotationConvention;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.geometry.partitioning.Region;
import org.apache.commons.math3.geometry.partitioning.RegionFactory;

class Moved {
  static void attempt(String what, Supplier<Region<Euclidean3D>> body) {
    try {
      System.out.printf(Locale.ROOT, "%s: volume %.6g%n", what, body.get().getSize());
    } catch (RuntimeException e) {
      System.out.println(what + ": " + e.getClass().getSimpleName());
    }
  }

  static PolyhedronsSet torus(int around, int across, double scale, double x, double tolerance) {
    List<Vector3D> points = new ArrayList<>();
    List<int[]> faces = new ArrayList<>();
    for (int i = 0; i < around; ++i) {
      for (int j = 0; j < across; ++j) {
        double a = 2 * Math.PI * i / around, b = 2 * Math.PI * j / across, ring = 2 + StrictMath.cos(b);
        points.add(new Vector3D(x + scale * ring * StrictMath.cos(a), scale * ring * StrictMath.sin(a),
                                scale * StrictMath.sin(b)));
        int next = (i + 1) % around * across, other = (j + 1) % across;
        faces.add(new int[] {i * across + j, next + j, next + other});
        faces.add(new int[] {i * across + j, next + other, i * across + other});
      }
    }
    return new PolyhedronsSet(points, faces, tolerance);
  }

  public static void main(String[] arguments) {
    PolyhedronsSet cube = new PolyhedronsSet(0, 1, 0, 1, 0, 1, 1e-10);
    PolyhedronsSet octahedron = new PolyhedronsSet(
      Arrays.asList(new Vector3D(1, 0, 0), new Vector3D(-1, 0, 0), new Vector3D(0, 1, 0), new Vector3D(0, -1, 0),
                    new Vector3D(0, 0, 1), new Vector3D(0, 0, -1)),
      Arrays.asList(new int[] {0, 2, 4}, new int[] {2, 1, 4}, new int[] {1, 3, 4}, new int[] {3, 0, 4},
                    new int[] {2, 0, 5}, new int[] {1, 2, 5}, new int[] {3, 1, 5}, new int[] {0, 3, 5}), 1e-10);
    Region<Euclidean3D> cubes = new RegionFactory<Euclidean3D>().union(
      cube, new PolyhedronsSet(10, 11, 10, 11, 10, 11, 1e-10));
    Object[][] bodies = {{"cube", cube}, {"octahedron", octahedron}, {"two cubes", cubes},
                         {"torus", torus(24, 12, 1, 0, 1e-10)}};
    Rotation turn = new Rotation(new Vector3D(1, 1, 1), 0.3, RotationConvention.VECTOR_OPERATOR);
    for (Object[] b : bodies) {
      PolyhedronsSet body = (PolyhedronsSet) b[1];
      attempt(b[0] + "", () -> body);
      attempt(b[0] + ", moved", () -> body.translate(new Vector3D(1, 2, 3)));
      attempt(b[0] + ", turned", () -> body.rotate(Vector3D.ZERO, turn));
    }
    for (double tolerance : new double[] {1e-10, 1e-6}) {
      for (int scale : new int[] {10, 20, 100, 1000}) {
        attempt("torus " + 6 * scale + " long, tolerance " + tolerance, () -> torus(24, 12, scale, 0, tolerance));
      }
      for (int place : new int[] {100, 1000}) {
        attempt("torus at " + place + ", tolerance " + tolerance, () -> torus(24, 12, 1, place, tolerance));
      }
    }
  }
}
END
verdict "$("$java/bin/java" -cp "$work/root/usr/share/java/commons-math3-3.6.1.jar" Moved.java 2> java.log)" \
"cube: volume 1.00000
cube, moved: volume 1.00000
cube, turned: volume 1.00000
octahedron: volume 1.33333
octahedron, moved: NullPointerException
octahedron, turned: NullPointerException
two cubes: volume 2.00000
two cubes, moved: NullPointerException
two cubes, turned: NullPointerException
torus: volume 37.2699
torus, moved: NullPointerException
torus, turned: NullPointerException
torus 60 long, tolerance 1.0E-10: volume 37269.9
torus 120 long, tolerance 1.0E-10: IndexOutOfBoundsException
torus 600 long, tolerance 1.0E-10: volume 3.65002e+07
torus 6000 long, tolerance 1.0E-10: IndexOutOfBoundsException
torus at 100, tolerance 1.0E-10: volume 37.2699
torus at 1000, tolerance 1.0E-10: NullPointerException
torus 60 long, tolerance 1.0E-6: volume 37269.9
torus 120 long, tolerance 1.0E-6: IndexOutOfBoundsException
torus 600 long, tolerance 1.0E-6: volume 3.65002e+07
torus 6000 long, tolerance 1.0E-6: IndexOutOfBoundsException
torus at 100, tolerance 1.0E-6: volume 37.2699
torus at 1000, tolerance 1.0E-6: NullPointerException"
