// Puts the parts together and draws a frame whenever the screen is ready.

import { Address } from "./hud/address";
import { commands } from "./hud/commands";
import { copyWalk } from "./hud/copyWalk";
import { element } from "./hud/elements";
import { Held } from "./hud/held";
import { Hud } from "./hud/hud";
import { type Frames, Inspection } from "./hud/inspection";
import { Keyboard } from "./hud/keys";
import { LeftOutPanel } from "./hud/leftOut";
import { Pick } from "./hud/pick";
import { Pointer } from "./hud/pointer";
import { TouchPad } from "./hud/touchPad";
import { Connection } from "./net/connection";
import { Entrance } from "./net/entrance";
import type { Toggle } from "./net/link";
import { fetchPlaces } from "./net/places";
import { Requests } from "./net/requests";
import { Session } from "./net/session";
import { formatSpot } from "./net/spot";
import { WalkPath } from "./net/walk";
import { PoseFlag, type ServerFrame } from "./net/wire";
import type { Drawing } from "./scene/webgl";
import { WorldView } from "./things/worldView";

/** Seconds between two pictures of the map. */
const mapEvery = 0.1;

/** A creature so near can be chosen by a key, metres. */
const choiceWithin = 40;

export function play(by: Drawing): void {
  const session = new Session();
  const surface = element<HTMLCanvasElement>("view");
  const world = new WorldView(surface, by);
  const drawing: Frames = { count: 0, drawnAt: 0 };
  const listing = fetchPlaces();

  const connection = new Connection(receive, (state) => {
    if (state !== "open") return hud.cover.show(state);
    keyboard.releaseAll();
    requests.mouseTurning(pointer.turnsPlayer);
  });
  const walk = new WalkPath();
  const requests = new Requests(connection);
  const hud = new Hud({
    settings: (settings) => {
      entrance.chose(settings);
      showAddress();
    },
    toggle,
    copyWalk: () => requests.askWalk(),
    go: (destination) => {
      if ("spot" in destination) return requests.placeAt(destination.spot);
      requests.goto(destination.place);
      expect(destination.place);
    },
    use: () => requests.use(),
    network: tellNetwork,
    creature: (body, wish) => requests.creature(body, wish),
  });
  const entrance = new Entrance(location.search, listing, requests, {
    settings: (settings) => hud.skills.show(settings),
    network: (network) => hud.network.show(network),
    toggles: (wanted) => {
      for (const [name, on] of Object.entries(wanted)) hud.toggles.set(name as Toggle, on);
    },
    place: expect,
    ignored: (parts) => hud.notice.show(`Ignored in the link: ${parts.join("; ")}.`),
  });
  const address = new Address(() => {
    const { spot, ...skills } = entrance.asLink;
    return { ...skills, at: spot ? formatSpot(spot) : undefined, net: hud.network.network, toggles: hud.toggles.all };
  });
  const keyCommands = commands({
    toggle: (name) => hud.toggles.flip(name),
    use: () => requests.use(),
    autoRun: () => requests.autoRun(),
    recenter: () => world.stage.view.recenter(),
    goTo: () => hud.goTo.focus(),
    copyWalk: () => requests.askWalk(),
    creature: () => {
      const at = world.drawn?.position;
      const near = at && world.bodies.creatureNear(at, choiceWithin);
      if (near) hud.creature.choose(near, true);
    },
    help: () => hud.help.toggle(),
    closeHelp: () => hud.help.shown && hud.help.toggle(),
  });
  const held = new Held((bits) => requests.keys(bits));
  const keyboard = new Keyboard(
    hud.focus,
    held,
    () => requests.focusLost(),
    (code) => keyCommands.get(code)?.(),
  );
  const leftOut = new LeftOutPanel();
  const pointer = new Pointer(surface, (buttons, right) => requests.pointer(buttons, right));
  new TouchPad(held);
  new Pick(surface, (x, y) => {
    const creature = world.creatureAt(x, y);
    if (creature) hud.creature.choose(creature, false);
    else hud.creature.hide();
  });

  window.surefoot = new Inspection(world, session, hud, connection, requests, walk, drawing);
  void listing.then((places) => hud.listPlaces(places));
  connection.open();
  requestAnimationFrame(draw);

  /** The player will come to a named place. */
  function expect(index: number): void {
    const place = hud.goTo.listed[index];
    world.expect(place?.lookFrom ?? 0);
    if (place?.hint) hud.toasts.show(place.hint, "hint");
  }

  function receive(frame: ServerFrame): void {
    session.receive(frame, performance.now() / 1000);
    world.receive(frame);
    if (frame.kind === "event" && entrance.event(frame)) return;
    hud.receive(frame);
    if (frame.kind === "welcome") {
      walk.clear();
      entrance.welcome(frame);
      tellNetwork();
    }
    if (frame.kind === "sentence") hud.toasts.show(frame.text, "hint");
    if (frame.kind === "walk") void copyWalk(frame, hud.toasts, hud.notice);
    if (frame.kind !== "pose") return;
    entrance.pose(frame);
    walk.receive(frame);
    leftOut.enter(frame.cell);
    showAddress();
  }

  function tellNetwork(): void {
    requests.network(hud.network.network, hud.toggles.all.truth);
    showAddress();
  }

  /** Until the player is where the link wants it, the link stays: who reloads meanwhile comes there all the same. */
  function showAddress(): void {
    if (!entrance.entering) address.touch();
  }

  let mapDue = 0;
  let lastFrame = performance.now() / 1000;

  function draw(): void {
    requestAnimationFrame(draw);
    // While the server is lost the picture stands still.
    const now = connection.state === "lost" ? lastFrame : performance.now() / 1000;
    const elapsed = now - lastFrame;
    lastFrame = now;
    drawing.count++;
    drawing.drawnAt = session.clock.drawTime(now);
    world.draw(drawing.drawnAt, session.pose, now, elapsed);
    showNear();
    if (drawing.count % 15 === 0) hud.panel.showFps(1 / world.stage.frameTime);
  }

  /** What depends on where the player is drawn. */
  function showNear(): void {
    const { drawn } = world;
    if (!drawn || !session.pose) return;
    if (lastFrame >= mapDue && hud.map.shown) {
      mapDue = lastFrame + mapEvery;
      const others = [...world.players.others.values()].flatMap((other) => other.drawn?.position ?? []);
      const { path, metres, seconds } = walk;
      hud.map.draw({ surroundings: world.surroundings, player: drawn.position, yaw: drawn.yaw, others, path, metres, seconds }, lastFrame);
    }
    hud.creature.update((body) => world.bodies.find(body) !== null);
    hud.showDoor(world.bodies.doorAt(drawn.position));
    hud.showCharge((session.pose.flags & PoseFlag.Charging) !== 0, drawn.charge);
    if (connection.state !== "open") return;
    if (world.stage.isDark) hud.cover.show("dark");
    else if (world.terrain.drawn > 0 && !entrance.entering) hud.cover.lift();
    else hud.cover.show("open");
  }

  function toggle(name: Toggle, on: boolean): void {
    switch (name) {
      case "triangles":
        world.showsTriangles = on;
        hud.showTriangles(on);
        break;
      case "shapes":
        world.showsShapes = on;
        break;
      case "panels":
        hud.showPanels(on);
        break;
      case "truth":
        tellNetwork();
        return;
      case "mouse":
        pointer.turnsPlayer = world.stage.view.rightTurns = on;
        requests.mouseTurning(on);
        break;
    }
    showAddress();
  }
}
