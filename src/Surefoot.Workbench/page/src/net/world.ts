// Ids and coordinates. "Global" metres count from the south-west corner of landblock 0000.

import type { Vec3 } from "./wire";

export const blockSide = 192;
export const cellSide = 24;

export interface TerrainBlock {
  block: number;
  /** 81 heights in metres, index 9·i + j: i east, j north. */
  heights: Float32Array;
  /** 81 terrain words: road in bits 0–1, type in bits 2–6. */
  words: Uint16Array;
  /** 64 split directions, 1 for SW–NE, index 8·i + j. */
  cuts: Uint8Array;
}

export function blockOf(cell: number): number {
  return cell >>> 16;
}

/** The cell is a room and no piece of land. */
export function isIndoors(cell: number): boolean {
  return (cell & 0xffff) >= 0x100;
}

export function toGlobal(cell: number, position: Vec3): Vec3 {
  return { x: (cell >>> 24) * blockSide + position.x, y: ((cell >>> 16) & 0xff) * blockSide + position.y, z: position.z };
}

export function formatCell(cell: number): string {
  return `0x${(cell >>> 0).toString(16).toUpperCase().padStart(8, "0")}`;
}

const terrainLength = 554;

/** Reads landblocks that follow each other; none when the bytes are no whole number of them. */
export function decodeTerrain(buffer: ArrayBuffer): TerrainBlock[] {
  if (buffer.byteLength % terrainLength !== 0) return [];
  const found: TerrainBlock[] = [];
  for (let start = 0; start < buffer.byteLength; start += terrainLength) {
    const view = new DataView(buffer, start, terrainLength);
    const heights = new Float32Array(81);
    const words = new Uint16Array(81);
    for (let i = 0; i < 81; i++) {
      heights[i] = view.getFloat32(4 + i * 4, true);
      words[i] = view.getUint16(328 + i * 2, true);
    }
    found.push({ block: view.getUint16(0, true), heights, words, cuts: new Uint8Array(buffer.slice(start + 490, start + terrainLength)) });
  }
  return found;
}

/** Height of the ground of a block at metres inside it, on the triangle that physics stands on. */
export function heightInBlock(terrain: TerrainBlock, x: number, y: number): number {
  const i = Math.min(7, Math.max(0, Math.floor(x / cellSide)));
  const j = Math.min(7, Math.max(0, Math.floor(y / cellSide)));
  const u = x / cellSide - i;
  const v = y / cellSide - j;
  const h = terrain.heights;
  const sw = h[9 * i + j];
  const nw = h[9 * i + j + 1];
  const se = h[9 * i + j + 9];
  const ne = h[9 * i + j + 10];
  if (terrain.cuts[8 * i + j] === 1) return u >= v ? sw + (se - sw) * u + (ne - se) * v : sw + (ne - nw) * u + (nw - sw) * v;
  return u + v <= 1 ? sw + (se - sw) * u + (nw - sw) * v : ne + (nw - ne) * (1 - u) + (se - ne) * (1 - v);
}
