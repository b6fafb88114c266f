// What the page shows, as `window.surefoot`: for tests, and for the curious at the browser's console.

import type { Connection } from "../net/connection";
import type { Place } from "../net/places";
import type { Requests } from "../net/requests";
import type { Session } from "../net/session";
import type { Drawn } from "../net/timeline";
import type { WalkPath } from "../net/walk";
import type { BodyPose, OwnPose, PlayerEvent, Touch, Vec3 } from "../net/wire";
import type { MovingDrawn } from "../things/objects";
import type { WorldView } from "../things/worldView";
import type { CoverState } from "./cover";
import type { Hud } from "./hud";

/** What the page counts of its own drawing. */
export interface Frames {
  /** Frames drawn. */
  count: number;
  /** The moment drawn last, seconds of the server's clock. */
  drawnAt: number;
}

export class Inspection {
  constructor(
    private readonly world: WorldView,
    private readonly session: Session,
    private readonly hud: Hud,
    private readonly connection: Connection,
    private readonly requests: Requests,
    private readonly way: WalkPath,
    private readonly drawing: Readonly<Frames>,
  ) {}

  /** The player stands where it wants to be, on land that is drawn, and nothing covers it. */
  get ready(): boolean {
    return this.world.drawn !== null && this.world.terrain.drawn > 0 && this.covered === null;
  }

  /** Why the world is covered, or null. */
  get covered(): CoverState | null {
    return this.hud.cover.shown;
  }

  /** The line that stays until it is put away; empty without one. */
  get notice(): string {
    return this.hud.notice.shown;
  }

  get player(): number | null {
    return this.session.welcome?.player ?? null;
  }

  /** The player as drawn in the last frame: global metres, radians; `at` is the moment drawn, seconds of the server's clock. */
  get drawn(): (Drawn & { at: number }) | null {
    return this.world.drawn && { ...this.world.drawn, at: this.drawing.drawnAt };
  }

  get others(): { player: number; position: Vec3 | null }[] {
    return [...this.world.players.others].map(([player, one]) => ({ player, position: one.drawn?.position ?? null }));
  }

  /** Keys play, and belong to no control. */
  get playing(): boolean {
    return this.hud.focus.playing;
  }

  get pose(): OwnPose | null {
    return this.session.pose;
  }

  get panel(): Record<string, string> {
    return this.hud.panel.texts;
  }

  get bar(): number {
    return this.hud.barFilled;
  }

  get events(): PlayerEvent[] {
    return [...this.session.events];
  }

  get places(): readonly Place[] {
    return this.hud.goTo.listed;
  }

  get frames(): number {
    return this.drawing.count;
  }

  get messages(): number {
    return this.connection.frames;
  }

  /** The moment drawn last, seconds of the server's clock. */
  get drawnAt(): number {
    return this.drawing.drawnAt;
  }

  /** Seconds of what waves, drifts and ripples; 0 for who asks for less motion. */
  get breeze(): number {
    return this.world.terrain.uniforms.time.value;
  }

  /** 1 where no land is seen and a lantern lights the way, 0 outdoors. */
  get dark(): number {
    return this.world.stage.darkness;
  }

  /** The last walk: its way from above, how wide the map is, metres. */
  get walk(): { path: readonly Vec3[]; metres: number; across: number } {
    const { path, metres } = this.way;
    return { path, metres, across: this.hud.map.metresAcross };
  }

  get fps(): number {
    return 1 / this.world.stage.frameTime;
  }

  get blocks(): number {
    return this.world.terrain.drawn;
  }

  get shapes(): number {
    return this.world.objects.triangles;
  }

  /** The bodies near by that are no players, as last told. */
  get bodies(): BodyPose[] {
    return this.world.bodies.poses;
  }

  /** Where others are in truth, as drawn; empty when that is not shown. */
  get ghosts(): { body: number; position: Vec3 | null }[] {
    return this.world.ghosts.places;
  }

  /** The creature that is chosen, or null. */
  get creature(): number | null {
    return this.hud.creature.chosen;
  }

  /** Where a body is seen: shares of the picture from the left and the top. */
  onScreen(body: number): { x: number; y: number } | null {
    return this.world.onScreen(body);
  }

  get touches(): Touch[] {
    return this.session.touches;
  }

  /** What is drawn: people of the crowd, plants, how far a door near by is swung open (0 to 1). */
  get drawnThings(): { crowd: number; plants: number; door: number | null } {
    return { crowd: this.world.bodies.crowdCount, plants: this.world.objects.plantCount, door: this.world.bodies.doorOpened };
  }

  /** The parts drawn that animations move. */
  get moving(): MovingDrawn[] {
    return this.world.objects.movingDrawn;
  }

  /** What is cut away: 1 the shell around the player, 2 the building around the camera; floors from this height on. */
  get cut(): { opens: number; ceiling: number } {
    return { opens: this.world.cutaway.opens, ceiling: this.world.cutaway.ceiling };
  }

  /** Pixels, of a small picture of the view, in which the player is seen; with the cutaway, or as it would be without. */
  seen(cut: boolean): number {
    return this.session.pose ? this.world.pixelsOfPlayer(this.session.pose, cut) : 0;
  }

  /** The view as a small picture: red, green and blue of each pixel, 0 to 255, row by row from the top. */
  picture(width: number, height: number): [number, number, number][][] {
    const pixels = this.world.stage.picture(width, height);
    const at = (x: number, y: number): number => 4 * ((height - 1 - y) * width + x);
    const row = (y: number): [number, number, number][] =>
      Array.from({ length: width }, (_, x) => [pixels[at(x, y)], pixels[at(x, y) + 1], pixels[at(x, y) + 2]]);
    return Array.from({ length: height }, (_, y) => row(y));
  }

  get plainShapes(): boolean {
    return this.world.showsShapes;
  }

  get triangles(): boolean {
    return this.world.showsTriangles;
  }

  /** The right button turns the player. */
  get mouseTurning(): boolean {
    return this.world.stage.view.rightTurns;
  }

  get camera(): { orbit: number; zoom: number; away: number } {
    const { view } = this.world.stage;
    return { orbit: view.orbitAngle, zoom: view.zoom, away: view.away };
  }

  sendRaw(bytes: number[]): void {
    this.requests.raw(new Uint8Array(bytes).buffer);
  }
}

declare global {
  interface Window {
    surefoot: Inspection;
  }
}
