// What the physics says of the player, number by number.

import { type OwnPose, PoseFlag, type Touch } from "../net/wire";
import { formatCell } from "../net/world";
import { describeFooting, describeTouches } from "./touches";

export class Panel {
  private readonly fields = new Map<string, HTMLElement>();

  constructor() {
    for (const field of document.querySelectorAll<HTMLElement>("[data-field]")) this.fields.set(field.dataset.field ?? "", field);
  }

  /** Texts by field, as shown. */
  get texts(): Record<string, string> {
    return Object.fromEntries([...this.fields].map(([name, field]) => [name, field.textContent ?? ""]));
  }

  showPose(pose: OwnPose): void {
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
    this.set("tick", String(pose.tick));
    this.set("players", String(pose.players));
  }

  showTouches(touches: readonly Touch[]): void {
    this.set("footing", describeFooting(touches));
    this.set("touches", describeTouches(touches));
  }

  showFps(fps: number): void {
    this.set("fps", `${fps.toFixed(0)} /s`);
  }

  private set(name: string, text: string, good?: boolean): void {
    const field = this.fields.get(name);
    if (!field) return;
    if (field.textContent !== text) field.textContent = text;
    if (good !== undefined) field.dataset.state = good ? "yes" : "no";
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
