// Third-person camera: looks over the player's shoulder, turns with it, orbits while a button drags, comes closer with the wheel.

import * as THREE from "three";
import { wrapAngle } from "../net/timeline";
import { Button } from "../net/wire";
import { isCalm } from "./calm";

const eyeHeight = 1.45;
const clearance = 0.45;
const indoorDistance = 3.6;
const restPitch = 0.2;
const sidePitch = 0.16;
const sideDistance = 15;
const closest = 1.6;
const farthest = 90;

export class FollowCamera {
  /** The right button turns the player, and the view follows; else it orbits as the left one does. */
  rightTurns = true;
  readonly camera = new THREE.PerspectiveCamera(62, 1, 0.1, 4000);
  private distance = 6.5;
  private wantedDistance = 6.5;
  private orbit = 0;
  private pitch = restPitch;
  private yaw = Number.NaN;
  private recentering = false;
  /** The zoom to go back to after a look from the side. */
  private distanceBefore: number | null = null;
  private readonly fingers = new Map<number, { x: number; y: number }>();
  private readonly target = new THREE.Vector3();
  private height = Number.NaN;

  constructor(surface: HTMLElement) {
    this.camera.up.set(0, 0, 1);
    surface.addEventListener("pointerdown", (event) => {
      surface.setPointerCapture(event.pointerId);
      surface.classList.add("orbiting");
      if (event.pointerType === "touch") this.fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    });
    surface.addEventListener("pointermove", (event) => {
      const turns = this.rightTurns && (event.buttons & Button.Right) !== 0;
      if (this.fingers.has(event.pointerId)) this.moveFinger(event);
      else if (surface.hasPointerCapture(event.pointerId) && !turns) this.drag(event.movementX, event.movementY);
    });
    for (const end of ["pointerup", "pointercancel"] as const) {
      surface.addEventListener(end, (event) => {
        surface.classList.remove("orbiting");
        this.fingers.delete(event.pointerId);
      });
    }
    surface.addEventListener("contextmenu", (event) => event.preventDefault());
    surface.addEventListener("dblclick", () => this.recenter());
    surface.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        const lines = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? event.deltaY / 100 : event.deltaY / 3;
        this.zoomBy(Math.exp(lines * 0.14));
      },
      { passive: false },
    );
  }

  /** Angle between the view and the player's facing, radians. */
  get orbitAngle(): number {
    return this.orbit;
  }

  get zoom(): number {
    return this.wantedDistance;
  }

  /** How far the camera is from what it looks at, metres; on its way to the zoom. */
  get away(): number {
    return this.distance;
  }

  /** Swings back behind the player. */
  recenter(): void {
    this.recentering = true;
  }

  /**
   * Begins a look at a place.
   * @param from radians around the player, counter-clockwise from behind; the side is looked at from farther away
   */
  begin(from: number): void {
    const aside = from !== 0;
    if (!aside && this.distanceBefore === null) return;
    this.recentering = false;
    this.orbit = from;
    this.pitch = aside ? sidePitch : restPitch;
    if (aside) {
      this.distanceBefore ??= this.wantedDistance;
      this.distance = this.wantedDistance = Math.max(this.distanceBefore, sideDistance);
    } else {
      this.distance = this.wantedDistance = this.distanceBefore ?? this.wantedDistance;
      this.distanceBefore = null;
    }
  }

  /** Jumps instead of following, after the player was placed elsewhere. */
  cut(): void {
    this.yaw = Number.NaN;
    this.height = Number.NaN;
  }

  resize(width: number, height: number): void {
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  /**
   * @param feet the player's feet, relative to the drawing's origin
   * @param facing the player's yaw
   * @param indoors the player is in a room: the view comes close, and the ground above does not count
   * @param groundAt ground height at a point relative to the origin, or null
   */
  update(feet: THREE.Vector3, facing: number, dt: number, indoors: boolean, groundAt: (x: number, y: number) => number | null): void {
    const ease = (rate: number): number => (isCalm() ? 1 : 1 - Math.exp(-rate * dt));
    if (this.recentering) {
      this.orbit -= this.orbit * ease(7);
      this.pitch += (restPitch - this.pitch) * ease(7);
      this.recentering = Math.abs(this.orbit) > 0.005;
    }
    this.yaw = Number.isNaN(this.yaw) ? facing : this.yaw + wrapAngle(facing - this.yaw) * ease(14);
    // Heights come in steps of terrain edges; the camera glides over them, but never falls far behind a jump or a fall.
    this.height = Number.isNaN(this.height) ? feet.z : this.height + (feet.z - this.height) * ease(12);
    this.distance += ((indoors ? Math.min(this.wantedDistance, indoorDistance) : this.wantedDistance) - this.distance) * ease(10);
    this.target.set(feet.x, feet.y, this.height + eyeHeight);

    const angle = this.yaw + this.orbit;
    const flat = Math.cos(this.pitch) * this.distance;
    const eye = this.camera.position;
    eye.set(
      this.target.x + Math.sin(angle) * flat,
      this.target.y - Math.cos(angle) * flat,
      this.target.z + Math.sin(this.pitch) * this.distance,
    );
    const ground = indoors ? null : groundAt(eye.x, eye.y);
    if (ground !== null && eye.z < ground + clearance) eye.z = ground + clearance;
    this.camera.lookAt(this.target);
  }

  /** One finger looks around, two come closer or go farther. */
  private moveFinger(event: PointerEvent): void {
    const spread = (): number => {
      const [a, b] = [...this.fingers.values()];
      return Math.hypot(a.x - b.x, a.y - b.y);
    };
    const from = this.fingers.get(event.pointerId) as { x: number; y: number };
    const before = this.fingers.size === 2 ? spread() : 0;
    this.fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (this.fingers.size === 1) this.drag(event.clientX - from.x, event.clientY - from.y);
    else if (before > 0) this.zoomBy(before / Math.max(1, spread()));
  }

  private zoomBy(factor: number): void {
    this.wantedDistance = THREE.MathUtils.clamp(this.wantedDistance * factor, closest, farthest);
    this.distanceBefore = null;
  }

  private drag(dx: number, dy: number): void {
    this.recentering = false;
    this.orbit = wrapAngle(this.orbit - dx * 0.0055);
    this.pitch = THREE.MathUtils.clamp(this.pitch + dy * 0.0045, -0.5, 1.5);
  }
}
