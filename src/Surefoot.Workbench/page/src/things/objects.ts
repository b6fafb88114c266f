// Objects, buildings, rooms and scenery around the player: the shapes that bodies collide with, plants drawn as plants unless the plain shapes are asked for.

import * as THREE from "three";
import { decodeShapes, type MovingShape, type NamedShape, type Shapes } from "../net/shapes";
import { blockSide } from "../net/world";
import type { Box, Cutaway } from "../scene/cutaway";
import { MovingParts } from "./moving";
import { type PlantGroups, Plants } from "./plants";

const drawRadius = 3;
const keepRadius = 5;
const fetchesAtOnce = 3;
const sharpEdge = 20;

/** Landblocks farther than this have plants of a few triangles. */
const leafyRadius = 1;

interface Block {
  group: THREE.Group;
  /** Rocks as rocks. */
  rocks: THREE.Group;
  plants: PlantGroups;
  shells: { low: THREE.Box3; world: Box }[];
  moving: { shape: MovingShape; drawn: THREE.Group }[];
  /** Highest z of each room, by cell. */
  roomTops: Map<number, number>;
}

/** A part that an animation moves, as drawn: in metres of its landblock, turned by a quaternion (x, y, z, w). */
export interface MovingDrawn {
  block: number;
  object: number;
  part: number;
  position: THREE.Vector3Tuple;
  rotation: THREE.Vector4Tuple;
}

export class Objects {
  readonly group = new THREE.Group();
  /** Where the parts are that animations move. */
  readonly moving = new MovingParts();
  private readonly materials;
  private readonly edges;
  private readonly plants: Plants;
  private readonly blocks = new Map<number, Block | "none" | "asked">();
  private asked = 0;
  private retryAt = 0;
  private center = -1;
  private originX = 0;
  private originY = 0;
  private plain = false;

  constructor(cutaway: Cutaway) {
    this.materials = {
      objects: cutaway.cut(new THREE.MeshLambertMaterial({ color: 0x9c8460, flatShading: true }), "thing"),
      rocks: cutaway.cut(new THREE.MeshLambertMaterial({ vertexColors: true, flatShading: true }), "thing"),
      // The outer faces cast the shadow: the inner ones lie on the walls of the rooms, where light would leak in.
      shells: cutaway.cut(new THREE.MeshLambertMaterial({ color: 0xcdb58e, flatShading: true, shadowSide: THREE.FrontSide }), "shell"),
      // Floors lie in the ground's own plane.
      rooms: cutaway.cut(
        new THREE.MeshLambertMaterial({
          vertexColors: true,
          emissive: 0x2e2a22,
          flatShading: true,
          polygonOffset: true,
          polygonOffsetFactor: -1,
          polygonOffsetUnits: -2,
        }),
        "room",
      ),
    };
    const line = (): THREE.LineBasicMaterial => new THREE.LineBasicMaterial({ color: 0x2a2018, transparent: true, opacity: 0.45 });
    this.edges = { thing: cutaway.cut(line(), "thing"), shell: cutaway.cut(line(), "shell"), room: cutaway.cut(line(), "room") };
    this.plants = new Plants(cutaway, this.materials.objects);
  }

  /** Triangles drawn. */
  get triangles(): number {
    let sum = 0;
    this.group.traverseVisible((one) => {
      if (!(one instanceof THREE.Mesh)) return;
      const geometry = one.geometry as THREE.BufferGeometry;
      const corners = geometry.index?.count ?? geometry.getAttribute("position").count;
      sum += (corners / 3) * (one instanceof THREE.InstancedMesh ? one.count : 1);
    });
    return sum;
  }

  /** Plants that are drawn as plants. */
  get plantCount(): number {
    let sum = 0;
    if (!this.plain)
      for (const block of this.loaded()) for (const one of block.plants.near.children) sum += (one as THREE.InstancedMesh).count;
    return sum;
  }

  /** Plain collision shapes instead of plants and rocks. */
  get showsPlain(): boolean {
    return this.plain;
  }

  set showsPlain(shown: boolean) {
    this.plain = shown;
    this.chooseAll();
  }

  setOrigin(blockX: number, blockY: number): void {
    this.originX = blockX;
    this.originY = blockY;
    for (const [id, block] of this.blocks) if (typeof block === "object") this.place(block, id);
  }

  /** Fetches what is near the player's landblock and drops what is far. */
  update(block: number): void {
    if (block !== this.center) {
      this.center = block;
      this.drop(block);
      this.chooseAll();
    }
    for (let ring = 0; ring <= drawRadius && this.asked < fetchesAtOnce && performance.now() >= this.retryAt; ring++)
      this.askRing(block, ring);
  }

  /** Moves the parts that animations move to where they are at a moment, seconds of the server's clock. */
  moveParts(time: number): void {
    for (const [id, block] of this.blocks) {
      if (typeof block !== "object") continue;
      for (const { shape, drawn } of block.moving) this.moving.place(id, shape.object, shape.part, time, drawn);
    }
  }

