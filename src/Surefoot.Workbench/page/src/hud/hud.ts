// Everything on the page that is not the world: panel, sliders, bar, menu, help, messages.

import type { ConnectionState } from "../net/connection";
import type { Place } from "../net/places";
import { EventKind, type OwnPose, type PlayerEvent, PoseFlag, type ServerFrame, type Touch, type Welcome } from "../net/wire";
import { formatCell } from "../net/world";
import { describeFooting, describeTouches } from "./touches";

interface Asks {
  settings(runSkill: number, jumpSkill: number, burden: number): void;
  goto(place: number): void;
}

const coverTexts: Record<ConnectionState, string> = {
  connecting: "Connecting…",
  open: "Loading the land…",
  lost: "The workbench is not answering. Trying again…",
  full: "The workbench lets no more players in, or is gone. Trying again…",
};

// Errors of the motion interpreter, as it numbers them.
const refusals: Record<number, string> = {
  0x24: "You are not on the ground.",
  0x47: "You cannot jump now.",
  0x48: "You cannot jump from this position.",
  0x49: "You carry too much to jump.",
};

export class Hud {
  private readonly fields = new Map<string, HTMLElement>();
  private readonly cover = element("cover");
  private readonly bar = element("charge");
  private readonly prompt = element("prompt");
  private readonly toasts = element("toasts");
  private readonly places = element<HTMLSelectElement>("places");
  private readonly run = element<HTMLInputElement>("run-skill");
  private readonly jump = element<HTMLInputElement>("jump-skill");
  private readonly burden = element<HTMLInputElement>("burden");
  private capacity = 1;
  private listed: readonly Place[] = [];

  constructor(
    private readonly asks: Asks,
    toggles: { triangles: () => void; shapes: () => void; mouse: () => void },
  ) {
    for (const field of document.querySelectorAll<HTMLElement>("[data-field]")) this.fields.set(field.dataset.field ?? "", field);
    for (const slider of [this.run, this.jump, this.burden]) {
      slider.addEventListener("input", () => this.slid());
      // Keys belong to the player again as soon as the slider is let go.
      slider.addEventListener("change", () => slider.blur());
    }
    this.places.addEventListener("change", () => {
      const index = Number(this.places.value);
      this.asks.goto(index);
      const hint = this.listed[index]?.hint;
      if (hint) this.toast(hint, "hint");
      this.places.selectedIndex = 0;
      this.places.blur();
    });
    press("toggle-triangles", toggles.triangles);
    press("toggle-shapes", toggles.shapes);
    press("toggle-mouse", toggles.mouse);
    press("toggle-help", () => this.toggleHelp());
  }

  /** Panel texts by field, as shown. */
  get panel(): Record<string, string> {
    return Object.fromEntries([...this.fields].map(([name, field]) => [name, field.textContent ?? ""]));
  }

  /** Share of the jump bar that is filled, as shown. */
  get barFilled(): number {
    return this.bar.classList.contains("charging") ? Number(this.bar.getAttribute("aria-valuenow")) / 100 : 0;
  }

  /** The places that the menu offers, by the index that the server knows them by. */
  get listedPlaces(): readonly Place[] {
    return this.listed;
  }

  receive(frame: ServerFrame): void {
    switch (frame.kind) {
      case "welcome":
        this.welcome(frame);
        break;
      case "pose":
        this.showPose(frame);
        break;
      case "touches":
        this.showTouches(frame.touches);
        break;
      case "event":
        this.showEvent(frame);
        break;
    }
  }

  private welcome(welcome: Welcome): void {
    this.capacity = Math.max(1, welcome.burdenCapacity);
    this.run.max = this.jump.max = String(welcome.maxSkill);
    this.burden.max = String(welcome.maxBurden);
    this.run.value = String(welcome.runSkill);
    this.jump.value = String(welcome.jumpSkill);
    this.burden.value = String(welcome.burden);
    this.showSliders();
  }

  listPlaces(world: string, places: readonly Place[]): void {
    element("world-name").textContent = world;
    this.listed = places;
    this.places.replaceChildren(
      new Option("a place…", "", true, true),
      ...places.map((place, index) => new Option(place.name, String(index))),
    );
    this.places.options[0].disabled = true;
  }

  state(state: ConnectionState): void {
    this.cover.classList.remove("away");
    this.cover.classList.toggle("lost", state === "lost");
    this.cover.querySelector("p")!.textContent = coverTexts[state];
  }

  uncover(): void {
    this.cover.classList.add("away");
  }

