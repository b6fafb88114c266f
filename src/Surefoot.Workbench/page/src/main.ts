// Puts the parts together and draws a frame whenever the screen is ready.

import * as THREE from "three";
import "./hud/style.css";
import { Bodies } from "./things/bodies";
import { Connection } from "./net/connection";
import { Cutaway } from "./scene/cutaway";
import { Figure } from "./things/figure";
import { Hud, type Place } from "./hud/hud";
import { Keyboard } from "./hud/keys";
import { Objects } from "./things/objects";
import { Stage } from "./scene/stage";
import { Terrain } from "./scene/terrain";
import { horizonColor, sunDirection, zenithColor } from "./scene/sky";
import { PoseTimeline, ServerClock, type Drawn } from "./net/timeline";
import { PoseFlag, type BodyPose, type Others, type OwnPose, type PlayerEvent, type ServerFrame, type Touch, type Welcome } from "./net/wire";
import { blockOf, blockSide } from "./net/world";

const rebaseDistance = 4000;

interface Player {
  timeline: PoseTimeline;
  figure: Figure;
  drawn: Drawn | null;
}

const canvas = document.getElementById("view") as HTMLCanvasElement;
const stage = new Stage(canvas);
const cutaway = new Cutaway();
const terrain = new Terrain(stage.noise, sunDirection, horizonColor, zenithColor, cutaway);
const objects = new Objects(cutaway);
const bodies = new Bodies();
const origin = new THREE.Vector3();
const others = new Map<number, Player>();
let me: Player | null = null;
let welcome: Welcome | null = null;
let pose: OwnPose | null = null;
let clock = new ServerClock(1 / 30);
let places: Place[] = [];
let touches: Touch[] = [];
let drawnTeleports = -1;
let frame = 0;
let drawnAt = 0;
const events: PlayerEvent[] = [];

const connection = new Connection(receive, (state) => {
  hud.state(state);
  if (state === "open") keyboard.releaseAll();
});
const hud = new Hud(
  {
    settings: (run, jump, burden) => connection.sendSettings(run, jump, burden),
    goto: (place) => connection.sendGoto(place),
  },
  { triangles: toggleTriangles, shapes: toggleShapes },
);
const keyboard = new Keyboard((bits) => connection.sendKeys(bits), command);

stage.scene.add(terrain.group, objects.group, bodies.group);
void loadPlaces();
connection.open();
requestAnimationFrame(draw);

function receive(message: ServerFrame): void {
  switch (message.kind) {
    case "welcome":
      enter(message);
      break;
    case "pose":
      pose = message;
      me?.timeline.push(message);
      clock.arrived(message.time, performance.now() / 1000);
      hud.showPose(message);
      break;
    case "others":
      showOthers(message);
      break;
    case "bodies":
      bodies.receive(message);
      break;
    case "touches":
      touches = message.touches;
      hud.showTouches(touches);
      break;
    case "event":
      events.push(message);
      if (events.length > 32) events.shift();
      hud.showEvent(message);
      break;
  }
}

function enter(message: Welcome): void {
  welcome = message;
  clock = new ServerClock(message.minQuantum);
  for (const id of [...others.keys()]) leave(id);
  bodies.clear();
  if (me) remove(me);
  me = add(message.player, null);
  drawnTeleports = -1;
  hud.welcome(message);
}

function showOthers(message: Others): void {
  const here = new Set(message.players.map((player) => player.player));
  for (const id of [...others.keys()]) if (!here.has(id)) leave(id);
  for (const other of message.players) {
    let player = others.get(other.player);
    if (!player) {
      player = add(other.player, `Player ${other.player}`);
      others.set(other.player, player);
    }
    player.timeline.push(other);
  }
}

function add(id: number, name: string | null): Player {
  const figure = new Figure(id, name);
  figure.group.visible = false;
  stage.scene.add(figure.group);
  return { timeline: new PoseTimeline(), figure, drawn: null };
}

function remove(player: Player): void {
  stage.scene.remove(player.figure.group);
  player.figure.dispose();
}

function leave(id: number): void {
  const player = others.get(id);
  if (player) remove(player);
  others.delete(id);
}

let lastFrame = performance.now() / 1000;

function draw(): void {
  requestAnimationFrame(draw);
  const now = performance.now() / 1000;
  const elapsed = now - lastFrame;
  const dt = Math.min(elapsed, 0.1);
  lastFrame = now;
  frame++;
  const time = clock.drawTime(now);
  drawnAt = time;
  if (me && pose) drawMe(me, pose, time, now, dt);
  for (const player of others.values()) move(player, time, now, dt);
  bodies.update(time, origin, now, dt);
  terrain.uniforms.time.value = now % 3600;
  stage.sky.update(stage.view.camera.position, now % 3600);
  stage.render(elapsed);
  if (frame % 15 === 0) hud.showFps(1 / stage.frameTime);
}

function drawMe(player: Player, last: OwnPose, time: number, now: number, dt: number): void {
  const block = blockOf(last.cell);
  if (far(block)) rebase(block);
  move(player, time, now, dt);
  if (terrain.update(block)) stage.grass.invalidate();
  const indoors = (last.cell & 0xffff) >= 0x100;
  objects.update(block);
  if (!player.drawn) return;
  if (player.drawn.teleports !== drawnTeleports) {
    drawnTeleports = player.drawn.teleports;
    stage.view.cut();
    stage.grass.invalidate();
  }
  stage.showGrass(!indoors);
  if (stage.grass.mesh.visible) stage.grass.update(player.drawn.position.x, player.drawn.position.y, origin, terrain, now % 3600);
  const feet = player.figure.group.position;
  stage.lights.follow(feet);
  stage.view.update(feet, player.drawn.yaw, dt, indoors, (x, y) => terrain.heightAt(x + origin.x, y + origin.y));
  cutWay(feet, last.cell);
  hud.showDoor(bodies.doorAt(player.drawn.position));
  hud.showCharge((last.flags & PoseFlag.Charging) !== 0, player.drawn.charge);
  if (terrain.drawn > 0) hud.uncover();
}

