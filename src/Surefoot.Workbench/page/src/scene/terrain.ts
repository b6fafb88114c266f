// The landblocks around the player: fetched once each, drawn from exactly the triangles that physics stands on, dropped when far.

import * as THREE from "three";
import { blockSide, cellSide, decodeTerrain, heightInBlock, type TerrainBlock } from "../net/world";
import type { Cutaway } from "./cutaway";
import { makeTerrainMaterial, type TerrainUniforms } from "./terrainMaterial";
import { isGrassy, isRoad, isWater, terrainColors, terrainType } from "./terrainTypes";

const drawRadius = 5;
const keepRadius = 8;
const buildMilliseconds = 4;
const roadColor = 0x8f7350;

type Loaded = TerrainBlock | "none";

export class Terrain {
  readonly group = new THREE.Group();
  readonly uniforms: TerrainUniforms;

  private readonly material: THREE.Material;
  private readonly blocks = new Map<number, Loaded>();
  private readonly meshes = new Map<number, THREE.Mesh>();
  private fetching = false;
  private retryAt = 0;
  private center = -1;
  private missing: number[] = [];
  private originX = 0;
  private originY = 0;

  constructor(noise: THREE.Texture, sun: THREE.Vector3, horizon: THREE.Color, zenith: THREE.Color, cutaway: Cutaway) {
    this.uniforms = {
      time: { value: 0 },
      triangles: { value: 0 },
      sun: { value: sun },
      skyColor: { value: horizon.clone().lerp(zenith, 0.35) },
      horizon: { value: horizon },
      zenith: { value: zenith },
      noise: { value: noise },
    };
    this.material = cutaway.cut(makeTerrainMaterial(this.uniforms), "ground");
  }

  /** Number of landblocks drawn. */
  get drawn(): number {
    return this.meshes.size;
  }

  /** Blocks are drawn relative to this one, so that numbers on the graphics card stay small. */
  setOrigin(blockX: number, blockY: number): void {
    this.originX = blockX;
    this.originY = blockY;
    for (const [block, mesh] of this.meshes) this.place(mesh, block);
  }

  /**
   * Fetches, builds and drops blocks for a player in this block; a few are built a call, so that no frame waits long. True when something
   * was built.
   */
  update(block: number): boolean {
    if (block !== this.center) this.moveTo(block);
    if (this.missing.length === 0) return false;
    if (!this.fetching && performance.now() >= this.retryAt && !around(block, drawRadius + 1).every((id) => this.blocks.has(id)))
      void this.fetch(block);
    this.missing = this.missing.filter((id) => this.blocks.get(id) !== "none");
    const end = performance.now() + buildMilliseconds;
    const before = this.missing.length;
    while (this.buildNext() && performance.now() < end);
    return this.missing.length < before;
  }

  /** Ground height at global metres; null where no terrain has come. */
  heightAt(x: number, y: number): number | null {
    const bx = Math.floor(x / blockSide);
    const by = Math.floor(y / blockSide);
    const terrain = this.blocks.get((bx << 8) | by);
    return terrain && terrain !== "none" ? heightInBlock(terrain, x - bx * blockSide, y - by * blockSide) : null;
  }

  /** Colour of the ground at global metres, lit from the north-west: red, green, blue, 0 to 255; null where no terrain has come. */
  colorAt(x: number, y: number): [number, number, number] | null {
    const height = this.heightAt(x, y);
    const terrain = this.blocks.get((Math.floor(x / blockSide) << 8) | Math.floor(y / blockSide));
    if (height === null || !terrain || terrain === "none") return null;
    const corner = (at: number): number => Math.round((at % blockSide) / cellSide);
    const word = terrain.words[9 * corner(x) + corner(y)];
    const color = isRoad(word) ? roadColor : terrainColors[terrainType(word)];
    const step = 3;
    const rise = (this.heightAt(x + step, y - step) ?? height) - height;
    const light = Math.min(1.35, Math.max(0.45, 1 - rise / (step * 1.6)));
    return [(color >> 16) * light, ((color >> 8) & 0xff) * light, (color & 0xff) * light];
  }

