// Camera and its control: flat for 1D and 2D, with perspective and orbit for 3D. z points up.
import { MOUSE, OrthographicCamera, PerspectiveCamera, TOUCH, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { SceneBox } from "./scene_interface";

const FIELD_OF_VIEW = 35;
/** Share of the canvas that the box fills. */
const FILL = 0.9;
const AXES = [new Vector3(1, 0, 0), new Vector3(0, -1, 0), new Vector3(0, 0, 1)];
const CORNER = new Vector3(0.55, -1, 0.45).normalize();

/** Upwards in the picture, for a view along a direction. */
function axisOfHeight(direction: Vector3): Vector3 {
  return Math.abs(direction.z) > 0.99 ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1);
}

export class View {
  readonly camera: OrthographicCamera | PerspectiveCamera;
  private readonly controls: OrbitControls;
  private readonly centre = new Vector3();
  private readonly size = new Vector3(1, 1, 1);
  private width = 1;
  private height = 1;
  private hasView = false;
  /**
   * Axis of the last reset as long as the reader has not moved the view; then other sizes fit it
   * anew.
   */
  private untouchedAxis: number | null = null;

  constructor(
    canvas: HTMLCanvasElement,
    private readonly isFlat: boolean,
    moved: () => void,
  ) {
    this.camera = isFlat ? new OrthographicCamera() : new PerspectiveCamera(FIELD_OF_VIEW);
    if (!isFlat) this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    if (isFlat) {
      this.controls.enableRotate = false;
      this.controls.mouseButtons.LEFT = MOUSE.PAN;
      this.controls.touches = { ONE: TOUCH.PAN, TWO: TOUCH.DOLLY_PAN };
    }
    this.controls.addEventListener("change", moved);
    this.controls.addEventListener("start", () => (this.untouchedAxis = null));
  }

  setBox(box: SceneBox): void {
    const [min, max] = [new Vector3(...box.min), new Vector3(...box.max)];
    this.centre.addVectors(min, max).multiplyScalar(0.5);
    // A single particle has no extent but its own.
    this.size.subVectors(max, min).max(new Vector3().setScalar(box.spacing));
    if (!this.hasView) this.reset(-1);
    else if (this.untouchedAxis !== null) this.reset(this.untouchedAxis);
  }

  reset(axis: number): void {
    this.hasView = true;
    this.untouchedAxis = axis;
    const radius = Math.max(0.5 * this.size.length(), 1e-12);
    if (this.camera instanceof OrthographicCamera) {
      this.camera.zoom = 1;
      this.camera.position.copy(this.centre).setZ(this.centre.z + 2 * radius);
      this.camera.near = 0.01 * radius;
      this.camera.far = 10 * radius;
    } else {
      const direction = axis < 0 ? CORNER : AXES[axis];
      const distance = this.distanceToFit(direction);
      this.camera.position.copy(this.centre).addScaledVector(direction, distance);
      // Straight from above the upward axis would have no direction.
      if (axis === 2) this.camera.position.y -= 1e-4 * distance;
      this.camera.near = distance * 0.01;
      this.camera.far = distance * 20;
    }
    this.controls.target.copy(this.centre);
    this.fit();
    this.controls.update();
  }

  lookAt(point: Vector3): void {
    this.untouchedAxis = null;
    const move = new Vector3().subVectors(point, this.controls.target);
    this.camera.position.add(move);
    this.controls.target.copy(point);
    this.controls.update();
  }

  turn(right: number, up: number): void {
    this.untouchedAxis = null;
    const arm = new Vector3().subVectors(this.camera.position, this.controls.target);
    if (this.isFlat) {
      const step = 0.1 * this.lengthOfPixel() * this.width;
      this.lookAt(this.controls.target.clone().add(new Vector3(right * step, up * step, 0)));
      return;
    }
    arm.applyAxisAngle(this.camera.up, -0.15 * right);
    const side = new Vector3().crossVectors(this.camera.up, arm).normalize();
    const tilted = arm.clone().applyAxisAngle(side, -0.15 * up);
    if (new Vector3().crossVectors(this.camera.up, tilted).length() > 0.02 * tilted.length())
      arm.copy(tilted);
    this.camera.position.addVectors(this.controls.target, arm);
    this.controls.update();
  }

  zoom(factor: number): void {
    this.untouchedAxis = null;
    if (this.camera instanceof OrthographicCamera) this.camera.zoom *= factor;
    else
      this.camera.position.sub(this.controls.target).divideScalar(factor).add(this.controls.target);
    this.camera.updateProjectionMatrix();
    this.controls.update();
  }

  resize(width: number, height: number): void {
    [this.width, this.height] = [Math.max(1, width), Math.max(1, height)];
    if (this.untouchedAxis === null) this.fit();
    else this.reset(this.untouchedAxis);
  }

  /** Distance from which all corners of the box are inside of the picture. */
  private distanceToFit(direction: Vector3): number {
    const tangent = Math.tan((FIELD_OF_VIEW * Math.PI) / 360) * FILL;
    const right = new Vector3().crossVectors(axisOfHeight(direction), direction).normalize();
    const up = new Vector3().crossVectors(direction, right);
    let distance = 0;
    for (let code = 0; code < 8; ++code) {
      const half = this.size.clone().multiplyScalar(0.5);
      const corner = half.multiply(
        new Vector3(code & 1 ? 1 : -1, code & 2 ? 1 : -1, code & 4 ? 1 : -1),
      );
      const aside = Math.abs(corner.dot(right)) / (tangent * (this.width / this.height));
      const above = Math.abs(corner.dot(up)) / tangent;
      distance = Math.max(distance, Math.max(aside, above) + corner.dot(direction));
    }
    return distance;
  }

  private fit(): void {
    const aspect = this.width / this.height;
    if (this.camera instanceof OrthographicCamera) {
      const half = Math.max(this.size.y, this.size.x / aspect, 1e-12) / (2 * FILL);
      Object.assign(this.camera, {
        left: -half * aspect,
        right: half * aspect,
        top: half,
        bottom: -half,
      });
    } else {
      this.camera.aspect = aspect;
    }
    this.camera.updateProjectionMatrix();
  }

  /** Pixels of a length of one in a flat view, in perspective of one at a distance of one. */
  pixelScale(): number {
    if (this.isFlat) return 1 / this.lengthOfPixel();
    return this.height / (2 * Math.tan((FIELD_OF_VIEW * Math.PI) / 360));
  }

  lengthOfPixel(): number {
    if (!(this.camera instanceof OrthographicCamera)) return 0;
    return (this.camera.top - this.camera.bottom) / this.camera.zoom / this.height;
  }

  update(): void {
    this.camera.updateMatrixWorld();
  }

  dispose(): void {
    this.controls.dispose();
  }
}
