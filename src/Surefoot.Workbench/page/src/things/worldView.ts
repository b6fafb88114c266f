// The world as drawn: land, objects, bodies and players around one origin, and the camera that follows one's own player through them.

import * as THREE from "three";
import type { Drawn } from "../net/timeline";
import { type BodyPose, type OwnPose, PoseFlag, type ServerFrame } from "../net/wire";
import { blockOf, blockSide, isIndoors, toGlobal } from "../net/world";
import { isCalm } from "../scene/calm";
import { type Box, Cutaway } from "../scene/cutaway";
import { horizonColor, sunDirection, zenithColor } from "../scene/sky";
import { Stage } from "../scene/stage";
import { Terrain } from "../scene/terrain";
import type { Drawing } from "../scene/webgl";
import { Bodies } from "./bodies";
import { Ghosts } from "./ghosts";
import { Objects } from "./objects";
import { Players } from "./players";

/** What is seen from above: colours of the ground at global metres, and boxes around buildings or rooms. */
export interface Surroundings {
  colorAt: (x: number, y: number) => [number, number, number] | null;
  walls: { west: number; south: number; east: number; north: number; low: number; high: number }[];
}

const rebaseDistance = 4000;

/** Metres. */
const bodyHeight = 1.83;

export class WorldView {
  readonly stage: Stage;
  readonly cutaway = new Cutaway();
  readonly terrain: Terrain;
  readonly objects: Objects;
  readonly bodies = new Bodies();
  readonly ghosts = new Ghosts();
  readonly players = new Players();
  private readonly origin = new THREE.Vector3();
  private drawnTeleports = -1;
  private lookFrom: number | null = null;
  /** No land is seen from where the player is. */
  private enclosed = false;

  constructor(canvas: HTMLCanvasElement, by: Drawing) {
    this.stage = new Stage(canvas, by);
    this.terrain = new Terrain(this.stage.noise, sunDirection, horizonColor, zenithColor, this.cutaway);
    this.objects = new Objects(this.cutaway);
    this.stage.scene.add(this.terrain.group, this.objects.group, this.bodies.group, this.players.group, this.ghosts.group);
  }

  /** One's own player as drawn in the last frame. */
  get drawn(): Drawn | null {
    return this.players.me?.drawn ?? null;
  }

  get showsTriangles(): boolean {
    return this.terrain.uniforms.triangles.value > 0;
  }

  set showsTriangles(shown: boolean) {
    this.terrain.uniforms.triangles.value = shown ? 1 : 0;
  }

  get showsShapes(): boolean {
    return this.objects.showsPlain;
  }

  set showsShapes(shown: boolean) {
    this.objects.showsPlain = this.bodies.showsPlain = shown;
  }

  /** What a map shows of the world around the player. */
  get surroundings(): Surroundings {
    const { x, y } = this.origin;
    const enclosed = this.enclosed;
    const here = this.drawn?.position;
    const block = here ? (Math.floor(here.x / blockSide) << 8) | Math.floor(here.y / blockSide) : 0;
    const walls = [...this.objects.plan(block, enclosed)].map(({ min, max }) => ({
      west: min.x + x,
      south: min.y + y,
      east: max.x + x,
      north: max.y + y,
      low: min.z,
      high: max.z,
    }));
    return { colorAt: enclosed ? () => null : (east, north) => this.terrain.colorAt(east, north), walls };
  }

  /** The player goes to a place that is looked at from there; see `FollowCamera.begin`. */
  expect(lookFrom: number): void {
    this.lookFrom = lookFrom;
  }

  receive(frame: ServerFrame): void {
    switch (frame.kind) {
      case "welcome":
        this.bodies.clear();
        this.ghosts.clear();
        this.objects.moving.clear();
        this.players.enter(frame.player);
        this.drawnTeleports = -1;
        break;
      case "pose":
        this.players.receivePose(frame);
        break;
      case "others":
        this.players.receiveOthers(frame);
        break;
      case "bodies":
        this.bodies.receive(frame);
        break;
      case "truth":
        this.ghosts.receive(frame, (body) => this.bodies.find(body)?.size ?? null);
        break;
      case "moving":
        this.objects.moving.receive(frame);
        break;
    }
  }

  /**
   * Draws a moment.
   * @param time the moment, seconds of the server's clock
   * @param pose one's own player as last told; null before the first
   * @param now seconds of this page's clock
   * @param elapsed seconds since the last frame
   */
  draw(time: number, pose: OwnPose | null, now: number, elapsed: number): void {
    const dt = Math.min(elapsed, 0.1);
    if (pose) this.moveOrigin(blockOf(pose.cell));
    this.players.update(time, this.origin, now, dt);
    if (pose) this.follow(pose, now, dt);
    this.bodies.update(time, this.origin, now, dt, !this.enclosed);
    this.ghosts.update(time, this.origin, !this.enclosed);
    this.objects.moveParts(time);
    this.terrain.uniforms.time.value = this.breeze(now);
    this.stage.sky.update(this.stage.view.camera.position, this.breeze(now));
    this.stage.render(elapsed);
  }

