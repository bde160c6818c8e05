// Camera, lights and floor of the 3D view, which is redrawn only after a change.

import {
  Color,
  DirectionalLight,
  HemisphereLight,
  Mesh,
  PCFShadowMap,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  ShaderMaterial,
  ShadowMaterial,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { h, reducedMotion } from './dom';
import { colour, onTheme, theme } from './theme';

/** Grid with lines every 10 cm and every 1 m, which fade with the distance from the centre. */
function floorGrid(): Mesh<PlaneGeometry, ShaderMaterial> {
  const material = new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    uniforms: { tint: { value: new Color() }, strength: { value: 1 } },
    vertexShader: `
      varying vec2 at;
      void main() {
        at = position.xy;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: `
      varying vec2 at;
      uniform vec3 tint;
      uniform float strength;
      float lines(float every, float width) {
        vec2 x = at / every;
        vec2 edge = abs(fract(x - 0.5) - 0.5) / fwidth(x);
        return 1.0 - min(min(edge.x, edge.y) / width, 1.0);
      }
      void main() {
        float fade = 1.0 - smoothstep(0.8, 3.6, length(at));
        float alpha = max(0.16 * lines(0.1, 1.0), 0.45 * lines(1.0, 1.4)) * fade * strength;
        gl_FragColor = vec4(tint, alpha);
        #include <colorspace_fragment>
      }`,
  });
  const mesh = new Mesh(new PlaneGeometry(8, 8), material);
  mesh.renderOrder = -2;
  return mesh;
}

export class View3D {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(34, 1, 0.02, 60);
  readonly canvas: HTMLCanvasElement;
  readonly controls: OrbitControls;
  renderCount = 0;
  /** Called before every redraw. */
  beforeRender: () => void = () => {};
  private readonly renderer: WebGLRenderer | null = null;
  private readonly key = new DirectionalLight(0xffffff, 2.1);
  private readonly fill = new DirectionalLight(0xffffff, 0.5);
  private readonly sky = new HemisphereLight(0xffffff, 0xb9b2a8, 1.5);
  private readonly grid = floorGrid();
  private readonly shadow = new Mesh(
    new PlaneGeometry(8, 8),
    new ShadowMaterial({ opacity: 0.22 }),
  );
  private dirty = true;
  private visible = true;
  private flight: { from: Vector3[]; to: Vector3[]; start: number } | null = null;

  constructor(private readonly host: HTMLElement) {
    this.canvas = h('canvas', {
      tabindex: 0,
      role: 'img',
      'aria-label': '3D view. W, A, S, D rotate; Q and E zoom.',
    });
    host.append(this.canvas);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.maxDistance = 12;
    this.controls.minDistance = 0.08;
    this.controls.addEventListener('change', () => this.invalidate());
    this.controls.addEventListener('start', () => (this.flight = null));
    this.canvas.addEventListener('keydown', (event) => this.turn(event));
    const context = this.canvas.getContext('webgl2', {
      antialias: true,
      alpha: true,
      stencil: true,
    });
    if (!context) {
      host.append(
        h(
          'p',
          { class: 'no-webgl' },
          'The 3D view needs WebGL 2, which this browser does not offer.',
        ),
      );
      return;
    }
    this.renderer = new WebGLRenderer({ canvas: this.canvas, context });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.light();
    new ResizeObserver(() => this.resize()).observe(host);
    new IntersectionObserver((entries) => {
      this.visible = entries.some((entry) => entry.isIntersecting);
      this.invalidate();
    }).observe(host);
    onTheme(() => this.dress());
    this.dress();
    this.resize();
  }

  private light(): void {
    this.key.position.set(1.6, -2.2, 4.2);
    this.key.castShadow = true;
    this.key.shadow.mapSize.set(2048, 2048);
    this.key.shadow.radius = 3;
    this.key.shadow.bias = -0.0004;
    this.key.shadow.normalBias = 0.004;
    Object.assign(this.key.shadow.camera, {
      left: -1.6,
      right: 1.6,
      top: 1.9,
      bottom: -1.9,
      near: 0.5,
      far: 9,
    });
    this.fill.position.set(-2.5, 2, 2);
    this.sky.position.set(0, 0, 1);
    this.shadow.receiveShadow = true;
    this.shadow.renderOrder = -1;
    this.setFloor(0);
    this.key.target.position.set(0.1, -0.1, 0.7);
    this.scene.add(this.key, this.key.target, this.fill, this.sky, this.grid, this.shadow);
  }

  private dress(): void {
    const dark = theme() === 'dark';
    this.grid.material.uniforms.tint!.value.set(colour('ink'));
    this.grid.material.uniforms.strength!.value = dark ? 0.9 : 0.8;
    this.key.intensity = dark ? 1.7 : 2.1;
    this.sky.intensity = dark ? 1.1 : 1.5;
    this.invalidate();
  }

  /** Sets the height of the ground [m]. */
  setFloor(z: number): void {
    this.grid.position.z = z;
    this.shadow.position.z = z - 0.001;
    this.invalidate();
  }

  invalidate(): void {
    this.dirty = true;
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (!this.renderer || width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.invalidate();
  }

  /** Moves the camera in the direction `from` of `target` until a sphere of `radius` is visible. */
  look(target: Vector3, from: Vector3, radius: number, fly = true): void {
    const half = Math.tan((this.camera.fov * Math.PI) / 360) * Math.min(1, this.camera.aspect);
    const position = target.clone().addScaledVector(from.clone().normalize(), radius / half);
    if (!fly || reducedMotion() || !this.renderer) {
      this.camera.position.copy(position);
      this.controls.target.copy(target);
      this.controls.update();
      this.invalidate();
      return;
    }
    const from_now = [this.camera.position.clone(), this.controls.target.clone()];
    this.flight = { from: from_now, to: [position, target.clone()], start: performance.now() };
  }

  private turn(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const steps: Record<string, [number, number, number]> = {
      a: [-0.1, 0, 1],
      d: [0.1, 0, 1],
      w: [0, 0.08, 1],
      s: [0, -0.08, 1],
      q: [0, 0, 1.1],
      e: [0, 0, 1 / 1.1],
    };
    const step = steps[event.key.toLowerCase()];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    const arm = this.camera.position.clone().sub(this.controls.target);
    const length = arm.length() * step[2];
    const azimuth = Math.atan2(arm.y, arm.x) + step[0];
    const height = Math.atan2(arm.z, Math.hypot(arm.x, arm.y)) + step[1];
    const polar = Math.min(Math.max(height, -1.5), 1.5);
    arm.set(
      Math.cos(polar) * Math.cos(azimuth),
      Math.cos(polar) * Math.sin(azimuth),
      Math.sin(polar),
    );
    this.camera.position.copy(this.controls.target).addScaledVector(arm, length);
    this.controls.update();
    this.invalidate();
  }

  /** Updates the view; must be called once per frame of the browser. */
  frame(now: number): void {
    if (!this.renderer || !this.visible) return;
    if (this.flight) {
      const s = Math.min((now - this.flight.start) / 450, 1);
      const eased = s * s * (3 - 2 * s);
      this.camera.position.lerpVectors(this.flight.from[0]!, this.flight.to[0]!, eased);
      this.controls.target.lerpVectors(this.flight.from[1]!, this.flight.to[1]!, eased);
      this.controls.update();
      if (s >= 1) this.flight = null;
      this.dirty = true;
    }
    if (!this.dirty) return;
    this.dirty = false;
    this.beforeRender();
    this.renderer.render(this.scene, this.camera);
    this.renderCount += 1;
  }

  get works(): boolean {
    return this.renderer !== null;
  }
}
