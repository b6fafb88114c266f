// The edges by which a shape is read: where faces meet at an angle, and where they end. Seams between faces that go on in the same plane
// are no edges, also where a long side meets several short ones.

import * as THREE from "three";

/** Faces that meet at less are taken for one, as a cosine. */
const sameFace = Math.cos((20 * Math.PI) / 180);

/** A side may be an edge in part, piece by piece. */
const pieceLength = 0.2;
const mostPieces = 60;

/** Beside an edge at which the next face is looked for, metres. */
const beside = 0.02;

interface Face {
  corners: [THREE.Vector3, THREE.Vector3, THREE.Vector3];
  normal: THREE.Vector3;
}

interface Side {
  from: THREE.Vector3;
  to: THREE.Vector3;
  faces: { face: Face; opposite: THREE.Vector3 }[];
}

/**
 * Edges: pairs of ends, three numbers each, and with each end the normals of the two faces that meet there, or twice that of the only one.
 */
export interface Edges {
  ends: Float32Array;
  faceA: Float32Array;
  faceB: Float32Array;
}

/** The edges of triangles of nine numbers each. */
export function edgesOf(triangles: Float32Array): Edges {
  const planes = new Map<string, Face[]>();
  const sides = new Map<string, Side>();
  for (let at = 0; at < triangles.length; at += 9) {
    const corners = [0, 3, 6].map((more) => new THREE.Vector3().fromArray(triangles, at + more)) as Face["corners"];
    const normal = new THREE.Triangle(...corners).getNormal(new THREE.Vector3());
    if (normal.lengthSq() === 0) continue;
    const face = { corners, normal };
    grow(planes, planeKey(face), face);
    for (let i = 0; i < 3; i++) addSide(sides, corners[i], corners[(i + 1) % 3], { face, opposite: corners[(i + 2) % 3] });
  }
  const ends: number[] = [];
  const faceA: number[] = [];
  const faceB: number[] = [];
  for (const side of sides.values()) {
    for (const [from, to] of partsOf(side, planes)) {
      ends.push(...new THREE.Vector3().lerpVectors(side.from, side.to, from).toArray());
      ends.push(...new THREE.Vector3().lerpVectors(side.from, side.to, to).toArray());
      const [a, b] = [side.faces[0].face.normal.toArray(), side.faces[side.faces.length - 1].face.normal.toArray()];
      faceA.push(...a, ...a);
      faceB.push(...b, ...b);
    }
  }
  return { ends: new Float32Array(ends), faceA: new Float32Array(faceA), faceB: new Float32Array(faceB) };
}

function addSide(sides: Map<string, Side>, from: THREE.Vector3, to: THREE.Vector3, one: Side["faces"][number]): void {
  const a = pointKey(from);
  const b = pointKey(to);
  if (a === b) return;
  const key = a < b ? `${a}|${b}` : `${b}|${a}`;
  const side = sides.get(key);
  if (side) side.faces.push(one);
  else sides.set(key, { from, to, faces: [one] });
}

/** The parts of a side that are an edge, from and to as shares of it. */
function partsOf({ from, to, faces }: Side, planes: Map<string, Face[]>): [number, number][] {
  if (faces.length > 1) return faces.some(({ face }) => face.normal.dot(faces[0].face.normal) < sameFace) ? [[0, 1]] : [];
  const [{ face, opposite }] = faces;
  const neighbours = (planes.get(planeKey(face)) ?? [])
    .filter((other) => other !== face)
    .map(({ corners }) => new THREE.Triangle(...corners));
  if (neighbours.length === 0) return [[0, 1]];
  const along = new THREE.Vector3().subVectors(to, from);
  const pieces = Math.min(mostPieces, Math.ceil(along.length() / pieceLength));
  along.normalize();
  const away = new THREE.Vector3().subVectors(from, opposite);
  away.addScaledVector(along, -away.dot(along)).normalize().multiplyScalar(beside);
  const parts: [number, number][] = [];
  for (let i = 0; i < pieces; i++) {
    const point = new THREE.Vector3().lerpVectors(from, to, (i + 0.5) / pieces).add(away);
    if (neighbours.some((other) => other.containsPoint(point))) continue;
    const last = parts.at(-1);
    if (last && last[1] === i / pieces) last[1] = (i + 1) / pieces;
    else parts.push([i / pieces, (i + 1) / pieces]);
  }
  return parts;
}

function planeKey({ corners, normal }: Face): string {
  const round = (value: number, parts: number): number => Math.round(value * parts) + 0;
  return `${round(normal.x, 100)},${round(normal.y, 100)},${round(normal.z, 100)},${round(normal.dot(corners[0]), 20)}`;
}

function pointKey({ x, y, z }: THREE.Vector3): string {
  return `${Math.round(x * 500)},${Math.round(y * 500)},${Math.round(z * 500)}`;
}

function grow<V>(map: Map<string, V[]>, key: string, value: V): void {
  const list = map.get(key);
  if (list) list.push(value);
  else map.set(key, [value]);
}
