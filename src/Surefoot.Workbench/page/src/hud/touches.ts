// What the player stands on and touches, in words.

import type { Touch } from "../net/wire";
import { formatCell } from "../net/world";

const names: Record<number, string> = { 1: "ground", 2: "building", 3: "room", 4: "scenery", 5: "object" };

/** Name or kind, and id, e.g. `room 0xA8B50100`. */
export function nameTouch(touch: Touch): string {
  const what = touch.name || names[touch.type] || "something";
  return `${what} ${formatCell(touch.id)}`;
}

/** Angle of the surface in degrees: 0 a level floor, 90 a wall, 180 a ceiling. */
export function surfaceAngle(touch: Touch): number {
  return (Math.acos(Math.min(1, Math.max(-1, touch.normal.z))) * 180) / Math.PI;
}

/** What is stood on, with the slope. */
export function describeFooting(touches: readonly Touch[]): string {
  const footing = touches.find((touch) => touch.footing);
  return footing ? `${nameTouch(footing)}\nslope ${surfaceAngle(footing).toFixed(1)}°` : "nothing";
}

/** All that is touched besides, one a line, with the angle of the surface. */
export function describeTouches(touches: readonly Touch[]): string {
  const lines = touches.filter((touch) => !touch.footing).map((touch) => `${nameTouch(touch)} ${surfaceAngle(touch).toFixed(0)}°`);
  const shown = lines.slice(0, 4);
  if (lines.length > shown.length) shown.push(`and ${lines.length - shown.length} more`);
  return shown.join("\n") || "nothing";
}
