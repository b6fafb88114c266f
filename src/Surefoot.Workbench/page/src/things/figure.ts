// A jointed humanoid, 1.83 m tall, feet at its origin, facing north (+y). It is moved by what the player does; it decides nothing.

import * as THREE from "three";
import type { Drawn } from "../net/timeline";
import { disposeMeshes, matte } from "./meshes";
import { disposeNameTag, makeNameTag } from "./nameTag";

const hipHeight = 0.93;
const thigh = 0.45;
const shin = 0.43;
const upperArm = 0.3;
const foreArm = 0.27;

/** What a figure wears. A visitor's clothes are of a colour of its own; a guard has a helmet, a spear and red. */
export type Outfit = "visitor" | "guard" | "plain";

interface Limb {
  root: THREE.Group;
  joint: THREE.Group;
}

export class Figure {
  readonly group = new THREE.Group();
  private readonly pelvis = new THREE.Group();
  private readonly chest = new THREE.Group();
  private readonly head = new THREE.Group();
  private readonly legs: [Limb, Limb];
  private readonly arms: [Limb, Limb];
  private phase = 0;
  private pace = 0;
  private air = 0;
  private crouch = 0;
  private squash = 0;
  private headingX = 0;
  private headingY = 1;
  private fallSpeed = 0;
  private wasAirborne = false;

  private readonly tag: THREE.Sprite | null;

  /**
   * @param player chooses the colours
   * @param name shown over the head; null for nothing
   * @param outfit what it wears; plain clothes are grey, to be tinted
   */
  constructor(player: number, name: string | null, outfit: Outfit = "visitor") {
    const guard = outfit === "guard";
    const hue = guard ? 0 : (0.58 + player * 0.381966) % 1;
    const saturation = outfit === "plain" ? 0 : 1;
    const cloth = matte(new THREE.Color().setHSL(hue, (guard ? 0.75 : 0.5) * saturation, guard ? 0.24 : outfit === "plain" ? 0.7 : 0.36));
    const trim = matte(new THREE.Color().setHSL(guard ? 0.11 : hue, 0.45 * saturation, guard ? 0.4 : outfit === "plain" ? 0.45 : 0.22));
    cloth.userData.tinted = trim.userData.tinted = outfit === "plain";
    const skin = matte(0xd9a37c);
    const leather = matte(0x4a3423);
    const trousers = matte(0x5b5346);
    const hair = matte(0x3a2616);
    const metal = matte(0xc8a24a);

    this.pelvis.add(part(rounded(0.31, 0.19, 0.2), trousers, 0, 0, 0.03));
    this.pelvis.add(part(rounded(0.34, 0.22, 0.07), leather, 0, 0, 0.12));
    this.pelvis.add(part(new THREE.BoxGeometry(0.07, 0.03, 0.06), metal, 0, 0.112, 0.12));
    this.pelvis.add(part(skirt(), cloth, 0, 0, 0.0));

    this.chest.position.z = 0.13;
    this.chest.add(part(rounded(0.34, 0.2, 0.24), cloth, 0, 0, 0.1));
    this.chest.add(part(rounded(0.42, 0.24, 0.28), cloth, 0, 0, 0.29));
    this.chest.add(part(rounded(0.12, 0.245, 0.32), trim, 0, 0.002, 0.25));
    this.chest.add(part(new THREE.CapsuleGeometry(0.055, 0.06, 4, 10).rotateX(Math.PI / 2), skin, 0, 0, 0.46));
    this.chest.add(part(rounded(0.26, 0.13, 0.3), leather, 0, -0.165, 0.25));
    for (const side of [-1, 1]) this.chest.add(part(new THREE.SphereGeometry(0.1, 14, 10), trim, 0.215 * side, 0, 0.37));

    this.head.position.z = 0.5;
    this.head.add(part(new THREE.SphereGeometry(0.115, 20, 16).scale(0.92, 1, 1.14), skin, 0, 0.005, 0.14));
    this.head.add(
      part(
        new THREE.SphereGeometry(0.124, 20, 16, 0, Math.PI * 2, 0, 1.75).rotateX(Math.PI / 2 + 0.5).scale(0.95, 1, 1.12),
        hair,
        0,
        -0.012,
        0.15,
      ),
    );
    this.head.add(part(new THREE.ConeGeometry(0.022, 0.05, 8), skin, 0, 0.125, 0.13));
    for (const side of [-1, 1]) this.head.add(part(new THREE.SphereGeometry(0.014, 8, 6), hair, 0.042 * side, 0.108, 0.165));
    this.chest.add(this.head);
    this.pelvis.add(this.chest);

    this.legs = [this.leg(-1, trousers, leather), this.leg(1, trousers, leather)];
    this.arms = [this.arm(-1, cloth, skin, leather), this.arm(1, cloth, skin, leather)];
    if (guard) this.giveArms(matte(0x9aa3ab), leather);
    this.pelvis.position.z = hipHeight;
    this.group.add(this.pelvis);
    this.group.traverse((one) => (one.castShadow = true));
    this.tag = name === null ? null : makeNameTag(name);
    if (this.tag) this.group.add(this.tag);
  }

