// Arrows, axes, labels and lines of the 3D view.

import {
  CanvasTexture,
  ConeGeometry,
  CylinderGeometry,
  GreaterDepth,
  Group,
  Mesh,
  MeshBasicMaterial,
  Quaternion,
  Sprite,
  SpriteMaterial,
  SRGBColorSpace,
  Vector3,
} from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import { colour, onTheme } from './theme';

const up = new Vector3(0, 1, 0);

/** An arrow. Where the robot hides the arrow, it is drawn with less opacity. */
export class Arrow {
  readonly group = new Group();
  private readonly shafts: Mesh[] = [];
  private readonly heads: Mesh[] = [];
  private readonly materials: MeshBasicMaterial[];
  private readonly turn = new Quaternion();

  constructor(
    private readonly radius: number,
    colourName: string,
    opacity = 1,
  ) {
    const shaft = new CylinderGeometry(radius, radius, 1, 20).translate(0, 0.5, 0);
    const head = new ConeGeometry(2.3 * radius, 1, 28).translate(0, 0.5, 0);
    const seen = new MeshBasicMaterial({ transparent: true, opacity });
    const hidden = new MeshBasicMaterial({
      transparent: true,
      opacity: 0.7 * opacity,
      depthFunc: GreaterDepth,
      depthWrite: false,
    });
    this.materials = [seen, hidden];
    for (const material of this.materials) {
      this.shafts.push(new Mesh(shaft, material));
      this.heads.push(new Mesh(head, material));
    }
    for (const part of [...this.shafts, ...this.heads]) part.renderOrder = 3;
    this.group.add(...this.shafts, ...this.heads);
    const paint = (): void => this.materials.forEach((m) => m.color.set(colour(colourName)));
    paint();
    onTheme(paint);
  }

  /** Draws the arrow from a point along a vector; hides an arrow shorter than 1 mm. */
  set(from: Vector3, along: Vector3): void {
    const length = along.length();
    this.group.visible = length > 1e-3;
    if (!this.group.visible) return;
    const head = Math.min(6 * this.radius, 0.6 * length);
    this.group.position.copy(from);
    this.group.quaternion.copy(
      this.turn.setFromUnitVectors(up, along.clone().divideScalar(length)),
    );
    for (const shaft of this.shafts) shaft.scale.set(1, length - head, 1);
    for (const part of this.heads) {
      part.position.y = length - head;
      part.scale.set(1, head, 1);
    }
  }
}

/** A short text that faces the camera, is drawn on top, and has a constant size on the screen. */
export class Label {
  readonly sprite: Sprite;
  private readonly canvas = document.createElement('canvas');
  private readonly texture = new CanvasTexture(this.canvas);

  constructor(
    private readonly text: string,
    private readonly colourName: string,
    private readonly height = 0.019,
  ) {
    this.texture.colorSpace = SRGBColorSpace;
    const material = new SpriteMaterial({
      map: this.texture,
      depthTest: false,
      transparent: true,
      sizeAttenuation: false,
    });
    this.sprite = new Sprite(material);
    this.sprite.renderOrder = 5;
    this.paint();
    onTheme(() => this.paint());
  }

  private paint(): void {
    const context = this.canvas.getContext('2d')!;
    const font = '600 44px system-ui, sans-serif';
    context.font = font;
    this.canvas.width = Math.ceil(context.measureText(this.text).width) + 24;
    this.canvas.height = 64;
    context.font = font;
    context.textBaseline = 'middle';
    context.lineJoin = 'round';
    context.lineWidth = 10;
    context.strokeStyle = colour('stage');
    context.fillStyle = colour(this.colourName);
    context.strokeText(this.text, 12, 34);
    context.fillText(this.text, 12, 34);
    this.texture.dispose();
    this.texture.needsUpdate = true;
    this.sprite.scale.set((this.height * this.canvas.width) / 64, this.height, 1);
  }
}

/** Three thin arrows along the axes of a frame, with the names of the axes. */
export class Triad {
  readonly group = new Group();

  constructor(axes: Vector3[], names: string[], colours: string[], length: number, radius: number) {
    axes.forEach((axis, i) => {
      const arrow = new Arrow(radius, colours[i]!);
      arrow.set(new Vector3(), axis.clone().multiplyScalar(length));
      this.group.add(arrow.group);
      if (!names[i]) return;
      const label = new Label(names[i]!, colours[i]!);
      label.sprite.position.copy(axis).multiplyScalar(1.14 * length);
      this.group.add(label.sprite);
    });
  }
}

/** A line of constant width in pixels, made of separate pieces. */
export class Line {
  readonly object: LineSegments2;
  private readonly geometry = new LineSegmentsGeometry();
  private readonly material: LineMaterial;

  constructor(colourName: string, width: number, dash?: [number, number], onTop = false) {
    this.material = new LineMaterial({
      linewidth: width,
      dashed: dash !== undefined,
      dashSize: dash?.[0] ?? 1,
      gapSize: dash?.[1] ?? 1,
      transparent: true,
      depthTest: !onTop,
      depthWrite: false,
    });
    this.object = new LineSegments2(this.geometry, this.material);
    this.object.renderOrder = onTop ? 4 : 2;
    this.object.frustumCulled = false;
    const paint = (): void => void this.material.color.set(colour(colourName));
    paint();
    onTheme(paint);
  }

  /** Sets the pieces: six numbers each, the two end points. */
  setPieces(positions: Float32Array): void {
    this.object.visible = positions.length > 0;
    if (positions.length === 0) return;
    this.geometry.dispose();
    this.geometry.setPositions(positions);
    this.geometry.instanceCount = positions.length / 6;
    if (this.material.dashed) this.object.computeLineDistances();
  }

  setPoints(points: Vector3[]): void {
    const pieces = new Float32Array(6 * Math.max(points.length - 1, 0));
    for (let i = 0; i + 1 < points.length; ++i) {
      points[i]!.toArray(pieces, 6 * i);
      points[i + 1]!.toArray(pieces, 6 * i + 3);
    }
    this.setPieces(pieces);
  }

  /** Draws only this many of the first pieces. */
  upTo(pieces: number): void {
    this.object.visible = pieces > 0;
    this.geometry.instanceCount = pieces;
  }
}
