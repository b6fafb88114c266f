// Places as a person writes them: the forms that `surefoot walk --at` reads.

import type { Spot } from "./wire";
import { formatCell } from "./world";

const degree = Math.PI / 180;

/** A spot, or why the words name none. */
export type ParsedSpot = { spot: Spot } | { error: string };

/** Do the words begin as a spot does, and not as a name? */
export function looksLikeSpot(text: string): boolean {
  return /^\s*(0x|[0-9a-f]{8}\b)/i.test(text);
}

/** Reads a cell and metres: x, y on the ground; x, y, z; with a heading in degrees; or with a rotation w, x, y, z, as the game prints. */
export function parseSpot(text: string): ParsedSpot {
  const [id, ...rest] = text.split(/[\s,[\]]+/).filter((part) => part !== "");
  if (!/^(0x)?[0-9a-f]{1,8}$/i.test(id ?? "")) return { error: "a place is a cell and metres: 0xA9B40001, 12, 12, 0" };
  const cell = Number.parseInt(id.replace(/^0x/i, ""), 16);
  if (!isCell(cell))
    return { error: `${formatCell(cell)} cannot name a cell: its low half is 0001 to 0040 outdoors, 0100 to FFFD indoors` };
  const numbers = rest.map((part) => (part.trim() === "" ? Number.NaN : Number(part)));
  const wrong = numbers.findIndex((one) => !Number.isFinite(one) || !Number.isFinite(Math.fround(one)));
  if (wrong >= 0) return { error: `${rest[wrong]} is not a finite number of metres` };
  const [x, y, z, ...turn] = numbers;
  switch (numbers.length) {
    case 2:
      return (cell & 0xffff) < 0x100 ? { spot: { cell, x, y, z: null, yaw: 0 } } : { error: "a place in a room needs its height" };
    case 3:
      return { spot: { cell, x, y, z, yaw: 0 } };
    case 4:
      return { spot: { cell, x, y, z, yaw: -turn[0] * degree } };
    case 7:
      return Math.hypot(...turn) > 0 ? { spot: { cell, x, y, z, yaw: yawOf(turn) } } : { error: "the rotation has no length" };
    default:
      return { error: "a place is a cell and two, three or four numbers: x, y, z and a heading" };
  }
}

/** A spot in the form that `parseSpot` and the command read; numbers that give the same single-precision values again. */
export function formatSpot({ cell, x, y, z, yaw }: Spot): string {
  const heading = (((-yaw / degree) % 360) + 360) % 360;
  return [formatCell(cell), single(x), single(y), ...(z === null ? [] : [single(z), single(Math.fround(heading))])].join(",");
}

/** The shortest decimal that is this number in single precision. */
export function single(value: number): string {
  const wanted = Math.fround(value);
  for (let digits = 1; digits < 9; digits++) {
    const text = wanted.toPrecision(digits);
    if (Math.fround(Number(text)) === wanted) return plain(text);
  }
  return plain(wanted.toPrecision(9));
}

/** Without an exponent where the number allows. */
function plain(text: string): string {
  const number = Number(text);
  return Math.abs(number) >= 1e-6 || number === 0 ? String(number) : number.toFixed(12).replace(/\.?0+$/, "");
}

function isCell(cell: number): boolean {
  const low = cell & 0xffff;
  return (low >= 1 && low <= 0x40) || (low >= 0x100 && low <= 0xfffd);
}

/** Radians about z of a rotation w, x, y, z. */
function yawOf([w, x, y, z]: number[]): number {
  return Math.atan2(2 * (w * z + x * y), w * w + x * x - y * y - z * z);
}
