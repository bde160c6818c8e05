// Geometry of the solids of a robot, as triangles without an index, with a colour per vertex.

import {
  BufferAttribute,
  BufferGeometry,
  CapsuleGeometry,
  Color,
  LatheGeometry,
  Matrix4,
  Quaternion,
  SphereGeometry,
  SRGBColorSpace,
  Vector2,
  Vector3,
} from 'three';
import { RoundedBoxGeometry } from 'three/examples/jsm/geometries/RoundedBoxGeometry.js';
import { mergeGeometries, toCreasedNormals } from 'three/examples/jsm/utils/BufferGeometryUtils.js';
import type { Placement, Robot, Shape, Vec3, Visual } from './data';

export function matrixOf(p: Placement): Matrix4 {
  return new Matrix4().compose(
    new Vector3(p[0], p[1], p[2]),
    new Quaternion(p[3], p[4], p[5], p[6]),
    new Vector3(1, 1, 1),
  );
}

/** Cylinder about z, with bevelled edges. */
function cylinder(radius: number, length: number): BufferGeometry {
  const edge = Math.min(0.004, 0.25 * radius, 0.25 * length);
  const half = length / 2;
  const profile = [
    [0, -half],
    [radius - edge, -half],
    [radius, -half + edge],
    [radius, half - edge],
    [radius - edge, half],
    [0, half],
  ].map(([x, y]) => new Vector2(x, y));
  const turned = new LatheGeometry(profile, 40).rotateX(Math.PI / 2);
  return toCreasedNormals(turned, 0.5);
}

function box(size: Vec3): BufferGeometry {
  const radius = Math.min(0.012, 0.22 * Math.min(...size));
  return new RoundedBoxGeometry(...size, 3, radius);
}

function mesh(vertices: Float32Array, triangles: Uint32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(vertices, 3));
  geometry.setIndex(new BufferAttribute(triangles, 1));
  return toCreasedNormals(geometry, 0.6);
}

function geometryOf(shape: Shape): BufferGeometry | null {
  switch (shape.kind) {
    case 'box':
      return box(shape.size);
    case 'cylinder':
      return cylinder(shape.radius, shape.length);
    case 'capsule':
      return new CapsuleGeometry(shape.radius, shape.length, 8, 24).rotateX(Math.PI / 2);
    case 'sphere':
      return new SphereGeometry(shape.radius, 28, 18);
    case 'mesh':
      return shape.vertices && shape.triangles ? mesh(shape.vertices, shape.triangles) : null;
  }
}

/** Geometry with positions, normals and one colour for all vertices, so that solids can be merged. */
function plain(source: BufferGeometry, matrix: Matrix4, colour: Color): BufferGeometry {
  const flat = source.index ? source.toNonIndexed() : source;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', flat.getAttribute('position').clone());
  geometry.setAttribute('normal', flat.getAttribute('normal').clone());
  geometry.applyMatrix4(matrix);
  const count = geometry.getAttribute('position').count;
  const colours = new Float32Array(3 * count);
  for (let i = 0; i < count; ++i) colour.toArray(colours, 3 * i);
  geometry.setAttribute('color', new BufferAttribute(colours, 3));
  return geometry;
}

function solidOf(visual: Visual): BufferGeometry | null {
  const geometry = geometryOf(visual.shape);
  if (!geometry) return null;
  const [r, g, b] = visual.rgba;
  return plain(geometry, matrixOf(visual.placement), new Color().setRGB(r, g, b, SRGBColorSpace));
}

export interface BodySolids {
  body: number;
  opaque: BufferGeometry | null;
  /** Translucent solids, merged, and the smallest of their opacities */
  clear: BufferGeometry | null;
  opacity: number;
}

/** Solids of a robot, merged by body. */
export function solidsOf(robot: Robot): BodySolids[] {
  const out: BodySolids[] = [];
  for (let body = -1; body < robot.bodies.length; ++body) {
    const own = robot.visuals.filter((visual) => visual.body === body);
    const merged = (some: Visual[]): BufferGeometry | null => {
      const parts = some.map(solidOf).filter((part) => part !== null);
      return parts.length > 0 ? mergeGeometries(parts) : null;
    };
    const clear = own.filter((visual) => visual.rgba[3] < 1);
    out.push({
      body,
      opaque: merged(own.filter((visual) => visual.rgba[3] >= 1)),
      clear: merged(clear),
      opacity: Math.min(1, ...clear.map((visual) => visual.rgba[3])),
    });
  }
  return out.filter((solids) => solids.opaque ?? solids.clear);
}

/** Shapes for a robot without solids: capsules between joints, and a sphere at each joint. */
export function bonesOf(robot: Robot): BodySolids[] {
  const reach = Math.max(0.1, ...robot.bodies.map((b) => Math.hypot(...b.placement.slice(0, 3))));
  const radius = Math.min(0.03, 0.08 * reach);
  const [bone, joint] = [new Color(0x8c98a4), new Color(0x4a545e)];
  const between = (a: Vector3, b: Vector3): BufferGeometry | null => {
    const along = b.clone().sub(a);
    const length = along.length();
    if (length < 2 * radius) return null;
    const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), along.normalize());
    const matrix = new Matrix4().compose(
      a.clone().add(b).multiplyScalar(0.5),
      turn,
      new Vector3(1, 1, 1),
    );
    return plain(new CapsuleGeometry(0.55 * radius, length, 6, 16), matrix, bone);
  };
  const ends = (body: number): Vector3[] => {
    const children = robot.bodies.filter((b) => b.parent === body).map((b) => b.placement);
    const frames = robot.frames.filter((f) => f.body === body).map((f) => f.placement);
    const all = children.length > 0 ? children : frames;
    return all.map((p) => new Vector3(p[0], p[1], p[2]));
  };
  const out: BodySolids[] = [];
  for (let body = -1; body < robot.bodies.length; ++body) {
    const origin = new Vector3();
    const ball = plain(new SphereGeometry(radius, 20, 14), new Matrix4(), joint);
    const bones = ends(body).map((end) => between(origin, end));
    const parts = [ball, ...bones].filter((part) => part !== null);
    out.push({ body, opaque: mergeGeometries(parts), clear: null, opacity: 1 });
  }
  return out;
}
