// What stands on a landblock, as `/shapes/XXYY` says it; `Wire/ShapesFrame.cs` in the server's source says the same.

import type { Vec3 } from "./wire";

/** Triangles that belong together: nine numbers each, metres in the block. */
export interface NamedShape {
  id: number;
  triangles: Float32Array;
}

/** Scenery that stops bodies by an upright cylinder, or by a sphere. */
export interface Plant {
  low: Vec3;
  radius: number;
  height: number;
  round: boolean;
}

/** A part of an object that an animation moves: triangles in its own frame at scale 1. */
export interface MovingShape {
  object: number;
  part: number;
  triangles: Float32Array;
}

export interface Shapes {
  objects: Float32Array;
  rocks: Float32Array;
  shells: NamedShape[];
  rooms: NamedShape[];
  plants: Plant[];
  moving: MovingShape[];
}

const headerLength = 24;
const shapeLength = 8;
const plantLength = 24;
const movingLength = 8;
const triangleLength = 36;

/** Reads an answer; null when its length is not what it says. */
export function decodeShapes(buffer: ArrayBuffer): Shapes | null {
  if (buffer.byteLength < headerLength) return null;
  const view = new DataView(buffer);
  const [objects, rocks, shellCount, roomCount, plantCount, movingCount] = [0, 4, 8, 12, 16, 20].map((at) => view.getUint32(at, true));
  const named = shellCount + roomCount;
  const movingStart = headerLength + named * shapeLength + plantCount * plantLength;
  let start = movingStart + movingCount * movingLength;
  if (buffer.byteLength < start) return null;
  const counts = Array.from({ length: named }, (_, i) => view.getUint32(headerLength + i * shapeLength + 4, true));
  const movingCounts = Array.from({ length: movingCount }, (_, i) => view.getUint32(movingStart + i * movingLength + 4, true));
  const total = [...counts, ...movingCounts].reduce((sum, count) => sum + count, objects + rocks);
  if (buffer.byteLength !== start + total * triangleLength) return null;

  const take = (triangles: number): Float32Array => {
    const numbers = new Float32Array(buffer, start, triangles * 9);
    start += triangles * triangleLength;
    return numbers;
  };
  const plant = (i: number): Plant => {
    const at = headerLength + named * shapeLength + i * plantLength;
    const [x, y, z, radius, height] = [0, 4, 8, 12, 16].map((more) => view.getFloat32(at + more, true));
    return { low: { x, y, z }, radius, height, round: view.getUint32(at + 20, true) !== 0 };
  };
  const objectTriangles = take(objects);
  const rockTriangles = take(rocks);
  const shapes = counts.map((count, i) => ({ id: view.getUint32(headerLength + i * shapeLength, true), triangles: take(count) }));
  const moving = movingCounts.map((count, i) => {
    const at = movingStart + i * movingLength;
    return { object: view.getUint16(at, true), part: view.getUint16(at + 2, true), triangles: take(count) };
  });
  return {
    objects: objectTriangles,
    rocks: rockTriangles,
    shells: shapes.slice(0, shellCount),
    rooms: shapes.slice(shellCount),
    plants: Array.from({ length: plantCount }, (_, i) => plant(i)),
    moving,
  };
}