  /** Poses the figure for a moment; `origin` is what drawn positions are relative to. */
  update(drawn: Drawn, origin: THREE.Vector3, seconds: number, dt: number): void {
    this.group.position.set(drawn.position.x - origin.x, drawn.position.y - origin.y, drawn.position.z - origin.z);
    this.group.rotation.z = drawn.yaw;

    const sin = Math.sin(drawn.yaw);
    const cos = Math.cos(drawn.yaw);
    const ahead = -sin * drawn.velocity.x + cos * drawn.velocity.y;
    const right = cos * drawn.velocity.x + sin * drawn.velocity.y;
    const speed = Math.hypot(ahead, right);
    const ease = (rate: number): number => 1 - Math.exp(-rate * dt);

    this.air += ((drawn.airborne ? 1 : 0) - this.air) * ease(drawn.airborne ? 9 : 16);
    this.crouch += (drawn.charge - this.crouch) * ease(18);
    if (drawn.airborne) this.fallSpeed = -drawn.velocity.z;
    else if (this.wasAirborne) this.squash = Math.min(1, Math.max(0, this.fallSpeed) / 11);
    this.wasAirborne = drawn.airborne;
    this.squash *= Math.exp(-6 * dt);

    const going = drawn.airborne ? 0 : speed;
    this.pace += (going - this.pace) * ease(14);
    if (speed > 0.2) {
      this.headingX += (right / speed - this.headingX) * ease(12);
      this.headingY += (ahead / speed - this.headingY) * ease(12);
    }
    const cycle = 1.5 + 0.24 * this.pace;
    this.phase = (this.phase + (going * dt * 2 * Math.PI) / cycle) % (2 * Math.PI);
    this.pose(seconds);
  }

  dispose(): void {
    if (this.tag) disposeNameTag(this.tag);
    disposeMeshes(this.group);
  }

  private pose(seconds: number): void {
    const moving = Math.min(1, this.pace / 2);
    const running = Math.min(1, Math.max(0, (this.pace - 2.5) / 6));
    const ground = 1 - this.air;
    const swing = (0.42 * moving + 0.42 * running) * ground;
    const breath = Math.sin(seconds * 1.7) * 0.012;
    const bend = Math.min(1, 0.62 * this.crouch * ground + 0.75 * this.squash * ground);

    for (const [index, leg] of this.legs.entries()) {
      const side = index === 0 ? -1 : 1;
      const phase = this.phase + (index === 0 ? 0 : Math.PI);
      const stride = Math.sin(phase) * swing;
      const lift = Math.max(0, Math.cos(phase)) * (0.55 * moving + 0.85 * running) * ground;
      const tuck = this.air * (index === 0 ? 0.85 : 0.25);
      leg.root.rotation.x = stride * this.headingY + 0.35 * lift * Math.max(0, this.headingY) + tuck + bend * 0.95;
      leg.root.rotation.y = -stride * this.headingX * 0.75 + side * -0.03;
      leg.joint.rotation.x = -(lift + 0.12 * moving * ground + this.air * (index === 0 ? 1.25 : 0.75) + bend * 1.9);
    }
    for (const [index, arm] of this.arms.entries()) {
      const side = index === 0 ? -1 : 1;
      const phase = this.phase + (index === 0 ? Math.PI : 0);
      arm.root.rotation.x = Math.sin(phase) * swing * 0.95 * (0.3 + 0.7 * Math.abs(this.headingY)) + 0.35 * this.air - 0.7 * bend;
      arm.root.rotation.y = side * -(0.1 + 0.85 * this.air + breath);
      arm.joint.rotation.x = 0.16 + 1.15 * running * ground + 0.5 * this.air + 0.4 * bend;
    }
    const bob = Math.abs(Math.sin(this.phase)) * (0.03 * moving + 0.04 * running) * ground;
    this.pelvis.position.z = hipHeight - (thigh + shin) * (1 - Math.cos(bend * 0.95)) * 0.98 + bob - 0.025 * moving * ground;
    this.pelvis.rotation.x = -0.17 * running * this.headingY * ground - 0.28 * bend;
    this.pelvis.rotation.y = 0.09 * running * this.headingX * ground;
    this.chest.rotation.z = Math.sin(this.phase) * 0.14 * moving * ground;
    this.chest.rotation.x = -0.05 * moving + breath - 0.15 * bend;
    this.head.rotation.x = 0.16 * running * ground + 0.3 * bend - 0.1 * this.air;
  }

