// A tileable texture of four independent fractal noises, made once: fetching it costs a fraction of computing noise for every pixel.

import * as THREE from "three";

const size = 256;
const coarsest = 8;
const octaves = 5;

export function makeNoiseTexture(): THREE.DataTexture {
  const data = new Uint8Array(size * size * 4);
  for (let channel = 0; channel < 4; channel++) {
    const values = fractal(channel + 1);
    for (let i = 0; i < values.length; i++) data[i * 4 + channel] = Math.round(values[i] * 255);
  }
  const texture = new THREE.DataTexture(data, size, size, THREE.RGBAFormat);
  texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
  texture.magFilter = THREE.LinearFilter;
  texture.minFilter = THREE.LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.anisotropy = 4;
  texture.needsUpdate = true;
  return texture;
}

/** Octaves of value noise, each twice as fine and half as strong, scaled to 0..1. */
function fractal(seed: number): Float32Array {
  const sum = new Float32Array(size * size);
  const random = generator(seed);
  for (let octave = 0; octave < octaves; octave++) addOctave(sum, coarsest << octave, 0.5 ** octave, random);
  let low = Infinity;
  let high = -Infinity;
  for (const value of sum) {
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  return sum.map((value) => (value - low) / (high - low));
}

/** Random values on a lattice of so many cells, eased in between. Where a pixel lies between them is the same for every row and column. */
function addOctave(sum: Float32Array, cells: number, weight: number, random: () => number): void {
  const lattice = Float32Array.from({ length: cells * cells }, random);
  const before = Int32Array.from({ length: size }, (_, at) => Math.floor((at * cells) / size));
  const after = before.map((cell) => (cell + 1) % cells);
  const share = Float64Array.from({ length: size }, (_, at) => ease((at * cells) / size - before[at]));
  for (let y = 0; y < size; y++) {
    const low = before[y] * cells;
    const high = after[y] * cells;
    for (let x = 0; x < size; x++) {
      const bottom = lattice[low + before[x]] + (lattice[low + after[x]] - lattice[low + before[x]]) * share[x];
      const top = lattice[high + before[x]] + (lattice[high + after[x]] - lattice[high + before[x]]) * share[x];
      sum[y * size + x] += weight * (bottom + (top - bottom) * share[y]);
    }
  }
}

function ease(t: number): number {
  return t * t * (3 - 2 * t);
}

/** Mulberry32: the same land on every machine. */
function generator(seed: number): () => number {
  let state = seed * 0x9e3779b9;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
