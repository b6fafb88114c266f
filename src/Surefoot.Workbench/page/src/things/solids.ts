// What rooms, buildings, rocks and other solid things are made of, and how their triangles become meshes.

import * as THREE from "three";
import type { NamedShape } from "../net/shapes";
import type { Cutaway } from "../scene/cutaway";
import { bringForward, lay, type RoomLook } from "../scene/masonry";
import { type Edges, edgesOf } from "./edges";

const sharpEdge = 20;

/** A mesh and the lines of its edges. */
export type Solid = [THREE.Mesh, THREE.LineSegments];

export class Solids {
  readonly look: RoomLook = { light: { value: 1 }, from: { value: new THREE.Vector3() } };
  /** Things outdoors, and the plain shapes of plants. */
  readonly plain: THREE.Material;
  private readonly materials;
  private readonly edges;

  constructor(cutaway: Cutaway) {
    const room = { vertexColors: true, emissive: 0x3a3226, flatShading: true };
    this.plain = cutaway.cut(new THREE.MeshLambertMaterial({ color: 0x9c8460, flatShading: true }), "thing");
    this.materials = {
      rocks: cutaway.cut(new THREE.MeshLambertMaterial({ vertexColors: true, flatShading: true }), "thing"),
      // The outer faces cast the shadow: the inner ones lie on the walls of the rooms, where light would leak in.
      shell: cutaway.cut(
        lay(new THREE.MeshLambertMaterial({ color: 0xcdb58e, flatShading: true, shadowSide: THREE.FrontSide }), "shell", this.look),
        "shell",
      ),
      house: cutaway.cut(lay(new THREE.MeshLambertMaterial(room), "house", this.look), "room"),
      dungeon: cutaway.cut(lay(new THREE.MeshLambertMaterial(room), "dungeon", this.look), "room"),
    };
    const line = (oneSided: boolean): THREE.LineBasicMaterial =>
      bringForward(new THREE.LineBasicMaterial({ color: 0x1c1510, transparent: true, opacity: 0.6 }), oneSided);
    this.edges = {
      thing: cutaway.cut(line(false), "thing"),
      shell: cutaway.cut(line(true), "shell"),
      room: cutaway.cut(line(true), "room"),
    };
  }

  /** Things that stand or move outdoors. */
  things(positions: Float32Array): Solid {
    const mesh = meshOf(positions, this.plain);
    return [mesh, new THREE.LineSegments(new THREE.EdgesGeometry(mesh.geometry, sharpEdge), this.edges.thing)];
  }

  /** The outside of a building. */
  shell(positions: Float32Array): Solid {
    return [meshOf(positions, this.materials.shell), new THREE.LineSegments(linesOf([edgesOf(positions)]), this.edges.shell)];
  }

  /**
   * All rooms of a block in one mesh; each corner knows its room's floor, so that rooms above the player's can be left out.
   * @param rooms with the lowest z of each
   * @param underground they belong to no building
   */
  rooms(rooms: readonly { shape: NamedShape; floor: number }[], underground: boolean): Solid {
    const corners: number[] = [];
    const floors: number[] = [];
    const edges: Edges[] = [];
    const lineFloors: number[] = [];
    for (const { shape, floor } of rooms) {
      const around = edgesOf(shape.triangles);
      edges.push(around);
      for (const number of shape.triangles) corners.push(number);
      for (let i = 0; i < shape.triangles.length / 3; i++) floors.push(floor);
      for (let i = 0; i < around.ends.length / 3; i++) lineFloors.push(floor);
    }
    const mesh = meshOf(new Float32Array(corners), underground ? this.materials.dungeon : this.materials.house);
    // A room's ceiling would put all of it in the shade.
    mesh.castShadow = false;
    mesh.geometry.setAttribute("color", new THREE.BufferAttribute(roomColors(mesh.geometry.getAttribute("normal")), 3));
    mesh.geometry.setAttribute("roomFloor", new THREE.BufferAttribute(new Float32Array(floors), 1));
    const outline = linesOf(edges);
    outline.setAttribute("roomFloor", new THREE.BufferAttribute(new Float32Array(lineFloors), 1));
    return [mesh, new THREE.LineSegments(outline, this.edges.room)];
  }

  /** Grey stone, a little different from face to face, mossy where it looks up. */
  rocks(positions: Float32Array): THREE.Mesh {
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
    const mesh = meshOf(positions, this.materials.rocks);
    mesh.geometry.setAttribute("color", new THREE.BufferAttribute(colors, 3));
    return mesh;
  }
}

function pointsOf(positions: Float32Array): THREE.BufferGeometry {
  return new THREE.BufferGeometry().setAttribute("position", new THREE.BufferAttribute(positions, 3));
}

function linesOf(edges: readonly Edges[]): THREE.BufferGeometry {
  const joined = (name: keyof Edges): THREE.BufferAttribute => {
    const all = new Float32Array(edges.reduce((sum, one) => sum + one[name].length, 0));
    let at = 0;
    for (const one of edges) {
      all.set(one[name], at);
      at += one[name].length;
    }
    return new THREE.BufferAttribute(all, 3);
  };
  const lines = new THREE.BufferGeometry().setAttribute("position", joined("ends"));
  return lines.setAttribute("faceA", joined("faceA")).setAttribute("faceB", joined("faceB"));
}

function meshOf(positions: Float32Array, material: THREE.Material): THREE.Mesh {
  const geometry = pointsOf(positions);
  geometry.computeVertexNormals();
  const mesh = new THREE.Mesh(geometry, material);
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}

/**
 * Boards below, timber above, plaster between, one wall a little lighter than the next: rooms lie in the shade, where light alone shows no
 * edges.
 */
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
