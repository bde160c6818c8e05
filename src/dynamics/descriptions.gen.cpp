// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "dynamics/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const Quadric* /*of*/) {
  using S = Quadric;
  static const Description all =
      Describe<S>("contact", "Quadric",
                  "A curved surface, where phi(x) = x^T Q x / 2 + b^T x + c is zero, phi growing "
                  "out of the material; x is a point in the axes of the frame that the surface is"
                  " fixed in, m. References follow its normals.")
          .field("Q", &S::Q,
                 "symmetric")
          .field("b", &S::b)
          .field("c", &S::c);
  return all;
}

const Description& description_of(const SurfaceShape* /*of*/) {
  using S = SurfaceShape;
  static const Description all =
      Describe<S>("contact", "SurfaceShape",
                  "What a surface is beyond a point of it and its normal there: the lengths and "
                  "angles of a shape that touches the tangent plane at that point.")
          .field("kind", &S::kind,
                 "plane, sphere, cylinder, cone, torus, ellipsoid, saddle or ridge")
          .field("radius", &S::radius,
                 "{m}: of a sphere; of a cylinder; of a cone, from the point to its axis along "
                 "the normal; of the tube of a torus",
                 {.least = 0, .open = true})
          .field("ring", &S::ring,
                 "{m}, of the circle that the tube of a torus runs along",
                 {.least = 0, .open = true})
          .field("half_angle", &S::half_angle,
                 "{rad}, of a cone",
                 {.least = 0, .open = true})
          .field("semi_axes", &S::semi_axes,
                 "{m}, of an ellipsoid, along the tangents and the normal")
          .field("curvature", &S::curvature,
                 "{1/m}, of a saddle: its height over the tangents is (k_0 x^2 + k_1 y^2) / 2")
          .field("edge", &S::edge,
                 "{m}, of a ridge: from the point to its edge along the first tangent")
          .field("slope", &S::slope,
                 "{rad}, of a ridge: by which its second plane falls off behind the edge")
          .field("hollow", &S::hollow,
                 "the material is outside: the tool works in it, as in a bowl")
          .field("turn_deg", &S::turn_deg,
                 "by which the shape is turned about the normal, degrees");
  return all;
}

const Words& words_of(SurfaceShape::Kind /*of*/) {
  static const Words all{
      "contact",
      "SurfaceKind",
      "What a surface is beyond a point of it and its normal there.",
      {{"plane"},
       {"sphere"},
       {"cylinder", "its axis along the first tangent"},
       {"cone", "opening along the first tangent"},
       {"torus", "the outside of a ring that runs along the first tangent"},
       {"ellipsoid", "at the end of its third semi-axis"},
       {"saddle", "of any two curvatures along the tangents"},
       {"ridge", "two planes that meet in an edge across the first tangent"}}};
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