  /** The parts drawn that animations move. */
  get movingDrawn(): MovingDrawn[] {
    const all: MovingDrawn[] = [];
    for (const [id, block] of this.blocks) {
      if (typeof block !== "object") continue;
      for (const { shape, drawn } of block.moving) {
        if (!drawn.visible) continue;
        const { x, y, z, w } = drawn.quaternion;
        all.push({ block: id, object: shape.object, part: shape.part, position: drawn.position.toArray(), rotation: [x, y, z, w] });
      }
    }
    return all;
  }

  /** Boxes around the buildings of a landblock and its neighbours, relative to the origin. */
  *shellsAround(block: number): Iterable<Box> {
    for (let dx = -1; dx <= 1; dx++) {
      for (let dy = -1; dy <= 1; dy++) {
        const near = this.blocks.get((((block >> 8) + dx) << 8) | ((block & 0xff) + dy));
        if (typeof near === "object") for (const shell of near.shells) yield shell.world;
      }
    }
  }

  /** The top of a room, metres; null when the room has not come. */
  topOf(cell: number): number | null {
    const block = this.blocks.get(cell >>> 16);
    return typeof block === "object" ? (block.roomTops.get(cell) ?? null) : null;
  }

  private *loaded(): Iterable<Block> {
    for (const block of this.blocks.values()) if (typeof block === "object") yield block;
  }

  private chooseAll(): void {
    for (const [id, block] of this.blocks) if (typeof block === "object") this.choose(id, block);
  }

  private choose(id: number, block: Block): void {
    const leafy = distance(id, this.center) <= leafyRadius;
    block.rocks.visible = !this.plain;
    block.plants.near.visible = !this.plain && leafy;
    block.plants.far.visible = !this.plain && !leafy;
    block.plants.plain.visible = this.plain;
  }

  private askRing(block: number, ring: number): void {
    for (let dx = -ring; dx <= ring; dx++) {
      for (let dy = -ring; dy <= ring; dy++) {
        if (Math.max(Math.abs(dx), Math.abs(dy)) !== ring || this.asked >= fetchesAtOnce) continue;
        const x = (block >> 8) + dx;
        const y = (block & 0xff) + dy;
        if (x >= 0 && y >= 0 && x < 255 && y < 255 && !this.blocks.has((x << 8) | y)) void this.fetch((x << 8) | y);
      }
    }
  }

  private async fetch(id: number): Promise<void> {
    this.asked++;
    this.blocks.set(id, "asked");
    try {
      const answer = await fetch(`/shapes/${id.toString(16).padStart(4, "0")}`);
      const shapes = answer.status === 200 ? decodeShapes(await answer.arrayBuffer()) : null;
      this.blocks.set(id, "none");
      if (shapes) this.add(id, shapes);
    } catch {
      // The server is away: ask again, but not with every frame.
      this.blocks.delete(id);
      this.retryAt = performance.now() + 1000;
    } finally {
      this.asked--;
    }
  }

  private add(id: number, shapes: Shapes): void {
    const plants = { near: new THREE.Group(), far: new THREE.Group(), plain: new THREE.Group() };
    const block: Block = { group: new THREE.Group(), rocks: new THREE.Group(), plants, shells: [], moving: [], roomTops: new Map() };
    const solid = (numbers: Float32Array, to: THREE.Group): void => {
      if (numbers.length > 0) to.add(...this.mesh(numbers, this.materials.objects, this.edges.thing));
    };
    solid(shapes.objects, block.group);
    solid(shapes.rocks, plants.plain);
    this.plants.addTo(plants, shapes.plants);
    if (shapes.rocks.length > 0) block.rocks.add(this.rocks(shapes.rocks));
    for (const shell of shapes.shells) {
      if (shell.triangles.length === 0) continue;
      block.shells.push({ low: boxOf(shell), world: { min: new THREE.Vector3(), max: new THREE.Vector3() } });
      block.group.add(...this.mesh(shell.triangles, this.materials.shells, this.edges.shell));
    }
    if (shapes.rooms.length > 0) block.group.add(...this.rooms(shapes.rooms, block));
    for (const shape of shapes.moving) {
      const drawn = new THREE.Group();
      // Until it is known where it is.
      drawn.visible = false;
      drawn.add(...this.mesh(shape.triangles, this.materials.objects, this.edges.thing));
      block.moving.push({ shape, drawn });
      block.group.add(drawn);
    }
    block.group.add(block.rocks, plants.near, plants.far, plants.plain);
    this.choose(id, block);
    this.place(block, id);
    this.blocks.set(id, block);
    this.group.add(block.group);
  }

  private mesh(positions: Float32Array, material: THREE.Material, edges: THREE.Material): [THREE.Mesh, THREE.LineSegments] {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    geometry.computeVertexNormals();
    const mesh = new THREE.Mesh(geometry, material);
    // A room's ceiling would put all of it in the shade.
    mesh.castShadow = material !== this.materials.rooms;
    mesh.receiveShadow = true;
    return [mesh, new THREE.LineSegments(new THREE.EdgesGeometry(geometry, sharpEdge), edges)];
  }

