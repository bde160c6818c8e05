// Robot in the 3D scene: one group per body, placed by forward kinematics.

import {
  AlwaysStencilFunc,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  NotEqualStencilFunc,
  ReplaceStencilOp,
  type Material,
  type Object3D,
} from 'three';
import type { Placement, Robot } from './data';
import { forward, identity } from './kinematics';
import { bonesOf, solidsOf, type BodySolids } from './solids';

export function place(object: Object3D, p: Placement): void {
  object.position.set(p[0], p[1], p[2]);
  object.quaternion.set(p[3], p[4], p[5], p[6]);
}

/** Stencil settings of the solids of the robot. They mark its pixels, where the ghost is not drawn. */
const marksPicture = {
  stencilWrite: true,
  stencilRef: 1,
  stencilFunc: AlwaysStencilFunc,
  stencilZPass: ReplaceStencilOp,
} as const;

export const ghostMaterial = (): MeshBasicMaterial =>
  new MeshBasicMaterial({
    transparent: true,
    opacity: 0.22,
    stencilWrite: true,
    stencilRef: 1,
    stencilFunc: NotEqualStencilFunc,
  });

export class RobotModel {
  readonly group = new Group();
  /** Groups of the bodies; group 0 is the world and does not move */
  readonly bodies: Group[];
  placements: Placement[] = [];
  private readonly meshes: Mesh[] = [];

  /** With `ghost`, the robot is translucent, in one colour, and without bodies that do not move. */
  constructor(
    readonly robot: Robot,
    solids: BodySolids[],
    ghost?: MeshBasicMaterial,
  ) {
    this.bodies = [-1, ...robot.bodies.keys()].map(() => new Group());
    this.group.add(...this.bodies);
    for (const { body, opaque, clear, opacity } of solids) {
      if (ghost && body < 0) continue;
      const surface = {
        vertexColors: true,
        roughness: 0.55,
        metalness: 0.05,
        side: DoubleSide,
        ...marksPicture,
      };
      const add = (geometry: BodySolids['opaque'], material: Material): void => {
        if (!geometry) return;
        const mesh = new Mesh(geometry, material);
        mesh.castShadow = mesh.receiveShadow = !ghost;
        this.meshes.push(mesh);
        this.bodies[body + 1]!.add(mesh);
      };
      add(opaque, ghost ?? new MeshStandardMaterial(surface));
      add(clear, ghost ?? new MeshStandardMaterial({ ...surface, transparent: true, opacity }));
    }
    this.setPosture(robot.q);
  }

  setPosture(q: ArrayLike<number>): void {
    this.placements = forward(this.robot, q);
    place(this.bodies[0]!, identity());
    this.placements.forEach((p, i) => place(this.bodies[i + 1]!, p));
  }

  /** Sets the opacity of the whole robot; 1: as described. */
  setOpacity(opacity: number): void {
    for (const mesh of this.meshes) {
      const material = mesh.material as MeshStandardMaterial;
      const own = (material.userData.opacity ??= material.opacity) as number;
      material.opacity = own * opacity;
      material.transparent = material.opacity < 1;
      material.depthWrite = opacity >= 1;
      material.needsUpdate = true;
      mesh.castShadow = opacity > 0.5;
    }
  }
}

export const drawnSolids = (robot: Robot): BodySolids[] => {
  const solids = solidsOf(robot);
  return solids.length > 0 ? solids : bonesOf(robot);
};
