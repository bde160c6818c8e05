// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "dynamics/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const Quadric* /*of*/) {
  using S = Quadric;
  static const Description all =
      Describe<S>("contact", "Quadric",
                  "A curved surface: all points x with phi(x) = 0, where phi(x) = x^T Q x / 2 + "
                  "b^T x + c. phi is positive outside the material. x is a point [m] in the frame"
                  " to which the surface is fixed. The axes of a Reference can follow the normal "
                  "of the surface.")
          .field("Q", &S::Q,
                 "Matrix of the quadratic term, symmetric")
          .field("b", &S::b,
                 "Vector of the linear term")
          .field("c", &S::c,
                 "Constant term");
  return all;
}

const Description& description_of(const SurfaceShape* /*of*/) {
  using S = SurfaceShape;
  static const Description all =
      Describe<S>("contact", "SurfaceShape",
                  "Shape of a surface near a given point: kind, lengths and angles. The two axes "
                  "of the tangent plane at this point are called first and second tangent.")
          .field("kind", &S::kind,
                 "Kind of shape: plane, sphere, cylinder, cone, torus, ellipsoid, saddle or ridge")
          .field("radius", &S::radius,
                 "Radius of a sphere, cylinder, torus tube, or cone at the given point [{m}]",
                 {.least = 0, .open = true})
          .more("For a cone, the radius is the distance from the point to the axis, along the "
                "normal.")
          .field("ring", &S::ring,
                 "Radius of a torus from its centre to the middle of the tube [{m}]",
                 {.least = 0, .open = true})
          .field("half_angle", &S::half_angle,
                 "Angle between the axis and the surface of a cone [{rad}]",
                 {.least = 0, .open = true})
          .field("semi_axes", &S::semi_axes,
                 "Semi-axes of an ellipsoid, along the two tangents and the normal [{m}]")
          .field("curvature", &S::curvature,
                 "Curvatures of a saddle along the tangents [{1/m}]")
          .more("The height of the saddle is (k_0 x^2 + k_1 y^2) / 2, with the curvatures k_0 and"
                " k_1 and distances x and y along the tangents.")
          .field("edge", &S::edge,
                 "Distance from the given point to the edge of a ridge, along the first tangent "
                 "[{m}]")
          .field("slope", &S::slope,
                 "Downward slope of a ridge's second plane, behind the edge [{rad}]")
          .field("hollow", &S::hollow,
                 "Whether the material is outside the shape: the tool works inside, as in a bowl")
          .field("turn_deg", &S::turn_deg,
                 "Rotation of the shape about the normal [{degrees}]");
  return all;
}

const Words& words_of(SurfaceShape::Kind /*of*/) {
  static const Words all{
      "contact",
      "SurfaceKind",
      "Kinds of surface shapes. First and second tangent are the two axes of the tangent plane at"
      " the given point.",
      {{"plane"},
       {"sphere"},
       {"cylinder", "Cylinder with its axis along the first tangent"},
       {"cone", "Cone that opens along the first tangent"},
       {"torus", "Outside of a torus; the ring runs along the first tangent"},
       {"ellipsoid", "Ellipsoid, touched at the end of its third semi-axis"},
       {"saddle", "Surface with a given curvature along each tangent"},
       {"ridge", "Two planes that meet in an edge perpendicular to the first tangent"}}};
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