  /** Where grass grows: on grassy ground that is no road and not steep. */
  grassAt(x: number, y: number): { height: number; type: number } | null {
    const bx = Math.floor(x / blockSide);
    const by = Math.floor(y / blockSide);
    const terrain = this.blocks.get((bx << 8) | by);
    if (!terrain || terrain === "none") return null;
    const u = (x - bx * blockSide) / cellSide;
    const v = (y - by * blockSide) / cellSide;
    const corner = 9 * Math.floor(u) + Math.floor(v);
    const type = terrainType(terrain.words[9 * Math.round(u) + Math.round(v)]);
    if (!isGrassy(type)) return null;
    let low = Infinity;
    let high = -Infinity;
    for (const c of [corner, corner + 1, corner + 9, corner + 10]) {
      if (isRoad(terrain.words[c]) || isWater(terrain.words[c])) return null;
      low = Math.min(low, terrain.heights[c]);
      high = Math.max(high, terrain.heights[c]);
    }
    if (high - low > cellSide * 0.75) return null;
    return { height: heightInBlock(terrain, x - bx * blockSide, y - by * blockSide), type };
  }

  private moveTo(block: number): void {
    this.center = block;
    this.drop(block);
    this.missing = around(block, drawRadius).filter((id) => !this.meshes.has(id));
  }

  private async fetch(block: number): Promise<void> {
    this.fetching = true;
    try {
      const answer = await fetch(`/terrain/${block.toString(16).padStart(4, "0")}/${drawRadius + 1}`);
      if (!answer.ok) throw new Error(answer.statusText);
      for (const terrain of decodeTerrain(await answer.arrayBuffer())) this.blocks.set(terrain.block, terrain);
      for (const id of around(block, drawRadius + 1)) if (!this.blocks.has(id)) this.blocks.set(id, "none");
    } catch {
      // The server is away: ask again, but not with every frame.
      this.retryAt = performance.now() + 1000;
    } finally {
      this.fetching = false;
    }
  }

  /** Builds the nearest block that is known with its neighbours; false when there is none. */
  private buildNext(): boolean {
    const next = this.missing.findIndex((id) => this.blocks.has(id) && around(id, 1).every((near) => this.blocks.has(near)));
    const terrain = this.blocks.get(this.missing[next]);
    if (!terrain || terrain === "none") return false;
    const mesh = new THREE.Mesh(this.build(terrain), this.material);
    mesh.receiveShadow = true;
    this.place(mesh, terrain.block);
    this.meshes.set(terrain.block, mesh);
    this.group.add(mesh);
    this.missing.splice(next, 1);
    return true;
  }

  private drop(center: number): void {
    const far = (id: number): boolean =>
      Math.max(Math.abs((id >> 8) - (center >> 8)), Math.abs((id & 0xff) - (center & 0xff))) > keepRadius;
    for (const [id, mesh] of this.meshes) {
      if (!far(id)) continue;
      this.group.remove(mesh);
      mesh.geometry.dispose();
      this.meshes.delete(id);
    }
    for (const id of this.blocks.keys()) if (far(id)) this.blocks.delete(id);
  }

  private place(mesh: THREE.Mesh, block: number): void {
    mesh.position.set(((block >> 8) - this.originX) * blockSide, ((block & 0xff) - this.originY) * blockSide, 0);
  }

  /** Height of vertex (i, j), which may lie one beyond the block; the slope is carried on where no neighbour is. */
  private vertexHeight(terrain: TerrainBlock, i: number, j: number): number {
    const dx = i < 0 ? -1 : i > 8 ? 1 : 0;
    const dy = j < 0 ? -1 : j > 8 ? 1 : 0;
    if (dx === 0 && dy === 0) return terrain.heights[9 * i + j];
    const near = this.blocks.get((((terrain.block >> 8) + dx) << 8) | ((terrain.block & 0xff) + dy));
    if (near && near !== "none") return near.heights[9 * (i - dx * 8) + (j - dy * 8)];
    return terrain.heights[9 * Math.min(8, Math.max(0, i)) + Math.min(8, Math.max(0, j))];
  }