  /** Helmet and spear. */
  private giveArms(steel: THREE.Material, wood: THREE.Material): void {
    this.head.add(part(new THREE.SphereGeometry(0.14, 18, 10, 0, Math.PI * 2, 0, Math.PI / 2).rotateX(Math.PI / 2), steel, 0, 0, 0.16));
    this.head.add(part(new THREE.CylinderGeometry(0.165, 0.175, 0.02, 18).rotateX(Math.PI / 2), steel, 0, 0, 0.165));
    this.head.add(part(new THREE.ConeGeometry(0.03, 0.09, 8).rotateX(Math.PI / 2), steel, 0, 0, 0.33));
    const spear = new THREE.Group();
    spear.add(part(new THREE.CylinderGeometry(0.018, 0.018, 2.2, 8).rotateX(Math.PI / 2), wood, 0, 0, 0));
    spear.add(part(new THREE.ConeGeometry(0.045, 0.22, 8).rotateX(Math.PI / 2), steel, 0, 0, 1.2));
    spear.position.set(0.34, 0.1, 0.2);
    this.pelvis.add(spear);
  }

  private leg(side: number, cloth: THREE.Material, boot: THREE.Material): Limb {
    const limb = this.limb(this.pelvis, 0.095 * side, 0, thigh, 0.082, 0.062, shin, cloth, boot);
    limb.joint.add(part(rounded(0.1, 0.25, 0.08), boot, 0, 0.055, -shin - 0.01));
    return limb;
  }

  private arm(side: number, cloth: THREE.Material, skin: THREE.Material, glove: THREE.Material): Limb {
    const limb = this.limb(this.chest, 0.235 * side, 0.37, upperArm, 0.06, 0.047, foreArm, cloth, skin);
    limb.joint.add(part(new THREE.CapsuleGeometry(0.052, 0.1, 4, 10).rotateX(Math.PI / 2), glove, 0, 0, -foreArm * 0.55));
    limb.joint.add(part(new THREE.SphereGeometry(0.055, 10, 8), skin, 0, 0, -foreArm - 0.03));
    return limb;
  }

  private limb(
    to: THREE.Group,
    x: number,
    z: number,
    upper: number,
    upperRadius: number,
    lowerRadius: number,
    lower: number,
    top: THREE.Material,
    bottom: THREE.Material,
  ): Limb {
    const root = new THREE.Group();
    const joint = new THREE.Group();
    root.position.set(x, 0, z);
    joint.position.z = -upper;
    root.add(part(bone(upperRadius, upper), top, 0, 0, -upper / 2), joint);
    joint.add(part(bone(lowerRadius, lower), bottom, 0, 0, -lower / 2));
    to.add(root);
    return { root, joint };
  }
}

function part(geometry: THREE.BufferGeometry, material: THREE.Material, x: number, y: number, z: number): THREE.Mesh {
  const mesh = new THREE.Mesh(geometry, material);
  mesh.position.set(x, y, z);
  return mesh;
}

function bone(radius: number, length: number): THREE.BufferGeometry {
  return new THREE.CapsuleGeometry(radius, length - radius * 0.8, 4, 12).rotateX(Math.PI / 2);
}

function rounded(width: number, depth: number, height: number): THREE.BufferGeometry {
  return new THREE.SphereGeometry(0.5, 18, 12).applyMatrix4(new THREE.Matrix4().makeScale(width * 1.12, depth * 1.15, height * 1.25));
}

function skirt(): THREE.BufferGeometry {
  return new THREE.CylinderGeometry(0.16, 0.205, 0.24, 18, 1, true).rotateX(Math.PI / 2).scale(1, 0.72, 1);
}