  private showPose(pose: OwnPose): void {
    const { position: p, planeNormal: n } = pose;
    const contact = (pose.flags & PoseFlag.Contact) !== 0;
    const walkable = (pose.flags & PoseFlag.OnWalkable) !== 0;
    this.set("speed", `${pose.speed.toFixed(2)} m/s`);
    this.set("vertical", `${signed(pose.velocity.z, 2)} m/s`);
    this.set("runRate", pose.runRate.toFixed(3));
    this.set("cell", (pose.flags & PoseFlag.Nowhere) !== 0 ? `${formatCell(pose.cell)} (not loaded)` : formatCell(pose.cell));
    this.set("position", `${p.x.toFixed(2)} ${p.y.toFixed(2)} ${p.z.toFixed(2)}`);
    this.set("heading", `${compass(pose.yaw).toFixed(1)}°`);
    this.set("walkable", walkable ? "yes" : "no", walkable);
    this.set(
      "plane",
      contact ? `${signed(n.x, 3)} ${signed(n.y, 3)} ${signed(n.z, 3)}\n${signed(pose.planeDistance, 3)}` : "none",
      contact,
    );
    this.set("slope", contact ? `${((Math.acos(Math.min(1, Math.max(-1, n.z))) * 180) / Math.PI).toFixed(1)}°` : "–");
    this.set("quantum", `${(pose.quantum * 1000).toFixed(1)} ms`);
    this.set("step", String(pose.step));
    this.set("players", String(pose.players));
  }

  showCharge(charging: boolean, charge: number): void {
    this.bar.classList.toggle("charging", charging);
    if (!charging) return;
    const percent = Math.round(charge * 100);
    this.bar.setAttribute("aria-valuenow", String(percent));
    (this.bar.firstElementChild as HTMLElement).style.transform = `scaleX(${charge})`;
    this.bar.lastElementChild!.textContent = `Jump ${percent} %`;
  }

  private showTouches(touches: readonly Touch[]): void {
    this.set("footing", describeFooting(touches));
    this.set("touches", describeTouches(touches));
  }

  /** What the key for doors would do here. */
  showDoor(door: { name: string; open: boolean } | null): void {
    this.prompt.hidden = door === null;
    const text = door?.open ? "closes the door" : "opens the door";
    if (door && this.prompt.lastElementChild!.textContent !== text) this.prompt.lastElementChild!.textContent = text;
  }

  showFps(fps: number): void {
    this.set("fps", `${fps.toFixed(0)} /s`);
  }

  private showEvent(event: PlayerEvent): void {
    switch (event.event) {
      case EventKind.Jumped:
        this.toast(`Jumped at ${Math.round(event.value * 100)} %`);
        break;
      case EventKind.Landed:
        if (event.value > 3) this.toast(`Landed at ${event.value.toFixed(1)} m/s`);
        break;
      case EventKind.JumpRefused:
        this.toast(refusals[event.code] ?? `Refused (0x${event.code.toString(16)})`, "refused");
        break;
      case EventKind.RunRateChanged:
        this.toast(`Run rate ${event.value.toFixed(3)}: ${(event.value * 4).toFixed(2)} m/s`);
        break;
    }
  }

  showTriangles(shown: boolean): void {
    element("legend").hidden = !shown;
    element("toggle-triangles").setAttribute("aria-pressed", String(shown));
  }

  showShapes(shown: boolean): void {
    element("toggle-shapes").setAttribute("aria-pressed", String(shown));
  }

  showMouse(turns: boolean): void {
    element("toggle-mouse").setAttribute("aria-pressed", String(turns));
  }

  toggleHelp(shown = element("help").hidden): void {
    element("help").hidden = !shown;
    element("toggle-help").setAttribute("aria-pressed", String(shown));
  }

  togglePanels(): void {
    document.body.classList.toggle("bare");
  }

  private slid(): void {
    this.showSliders();
    this.asks.settings(Number(this.run.value), Number(this.jump.value), Number(this.burden.value));
  }

  private showSliders(): void {
    output(this.run, this.run.value);
    output(this.jump, this.jump.value);
    output(this.burden, `${this.burden.value} (${Math.round((100 * Number(this.burden.value)) / this.capacity)} %)`);
  }

  private set(name: string, text: string, good?: boolean): void {
    const field = this.fields.get(name);
    if (!field) return;
    if (field.textContent !== text) field.textContent = text;
    if (good !== undefined) field.dataset.state = good ? "yes" : "no";
  }

  private toast(text: string, look = ""): void {
    const line = document.createElement("p");
    line.textContent = text;
    line.className = look;
    line.addEventListener("animationend", () => line.remove());
    this.toasts.append(line);
    while (this.toasts.childElementCount > 3) this.toasts.firstElementChild!.remove();
  }
}

/** Compass heading in degrees: north 0, east 90. */
export function compass(yaw: number): number {
  return ((((-yaw * 180) / Math.PI) % 360) + 360) % 360;
}

function signed(value: number, digits: number): string {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? ` ${(0).toFixed(digits)}` : value < 0 ? text : ` ${text}`;
}

function element<T extends HTMLElement = HTMLElement>(id: string): T {
  return document.getElementById(id) as T;
}

function output(slider: HTMLInputElement, text: string): void {
  slider.parentElement!.querySelector("output")!.value = text;
}

/** A button that gives the keyboard back to the player. */
function press(id: string, action: () => void): void {
  const button = element(id);
  button.addEventListener("click", () => {
    action();
    button.blur();
  });
}
