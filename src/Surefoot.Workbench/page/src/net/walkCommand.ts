// The words of `surefoot walk` for keys that were held.

import { formatSpot } from "./spot";
import { Key, type Settings, type Spot } from "./wire";

const names: [number, string][] = [
  [Key.Forward, "W"],
  [Key.Back, "S"],
  [Key.TurnLeft, "A"],
  [Key.TurnRight, "D"],
  [Key.SidestepLeft, "Q"],
  [Key.SidestepRight, "E"],
  [Key.Walk, "Shift"],
  [Key.Jump, "Space"],
];

/** Shorter than what three digits tell. */
const shortest = 0.001;

/** Quanta that the command takes, milliseconds. */
const leastQuantum = 33.34;
const mostQuantum = 200;

/** Keys held, as an input frame says them, and for how long, seconds. */
export interface WalkLeg {
  keys: number;
  seconds: number;
}

/**
 * A command line.
 * @param quantum mean quantum, seconds; null when nothing is known of it
 * @param dats folder of the files; null for the demo world
 */
export function writeWalk(
  start: Spot,
  { runSkill, jumpSkill, burden }: Settings,
  legs: readonly WalkLeg[],
  quantum: number | null,
  dats: string | null,
): string {
  const parts = ["surefoot walk", `--at ${formatSpot(start)}`, `--run ${runSkill}`, `--jump ${jumpSkill}`];
  if (burden !== 0) parts.push(`--burden ${burden}`);
  if (dats !== null) parts.push(`--dats ${quote(dats)}`);
  if (quantum !== null) parts.push(`--quantum ${milliseconds(quantum)}`);
  parts.push(`--script "${writeScript(legs)}"`);
  return parts.join(" ");
}

/** The script: legs of the same keys are one. */
export function writeScript(legs: readonly WalkLeg[]): string {
  const joined: WalkLeg[] = [];
  for (const leg of legs) {
    const last = joined.at(-1);
    if (last && (last.keys === leg.keys || leg.seconds < shortest)) last.seconds += leg.seconds;
    else if (leg.seconds >= shortest) joined.push({ ...leg });
  }
  if (joined.length === 0) return "Wait 1";
  return joined.map(({ keys, seconds }) => `${keyNames(keys)} ${Number(seconds.toFixed(3))}`).join("; ");
}

function milliseconds(quantum: number): number {
  return Number(Math.min(mostQuantum, Math.max(leastQuantum, quantum * 1000)).toFixed(2));
}

function keyNames(keys: number): string {
  const held = names.filter(([bit]) => (keys & bit) !== 0).map(([, name]) => name);
  return held.length > 0 ? held.join("+") : "Wait";
}

/** A word that a shell takes as it is: of the system that the path is written for. */
function quote(path: string): string {
  if (/^[\w./-]+$/.test(path)) return path;
  return /^([A-Za-z]:)?\\/.test(path) ? `"${path}"` : `'${path.replaceAll("'", "'\\''")}'`;
}