  private smoothNormal(terrain: TerrainBlock, i: number, j: number): THREE.Vector3 {
    const east = this.vertexHeight(terrain, i + 1, j) - this.vertexHeight(terrain, i - 1, j);
    const north = this.vertexHeight(terrain, i, j + 1) - this.vertexHeight(terrain, i, j - 1);
    return new THREE.Vector3(-east, -north, 2 * cellSide).normalize();
  }

  private build(terrain: TerrainBlock): THREE.BufferGeometry {
    const corners = 8 * 8 * 6;
    const floats = (size: number): Float32Array => new Float32Array(corners * size);
    const position = floats(3);
    const normal = floats(3);
    const face = floats(3);
    const cell = floats(2);
    const edge = floats(3);
    const code = floats(2);
    const water = new Uint8Array(corners * 4);
    const colors = [0, 1, 2, 3].map(() => floats(3));
    const normals = Array.from({ length: 81 }, (_, at) => this.smoothNormal(terrain, Math.floor(at / 9), at % 9));
    const palette = terrainColors.map((color) => new THREE.Color(color));
    let at = 0;
    for (let i = 0; i < 8; i++) {
      for (let j = 0; j < 8; j++) {
        const vertex = { sw: 9 * i + j, nw: 9 * i + j + 1, se: 9 * i + j + 9, ne: 9 * i + j + 10 };
        const cornersOfCell = [vertex.sw, vertex.nw, vertex.se, vertex.ne];
        const road = cornersOfCell.reduce((bits, v) => (bits << 1) | (isRoad(terrain.words[v]) ? 1 : 0), 0);
        const cut = terrain.cuts[8 * i + j];
        // Each triangle starts at the corner that faces the diagonal, so that the third edge coordinate vanishes on it.
        const triangles =
          cut === 1
            ? [
                [vertex.se, vertex.ne, vertex.sw],
                [vertex.nw, vertex.sw, vertex.ne],
              ]
            : [
                [vertex.sw, vertex.se, vertex.nw],
                [vertex.ne, vertex.nw, vertex.se],
              ];
        for (const triangle of triangles) {
          const points = triangle.map((v) => new THREE.Vector3(Math.floor(v / 9) * cellSide, (v % 9) * cellSide, terrain.heights[v]));
          const flat = new THREE.Triangle(points[0], points[1], points[2]).getNormal(new THREE.Vector3());
          triangle.forEach((v, k) => {
            points[k].toArray(position, at * 3);
            normals[v].toArray(normal, at * 3);
            flat.toArray(face, at * 3);
            cell.set([points[k].x - i * cellSide, points[k].y - j * cellSide], at * 2);
            edge.set([k === 1 ? 1 : 0, k === 2 ? 1 : 0, k === 0 ? 1 : 0], at * 3);
            code.set([road, cut], at * 2);
            cornersOfCell.forEach((corner, c) => {
              palette[terrainType(terrain.words[corner])].toArray(colors[c], at * 3);
              water[at * 4 + c] = isWater(terrain.words[corner]) ? 1 : 0;
            });
            at++;
          });
        }
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(position, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(normal, 3));
    geometry.setAttribute("face", new THREE.BufferAttribute(face, 3));
    geometry.setAttribute("cell", new THREE.BufferAttribute(cell, 2));
    geometry.setAttribute("edge", new THREE.BufferAttribute(edge, 3));
    geometry.setAttribute("code", new THREE.BufferAttribute(code, 2));
    geometry.setAttribute("water", new THREE.BufferAttribute(water, 4));
    ["c00", "c01", "c10", "c11"].forEach((name, c) => void geometry.setAttribute(name, new THREE.BufferAttribute(colors[c], 3)));
    return geometry;
  }
}

/** Blocks of the map within a square radius, nearest first. */
function around(block: number, radius: number): number[] {
  const x = block >> 8;
  const y = block & 0xff;
  const found: { id: number; far: number }[] = [];
  for (let dx = -radius; dx <= radius; dx++) {
    for (let dy = -radius; dy <= radius; dy++) {
      const bx = x + dx;
      const by = y + dy;
      if (bx >= 0 && by >= 0 && bx < 255 && by < 255) found.push({ id: (bx << 8) | by, far: dx * dx + dy * dy });
    }
  }
  return found.sort((a, b) => a.far - b.far).map((one) => one.id);
}