function cutWay(feet: THREE.Vector3, cell: number): void {
  const block = blockOf(cell);
  const indoors = (cell & 0xffff) >= 0x100;
  const ground = terrain.heightAt(feet.x + origin.x, feet.y + origin.y);
  const below = indoors && ground !== null && ground > feet.z + 0.5;
  cutaway.update(stage.view.camera.position, feet, indoors, objects.topOf(cell), below, objects.shellsAround(block));
}

function move(player: Player, time: number, now: number, dt: number): void {
  player.drawn = player.timeline.at(time);
  player.figure.group.visible = player.drawn !== null;
  if (player.drawn) player.figure.update(player.drawn, origin, now, dt);
}

function far(block: number): boolean {
  const x = (block >> 8) * blockSide - origin.x;
  const y = (block & 0xff) * blockSide - origin.y;
  return Math.hypot(x, y) > rebaseDistance;
}

/** Numbers on the graphics card are single: they are kept small by measuring from a landblock near the player. */
function rebase(block: number): void {
  origin.set((block >> 8) * blockSide, (block & 0xff) * blockSide, 0);
  terrain.setOrigin(block >> 8, block & 0xff);
  objects.setOrigin(block >> 8, block & 0xff);
  bodies.rebased();
  stage.grass.invalidate();
  stage.view.cut();
}

function toggleTriangles(): void {
  const shown = terrain.uniforms.triangles.value === 0;
  terrain.uniforms.triangles.value = shown ? 1 : 0;
  hud.showTriangles(shown);
}

function toggleShapes(): void {
  objects.showsPlain = bodies.showsPlain = !objects.showsPlain;
  hud.showShapes(objects.showsPlain);
}

function command(code: string): void {
  switch (code) {
    case "KeyT":
      toggleTriangles();
      break;
    case "KeyV":
      toggleShapes();
      break;
    case "KeyF":
      connection.sendUse();
      break;
    case "KeyC":
      stage.view.recenter();
      break;
    case "KeyP":
      hud.togglePanels();
      break;
    case "KeyH":
    case "Slash":
      hud.toggleHelp();
      break;
    case "Escape":
      hud.toggleHelp(false);
      break;
  }
}

async function loadPlaces(): Promise<void> {
  try {
    const answer = await fetch("/places.json");
    const listing = (await answer.json()) as { world: string; places: Place[] };
    places = listing.places;
    hud.listPlaces(listing.world, places);
  } catch {
    setTimeout(() => void loadPlaces(), 1000);
  }
}

// What the page shows, for tests and for the curious at the browser's console.
const inspection = {
  get ready(): boolean {
    return me?.drawn != null && terrain.drawn > 0;
  },
  get player(): number | null {
    return welcome?.player ?? null;
  },
  /** The player as drawn in the last frame: global metres, radians; `at` is the moment drawn, seconds of the server's clock. */
  get drawn(): (Drawn & { at: number }) | null {
    return me?.drawn ? { ...me.drawn, at: drawnAt } : null;
  },
  get others(): { player: number; position: { x: number; y: number; z: number } | null }[] {
    return [...others].map(([player, one]) => ({ player, position: one.drawn?.position ?? null }));
  },
  get pose(): OwnPose | null {
    return pose;
  },
  get panel(): Record<string, string> {
    return hud.panel;
  },
  get bar(): number {
    return hud.barFilled;
  },
  get events(): PlayerEvent[] {
    return [...events];
  },
  get places(): Place[] {
    return places;
  },
  get frames(): number {
    return frame;
  },
  get messages(): number {
    return connection.frames;
  },
  get fps(): number {
    return 1 / stage.frameTime;
  },
  get blocks(): number {
    return terrain.drawn;
  },
  get shapes(): number {
    return objects.triangles;
  },
  /** The bodies near by that are no players, as last told. */
  get bodies(): BodyPose[] {
    return bodies.poses;
  },
  get touches(): Touch[] {
    return touches;
  },
  /** What is drawn: people of the crowd, plants, how far a door near by is swung open (0 to 1). */
  get drawnThings(): { crowd: number; plants: number; door: number | null } {
    return { crowd: bodies.crowdCount, plants: objects.plantCount, door: bodies.doorOpened };
  },
  /** What is cut away: 1 the shell around the player, 2 the building around the camera; floors from this height on. */
  get cut(): { opens: number; ceiling: number } {
    return { opens: cutaway.opens, ceiling: cutaway.ceiling };
  },
  /** Pixels, of a small picture of the view, in which the player is seen; with the cutaway, or as it would be without. */
  seen(cut: boolean): number {
    if (!me || !pose) return 0;
    cutaway.enabled = cut;
    cutWay(me.figure.group.position, pose.cell);
    const pixels = stage.pixelsOf(me.figure.group);
    cutaway.enabled = true;
    return pixels;
  },
  get plainShapes(): boolean {
    return objects.showsPlain;
  },
  get triangles(): boolean {
    return terrain.uniforms.triangles.value > 0;
  },
  get camera(): { orbit: number; zoom: number; away: number } {
    return { orbit: stage.view.orbitAngle, zoom: stage.view.zoom, away: stage.view.away };
  },
  sendRaw(bytes: number[]): void {
    connection.sendRaw(new Uint8Array(bytes).buffer);
  },
};

declare global {
  interface Window {
    surefoot: typeof inspection;
  }
}

window.surefoot = inspection;