  /**
   * The creature at a point of the picture; null without one.
   * @param x share of the picture from the left
   * @param y share of the picture from the top
   */
  creatureAt(x: number, y: number): BodyPose | null {
    const sight = new THREE.Raycaster();
    sight.setFromCamera(new THREE.Vector2(2 * x - 1, 1 - 2 * y), this.stage.view.camera);
    return this.bodies.creatureOn(sight.ray, this.origin);
  }

  /** Where in the picture a body is seen, as shares from the left and the top; null when it is not near or behind the camera. */
  onScreen(body: number): { x: number; y: number } | null {
    const pose = this.bodies.find(body);
    if (!pose) return null;
    const at = toGlobal(pose.cell, pose.position);
    const middle = new THREE.Vector3(at.x, at.y, at.z + pose.size.z / 2).sub(this.origin).project(this.stage.view.camera);
    return middle.z > 1 ? null : { x: (middle.x + 1) / 2, y: (1 - middle.y) / 2 };
  }

  /** Pixels, of a small picture of the view, in which one's own player is seen; with the cutaway, or as it would be without. */
  pixelsOfPlayer(pose: OwnPose, cut: boolean): number {
    const figure = this.players.me?.figure;
    if (!figure) return 0;
    this.cutaway.enabled = cut;
    this.cutWay(figure.group.position, pose.cell);
    const pixels = this.stage.pixelsOf(figure.group);
    this.cutaway.enabled = true;
    return pixels;
  }

  private follow(pose: OwnPose, now: number, dt: number): void {
    const { stage, terrain, origin } = this;
    const me = this.players.me;
    const block = blockOf(pose.cell);
    if (terrain.update(block)) stage.grass.invalidate();
    this.objects.update(block);
    if (!me?.drawn) return;
    if (me.drawn.teleports !== this.drawnTeleports) {
      this.drawnTeleports = me.drawn.teleports;
      stage.view.cut();
      if (this.lookFrom !== null) stage.view.begin(this.lookFrom);
      this.lookFrom = null;
      stage.grass.invalidate();
    }
    const feet = me.figure.group.position;
    const indoors = isIndoors(pose.cell);
    this.enclosed = (pose.flags & PoseFlag.Enclosed) !== 0 || (indoors && this.isBuried(feet));
    stage.enclose(this.enclosed, dt);
    terrain.group.visible = !this.enclosed;
    this.objects.seeFrom(feet, indoors, this.enclosed, dt);
    stage.showGrass(!indoors);
    if (stage.grass.mesh.visible) stage.grass.update(me.drawn.position.x, me.drawn.position.y, origin, terrain, this.breeze(now));
    stage.lights.follow(feet);
    stage.view.update(feet, me.drawn.yaw, dt, indoors, (x, y) => this.groundAt(x, y));
    stage.lights.hang(stage.view.camera.position);
    this.cutWay(feet, pose.cell);
  }

  /** Seconds of what waves, drifts and ripples. */
  private breeze(now: number): number {
    return isCalm() ? 0 : now % 3600;
  }

  private cutWay(feet: THREE.Vector3, cell: number): void {
    const indoors = isIndoors(cell);
    const block = blockOf(cell);
    this.cutaway.update(this.stage.view.camera.position, feet, indoors, this.objects.topOf(cell), this.objects.shellsAround(block));
    this.cutaway.openCellars(indoors ? this.cellarsOf(block) : []);
  }

  /** The whole of the player is under the ground. */
  private isBuried(feet: THREE.Vector3): boolean {
    const ground = this.groundAt(feet.x, feet.y);
    return ground !== null && feet.z + bodyHeight < ground;
  }

  private *cellarsOf(block: number): Iterable<Box> {
    for (const room of this.objects.roomsOf(block)) {
      const ground = this.groundAt((room.min.x + room.max.x) / 2, (room.min.y + room.max.y) / 2);
      if (ground !== null && room.min.z < ground - 1 && room.max.z < ground + 1) yield room;
    }
  }

  private groundAt(x: number, y: number): number | null {
    return this.terrain.heightAt(x + this.origin.x, y + this.origin.y);
  }

  /** Numbers on the graphics card are single: they are kept small by measuring from a landblock near the player. */
  private moveOrigin(block: number): void {
    const east = (block >> 8) * blockSide;
    const north = (block & 0xff) * blockSide;
    if (Math.hypot(east - this.origin.x, north - this.origin.y) <= rebaseDistance) return;
    this.origin.set(east, north, 0);
    this.terrain.setOrigin(block >> 8, block & 0xff);
    this.objects.setOrigin(block >> 8, block & 0xff);
    this.bodies.rebased();
    this.stage.grass.invalidate();
    this.stage.view.cut();
  }
}
