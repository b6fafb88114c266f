// Objects, buildings and rooms around the player, as the shapes that bodies collide with.

import * as THREE from "three";
import { blockSide } from "./world";

const drawRadius = 3;
const keepRadius = 5;
const fetchesAtOnce = 3;
const sharpEdge = 20;

interface Shapes {
  group: THREE.Group;
  shells: THREE.Group;
}

export class Objects {
  readonly group = new THREE.Group();
  private readonly materials = {
    objects: new THREE.MeshLambertMaterial({ color: 0x9c8460, flatShading: true }),
    shells: new THREE.MeshLambertMaterial({ color: 0xcdb58e, flatShading: true }),
    // Floors lie in the ground's own plane.
    rooms: new THREE.MeshLambertMaterial({ color: 0xb59f7d, emissive: 0x2e271d, flatShading: true, polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -2 }),
  };
  private readonly edges = new THREE.LineBasicMaterial({ color: 0x2a2018, transparent: true, opacity: 0.45 });
  private readonly blocks = new Map<number, Shapes | "none" | "asked">();
  private asked = 0;
  private retryAt = 0;
  private center = -1;
  private originX = 0;
  private originY = 0;
  private indoors = false;

  /** Triangles drawn. */
  get triangles(): number {
    let sum = 0;
    this.group.traverse((one) => {
      if (one instanceof THREE.Mesh) sum += (one.geometry as THREE.BufferGeometry).getAttribute("position").count / 3;
    });
    return sum;
  }

  setOrigin(blockX: number, blockY: number): void {
    this.originX = blockX;
    this.originY = blockY;
    for (const [block, shapes] of this.blocks) if (typeof shapes === "object") this.place(shapes.group, block);
  }

  /**
   * @param block the player's landblock
   * @param indoors the player is in a room: the outsides of buildings step out of the view
   */
  update(block: number, indoors: boolean): void {
    if (indoors !== this.indoors) {
      this.indoors = indoors;
      for (const shapes of this.blocks.values()) if (typeof shapes === "object") shapes.shells.visible = !indoors;
    }
    if (block !== this.center) this.drop(block);
    this.center = block;
    for (let ring = 0; ring <= drawRadius && this.asked < fetchesAtOnce && performance.now() >= this.retryAt; ring++) this.askRing(block, ring);
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

  private async fetch(block: number): Promise<void> {
    this.asked++;
    this.blocks.set(block, "asked");
    try {
      const answer = await fetch(`/shapes/${block.toString(16).padStart(4, "0")}`);
      const shapes = answer.status === 200 ? this.build(await answer.arrayBuffer()) : null;
      this.blocks.set(block, shapes ?? "none");
      if (shapes) {
        this.place(shapes.group, block);
        this.group.add(shapes.group);
      }
    } catch {
      // The server is away: ask again, but not with every frame.
      this.blocks.delete(block);
      this.retryAt = performance.now() + 1000;
    } finally {
      this.asked--;
    }
  }

  private build(buffer: ArrayBuffer): Shapes | null {
    if (buffer.byteLength < 12) return null;
    const counts = new Uint32Array(buffer, 0, 3);
    const total = counts[0] + counts[1] + counts[2];
    if (total === 0 || buffer.byteLength !== 12 + total * 36) return null;
    const group = new THREE.Group();
    const shells = new THREE.Group();
    let start = 12;
    for (const [index, kind] of (["objects", "shells", "rooms"] as const).entries()) {
      const numbers = counts[index] * 9;
      if (numbers > 0) (kind === "shells" ? shells : group).add(...this.mesh(new Float32Array(buffer, start, numbers), this.materials[kind]));
      start += numbers * 4;
    }
    shells.visible = !this.indoors;
    group.add(shells);
    return { group, shells };
  }

  private mesh(positions: Float32Array, material: THREE.Material): THREE.Object3D[] {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    geometry.computeVertexNormals();
    const mesh = new THREE.Mesh(geometry, material);
    // A room's ceiling would put all of it in the shade.
    mesh.castShadow = material !== this.materials.rooms;
    mesh.receiveShadow = true;
    return [mesh, new THREE.LineSegments(new THREE.EdgesGeometry(geometry, sharpEdge), this.edges)];
  }

  private place(group: THREE.Group, block: number): void {
    group.position.set(((block >> 8) - this.originX) * blockSide, ((block & 0xff) - this.originY) * blockSide, 0);
  }

  private drop(center: number): void {
    for (const [block, shapes] of this.blocks) {
      const far = Math.max(Math.abs((block >> 8) - (center >> 8)), Math.abs((block & 0xff) - (center & 0xff)));
      if (far <= keepRadius || shapes === "asked") continue;
      this.blocks.delete(block);
      if (shapes === "none") continue;
      this.group.remove(shapes.group);
      shapes.group.traverse((one) => {
        if (one instanceof THREE.Mesh || one instanceof THREE.LineSegments) (one.geometry as THREE.BufferGeometry).dispose();
      });
    }
  }
}
