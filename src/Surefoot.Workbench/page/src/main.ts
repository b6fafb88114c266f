// Puts the parts together and draws a frame whenever the screen is ready.

import "./hud/style.css";
import { commands } from "./hud/commands";
import { Hud } from "./hud/hud";
import { type Frames, Inspection } from "./hud/inspection";
import { Keyboard } from "./hud/keys";
import { LeftOutPanel } from "./hud/leftOut";
import { Pointer } from "./hud/pointer";
import { Connection } from "./net/connection";
import { fetchPlaces } from "./net/places";
import { Session } from "./net/session";
import { PoseFlag, type ServerFrame } from "./net/wire";
import { WorldView } from "./things/worldView";

const session = new Session();
const surface = document.getElementById("view") as HTMLCanvasElement;
const world = new WorldView(surface);
const drawing: Frames = { count: 0, drawnAt: 0 };

const connection = new Connection(receive, (state) => {
  hud.state(state);
  if (state !== "open") return;
  keyboard.releaseAll();
  connection.sendMouseTurning(pointer.turnsPlayer);
});
const hud = new Hud(
  {
    settings: (run, jump, burden) => connection.sendSettings(run, jump, burden),
    goto: (place) => connection.sendGoto(place),
  },
  { triangles: toggleTriangles, shapes: toggleShapes, mouse: toggleMouse },
);
const keyCommands = commands({
  triangles: toggleTriangles,
  shapes: toggleShapes,
  use: () => connection.sendUse(),
  autoRun: () => connection.sendAutoRun(),
  mouse: toggleMouse,
  recenter: () => world.stage.view.recenter(),
  panels: () => hud.togglePanels(),
  help: (shown) => hud.toggleHelp(shown),
});
const keyboard = new Keyboard(
  (bits) => connection.sendKeys(bits),
  () => connection.sendFocusLost(),
  (code) => keyCommands.get(code)?.(),
);
const leftOut = new LeftOutPanel();
const pointer = new Pointer(surface, (buttons, right) => connection.sendPointer(buttons, right));

window.surefoot = new Inspection(world, session, hud, connection, drawing);
void fetchPlaces().then((listing) => hud.listPlaces(listing.world, listing.places));
connection.open();
requestAnimationFrame(draw);

function receive(frame: ServerFrame): void {
  session.receive(frame, performance.now() / 1000);
  world.receive(frame);
  hud.receive(frame);
  if (frame.kind === "pose") leftOut.enter(frame.cell);
}

let lastFrame = performance.now() / 1000;

function draw(): void {
  requestAnimationFrame(draw);
  const now = performance.now() / 1000;
  const elapsed = now - lastFrame;
  lastFrame = now;
  drawing.count++;
  drawing.drawnAt = session.clock.drawTime(now);
  world.draw(drawing.drawnAt, session.pose, now, elapsed);
  showNear();
  if (drawing.count % 15 === 0) hud.showFps(1 / world.stage.frameTime);
}

/** What depends on where the player is drawn. */
function showNear(): void {
  const { drawn } = world;
  if (!drawn || !session.pose) return;
  hud.showDoor(world.bodies.doorAt(drawn.position));
  hud.showCharge((session.pose.flags & PoseFlag.Charging) !== 0, drawn.charge);
  if (world.terrain.drawn > 0) hud.uncover();
}

function toggleTriangles(): void {
  world.showsTriangles = !world.showsTriangles;
  hud.showTriangles(world.showsTriangles);
}

function toggleShapes(): void {
  world.showsShapes = !world.showsShapes;
  hud.showShapes(world.showsShapes);
}

function toggleMouse(): void {
  pointer.turnsPlayer = !pointer.turnsPlayer;
  world.stage.view.rightTurns = pointer.turnsPlayer;
  connection.sendMouseTurning(pointer.turnsPlayer);
  hud.showMouse(pointer.turnsPlayer);
}
