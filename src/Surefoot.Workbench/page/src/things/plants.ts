// Trees and shrubs where bodies meet cylinders and spheres: a few shapes, drawn many times.

import * as THREE from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";
import type { Plant } from "../net/shapes";
import type { Cutaway } from "../scene/cutaway";

/** Kinds of plants: the cylinder (or sphere) that each is made for, metres, and its look. */
interface Kind {
  radius: number;
  height: number;
  near: THREE.BufferGeometry;
  far: THREE.BufferGeometry;
}

/** Where a landblock's plants go: with all their leaves, as seen from afar, and as the shapes that bodies meet. */
export interface PlantGroups {
  near: THREE.Group;
  far: THREE.Group;
  plain: THREE.Group;
}

/** A cylinder more than this many times as high as it is wide carries a pine. */
const pineSlimness = 14;

export class Plants {
  private readonly kinds: Record<"tree" | "pine" | "shrub", Kind>;
  private readonly shapes = {
    cylinder: new THREE.CylinderGeometry(1, 1, 1, 12).rotateX(Math.PI / 2).translate(0, 0, 0.5),
    sphere: new THREE.SphereGeometry(0.5, 12, 8).translate(0, 0, 0.5),
  };
  private readonly material: THREE.Material;

  /**
   * @param cutaway cuts plants away before the player
   * @param plain what their plain collision shapes are made of
   */
  constructor(
    cutaway: Cutaway,
    private readonly plain: THREE.Material,
  ) {
    this.material = cutaway.cut(new THREE.MeshLambertMaterial({ vertexColors: true, flatShading: true }), "thing");
    this.kinds = {
      tree: { radius: 0.35, height: 4, near: tree(), far: farTree() },
      pine: { radius: 0.3, height: 5, near: pine(), far: farPine() },
      shrub: { radius: 0.5, height: 1, near: shrub(), far: farShrub() },
    };
  }

  addTo(groups: PlantGroups, list: readonly Plant[]): void {
    for (const name of ["tree", "pine", "shrub"] as const) {
      const some = list.filter((plant) => kindOf(plant) === name);
      if (some.length === 0) continue;
      const kind = this.kinds[name];
      const near = this.instances(
        kind.near,
        this.material,
        some,
        (plant) => new THREE.Vector3(plant.radius / kind.radius, plant.radius / kind.radius, plant.height / kind.height),
        true,
      );
      const far = new THREE.InstancedMesh(kind.far, this.material, some.length);
      far.instanceMatrix = near.instanceMatrix;
      far.instanceColor = near.instanceColor;
      groups.near.add(near);
      groups.far.add(far);
      const shape = name === "shrub" ? this.shapes.sphere : this.shapes.cylinder;
      const width = name === "shrub" ? 2 : 1;
      groups.plain.add(
        this.instances(
          shape,
          this.plain,
          some,
          (plant) => new THREE.Vector3(plant.radius * width, plant.radius * width, plant.height),
          false,
        ),
      );
    }
  }

  private instances(
    geometry: THREE.BufferGeometry,
    material: THREE.Material,
    plants: readonly Plant[],
    size: (plant: Plant) => THREE.Vector3,
    varied: boolean,
  ): THREE.InstancedMesh {
    const mesh = new THREE.InstancedMesh(geometry, material, plants.length);
    const place = new THREE.Matrix4();
    const turn = new THREE.Quaternion();
    const up = new THREE.Vector3(0, 0, 1);
    const tint = new THREE.Color();
    for (const [i, plant] of plants.entries()) {
      const chance = scatter(plant.low.x, plant.low.y);
      turn.setFromAxisAngle(up, varied ? chance * 2 * Math.PI : 0);
      mesh.setMatrixAt(i, place.compose(new THREE.Vector3(plant.low.x, plant.low.y, plant.low.z), turn, size(plant)));
      if (varied) mesh.setColorAt(i, tint.setRGB(0.86 + 0.28 * scatter(plant.low.y, plant.low.x), 0.88 + 0.2 * chance, 0.86));
    }
    mesh.castShadow = mesh.receiveShadow = true;
    return mesh;
  }
}

/** What a plant looks like. */
export function kindOf(plant: Plant): "tree" | "pine" | "shrub" {
  if (plant.round) return "shrub";
  return plant.height > plant.radius * pineSlimness ? "pine" : "tree";
}

/** A number in [0, 1) that looks like chance and is always the same for a place. */
function scatter(a: number, b: number): number {
  const wave = Math.sin(a * 12.9898 + b * 78.233) * 43758.5453;
  return wave - Math.floor(wave);
}