  /** All rooms of a block in one mesh; each corner knows its room's floor, so that rooms above the player's can be left out. */
  private rooms(rooms: NamedShape[], block: Block): [THREE.Mesh, THREE.LineSegments] {
    const corners: number[] = [];
    const floors: number[] = [];
    const lines: number[] = [];
    const lineFloors: number[] = [];
    for (const room of rooms) {
      if (room.triangles.length === 0) continue;
      const box = boxOf(room);
      block.roomTops.set(room.id, box.max.z);
      const part = new THREE.BufferGeometry();
      part.setAttribute("position", new THREE.BufferAttribute(room.triangles, 3));
      const edges = new THREE.EdgesGeometry(part, sharpEdge).getAttribute("position").array;
      for (const number of room.triangles) corners.push(number);
      for (const number of edges) lines.push(number);
      for (let i = 0; i < room.triangles.length / 3; i++) floors.push(box.min.z);
      for (let i = 0; i < edges.length / 3; i++) lineFloors.push(box.min.z);
    }
    const [mesh] = this.mesh(new Float32Array(corners), this.materials.rooms, this.edges.room);
    mesh.geometry.setAttribute("color", new THREE.BufferAttribute(roomColors(mesh.geometry.getAttribute("normal")), 3));
    mesh.geometry.setAttribute("roomFloor", new THREE.BufferAttribute(new Float32Array(floors), 1));
    const outline = new THREE.BufferGeometry();
    outline.setAttribute("position", new THREE.BufferAttribute(new Float32Array(lines), 3));
    outline.setAttribute("roomFloor", new THREE.BufferAttribute(new Float32Array(lineFloors), 1));
    return [mesh, new THREE.LineSegments(outline, this.edges.room)];
  }

  /** Grey stone, a little different from face to face, mossy where it looks up. */
  private rocks(positions: Float32Array): THREE.Mesh {
    const colors = new Float32Array(positions.length);
    const a = new THREE.Vector3();
    const b = new THREE.Vector3();
    const c = new THREE.Vector3();
    const normal = new THREE.Vector3();
    const color = new THREE.Color();
    for (let at = 0; at < positions.length; at += 9) {
      a.fromArray(positions, at);
      b.fromArray(positions, at + 3);
      c.fromArray(positions, at + 6);
      normal.subVectors(b, a).cross(c.sub(a)).normalize();
      const grain = Math.abs(Math.sin(normal.x * 41.3 + normal.y * 17.9 + a.x * 3.1 + a.y * 5.7)) * 0.14;
      color.setHSL(0.09 + 0.1 * Math.max(0, normal.z), 0.08 + 0.14 * Math.max(0, normal.z), 0.36 + grain);
      for (let k = 0; k < 3; k++) color.toArray(colors, at + k * 3);
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    geometry.setAttribute("color", new THREE.BufferAttribute(colors, 3));
    geometry.computeVertexNormals();
    const mesh = new THREE.Mesh(geometry, this.materials.rocks);
    mesh.castShadow = mesh.receiveShadow = true;
    return mesh;
  }

  private place(block: Block, id: number): void {
    block.group.position.set(((id >> 8) - this.originX) * blockSide, ((id & 0xff) - this.originY) * blockSide, 0);
    for (const { low, world } of block.shells) {
      world.min.addVectors(low.min, block.group.position);
      world.max.addVectors(low.max, block.group.position);
    }
  }

  private drop(center: number): void {
    for (const [id, block] of this.blocks) {
      if (distance(id, center) <= keepRadius || block === "asked") continue;
      this.blocks.delete(id);
      if (block === "none") continue;
      this.group.remove(block.group);
      block.group.traverse((one) => {
        if (one instanceof THREE.InstancedMesh) one.dispose();
        else if (one instanceof THREE.Mesh || one instanceof THREE.LineSegments) (one.geometry as THREE.BufferGeometry).dispose();
      });
    }
  }
}

/** How many landblocks apart two are, by the longer way. */
function distance(a: number, b: number): number {
  return Math.max(Math.abs((a >> 8) - (b >> 8)), Math.abs((a & 0xff) - (b & 0xff)));
}

/** Boards below, timber above, plaster between, one wall a little lighter than the next: rooms lie in the shade, where light alone shows no edges. */
function roomColors(normals: THREE.BufferAttribute | THREE.InterleavedBufferAttribute): Float32Array {
  const colors = new Float32Array(normals.count * 3);
  const floor = new THREE.Color(0xa07c50);
  const ceiling = new THREE.Color(0x8c7452);
  const wall = new THREE.Color(0xd6c4a0);
  const color = new THREE.Color();
  for (let i = 0; i < normals.count; i++) {
    const z = normals.getZ(i);
    if (z > 0.6) color.copy(floor);
    else if (z < -0.6) color.copy(ceiling);
    else color.copy(wall).multiplyScalar(0.8 + 0.2 * Math.abs(normals.getX(i)) + 0.1 * normals.getY(i));
    color.toArray(colors, i * 3);
  }
  return colors;
}

function boxOf(shape: NamedShape): THREE.Box3 {
  return new THREE.Box3().setFromArray(shape.triangles);
}
