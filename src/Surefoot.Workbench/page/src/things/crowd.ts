// Many people who stand: one figure's shape, baked in its pose, drawn many times in clothes of different colours.

import * as THREE from "three";
import { mergeGeometries, mergeVertices } from "three/addons/utils/BufferGeometryUtils.js";
import { Figure } from "./figure";

const most = 256;

export class Crowd {
  readonly group = new THREE.Group();
  private readonly clothes: THREE.InstancedMesh;
  private readonly rest: THREE.InstancedMesh;

  constructor() {
    const { clothes, rest } = bake();
    const material = new THREE.MeshLambertMaterial({ vertexColors: true });
    this.clothes = new THREE.InstancedMesh(clothes, material, most);
    this.rest = new THREE.InstancedMesh(rest, material, most);
    for (const mesh of [this.clothes, this.rest]) {
      mesh.count = 0;
      mesh.castShadow = mesh.receiveShadow = true;
      // Bounds are those of one figure at the origin; the crowd moves with the drawing's origin.
      mesh.frustumCulled = false;
      this.group.add(mesh);
    }
    const color = new THREE.Color();
    for (let i = 0; i < most; i++) this.clothes.setColorAt(i, color.setHSL((i * 0.381966) % 1, 0.45, 0.5));
  }

  /** People drawn. */
  get count(): number {
    return this.clothes.count;
  }

  /** Who stands where, relative to the drawing's origin; the height is the figure's scale. */
  place(people: readonly { id: number; x: number; y: number; z: number; yaw: number }[]): void {
    const matrix = new THREE.Matrix4();
    const turn = new THREE.Quaternion();
    const up = new THREE.Vector3(0, 0, 1);
    const count = Math.min(people.length, most);
    for (let i = 0; i < count; i++) {
      const one = people[i];
      const height = 0.95 + 0.09 * ((one.id * 0.618034) % 1);
      matrix.compose(new THREE.Vector3(one.x, one.y, one.z), turn.setFromAxisAngle(up, one.yaw), new THREE.Vector3(height, height, height));
      this.clothes.setMatrixAt(i, matrix);
      this.rest.setMatrixAt(i, matrix);
    }
    for (const mesh of [this.clothes, this.rest]) {
      mesh.count = count;
      mesh.instanceMatrix.needsUpdate = true;
    }
  }
}

function bake(): { clothes: THREE.BufferGeometry; rest: THREE.BufferGeometry } {
  const figure = new Figure(0, null, "plain");
  figure.group.updateMatrixWorld(true);
  const clothes: THREE.BufferGeometry[] = [];
  const rest: THREE.BufferGeometry[] = [];
  figure.group.traverse((one) => {
    if (!(one instanceof THREE.Mesh)) return;
    const material = one.material as THREE.MeshLambertMaterial;
    const source = one.geometry as THREE.BufferGeometry;
    const shape = (source.index ? source.toNonIndexed() : source.clone()).applyMatrix4(one.matrixWorld);
    shape.deleteAttribute("uv");
    const count = shape.getAttribute("position").count;
    const colors = new Float32Array(count * 3);
    for (let i = 0; i < count; i++) material.color.toArray(colors, i * 3);
    shape.setAttribute("color", new THREE.BufferAttribute(colors, 3));
    (material.userData.tinted ? clothes : rest).push(shape);
  });
  const merged = { clothes: mergeVertices(mergeGeometries(clothes)), rest: mergeVertices(mergeGeometries(rest)) };
  figure.dispose();
  return merged;
}