function tree(): THREE.BufferGeometry {
  return mergeGeometries([
    trunk(0.34, 0.2, 2.9),
    ...roots(0.34),
    blob(0, 0, 3.7, 1.75, 1.5, 0x4f7a35),
    blob(0.95, 0.25, 3.1, 1.05, 0.95, 0x476f30),
    blob(-0.7, 0.75, 3.2, 1.1, 0.95, 0x57833b),
    blob(-0.3, -0.95, 3.05, 1.0, 0.9, 0x436b2f),
    blob(0.25, 0.1, 4.75, 1.05, 0.9, 0x648f42),
  ]);
}

function pine(): THREE.BufferGeometry {
  return mergeGeometries([
    trunk(0.29, 0.14, 2.2),
    ...roots(0.29),
    cone(1.55, 2.0, 1.4, 0x2f5a38),
    cone(1.3, 1.9, 2.5, 0x356340),
    cone(1.0, 1.8, 3.7, 0x3c6c46),
    cone(0.66, 1.7, 4.9, 0x45764d),
  ]);
}

function shrub(): THREE.BufferGeometry {
  return mergeGeometries([
    blob(0, 0, 0.45, 0.5, 0.45, 0x55803a),
    blob(0.25, 0.12, 0.32, 0.3, 0.3, 0x4b7434),
    blob(-0.2, -0.2, 0.34, 0.32, 0.3, 0x608c42),
  ]);
}

function farTree(): THREE.BufferGeometry {
  return mergeGeometries([trunk(0.34, 0.2, 2.9, 4), blob(0, 0, 3.5, 1.75, 1.55, 0x4c7633, 0), blob(0.2, 0.1, 4.7, 1.1, 0.95, 0x608a3f, 0)]);
}

function farPine(): THREE.BufferGeometry {
  return mergeGeometries([trunk(0.29, 0.14, 1.6, 4), cone(1.5, 3, 1.4, 0x325f3b, 5), cone(0.9, 2.9, 3.7, 0x3e6e48, 5)]);
}

function farShrub(): THREE.BufferGeometry {
  return blob(0, 0, 0.45, 0.52, 0.46, 0x55803a, 0);
}

function trunk(low: number, high: number, height: number, sides = 9): THREE.BufferGeometry {
  return painted(new THREE.CylinderGeometry(high, low, height, sides, 1, true).rotateX(Math.PI / 2).translate(0, 0, height / 2), 0x6a5138);
}

/** Feet of the trunk, so that it grows out of the ground and does not stand on it. */
function roots(radius: number): THREE.BufferGeometry[] {
  return [0, 1, 2, 3].map((i) => {
    const angle = (i * Math.PI) / 2 + 0.4;
    const root = new THREE.ConeGeometry(0.14, 0.9, 5)
      .rotateX(Math.PI / 2)
      .rotateY(0.35)
      .translate(radius * 0.75, 0, 0.25)
      .rotateZ(angle);
    return painted(root, 0x5d4631);
  });
}

function cone(radius: number, height: number, low: number, color: number, sides = 9): THREE.BufferGeometry {
  return painted(
    new THREE.ConeGeometry(radius, height, sides)
      .rotateX(Math.PI / 2)
      .rotateZ(low)
      .translate(0, 0, low + height / 2),
    color,
  );
}

/** A lump of leaves: a ball whose corners are pushed about. */
function blob(x: number, y: number, z: number, width: number, height: number, color: number, detail = 1): THREE.BufferGeometry {
  const ball = new THREE.IcosahedronGeometry(1, detail);
  const corners = ball.getAttribute("position");
  for (let i = 0; i < corners.count; i++) {
    const push =
      0.86 +
      0.28 * scatter(Math.round(corners.getX(i) * 50) + x * 7, Math.round(corners.getY(i) * 50) + Math.round(corners.getZ(i) * 50) * 3);
    corners.setXYZ(i, corners.getX(i) * push, corners.getY(i) * push, corners.getZ(i) * push);
  }
  return painted(ball.scale(width, width, height).translate(x, y, z), color);
}

/** Colours a shape, darker towards its foot, and brings it into the form that shapes are joined in. */
function painted(geometry: THREE.BufferGeometry, color: number): THREE.BufferGeometry {
  const shape = geometry.index ? geometry.toNonIndexed() : geometry;
  shape.deleteAttribute("uv");
  shape.computeVertexNormals();
  shape.computeBoundingBox();
  const { min, max } = shape.boundingBox!;
  const position = shape.getAttribute("position");
  const colors = new Float32Array(position.count * 3);
  const base = new THREE.Color(color);
  for (let i = 0; i < position.count; i++) {
    const light = 0.72 + 0.4 * ((position.getZ(i) - min.z) / Math.max(0.01, max.z - min.z));
    base
      .clone()
      .multiplyScalar(light)
      .toArray(colors, i * 3);
  }
  shape.setAttribute("color", new THREE.BufferAttribute(colors, 3));
  return shape;
}
