// Tufts of grass around the player, for the eye only: nothing collides with them.

import * as THREE from "three";
import { terrainColors } from "./terrainTypes";

const spacing = 0.5;
const radius = 19;
const redoAfter = 3;
const bladesOfTuft = 7;
const side = Math.ceil((2 * radius) / spacing);

export interface GrassyGround {
  /** Height and terrain type where grass grows at global metres, else null. */
  grassAt(x: number, y: number): { height: number; type: number } | null;
}

export class Grass {
  readonly mesh: THREE.InstancedMesh;
  private readonly uniforms = { uTime: { value: 0 }, uCenter: { value: new THREE.Vector3() } };
  private lastX = Number.NaN;
  private lastY = Number.NaN;

  constructor() {
    const material = new THREE.MeshLambertMaterial({ side: THREE.DoubleSide });
    material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, this.uniforms);
      shader.vertexShader = `uniform float uTime;\nuniform vec3 uCenter;\nvarying float vRise;\n${shader.vertexShader}`.replace(
        "#include <begin_vertex>",
        /* glsl */ `
          vec3 transformed = position;
          vec3 root = (modelMatrix * instanceMatrix * vec4(0.0, 0.0, 0.0, 1.0)).xyz;
          transformed *= 1.0 - smoothstep(${(radius * 0.55).toFixed(1)}, ${radius.toFixed(1)}, distance(root.xy, uCenter.xy));
          float sway = sin(uTime * 1.6 + root.x * 0.35 + root.y * 0.28) + 0.5 * sin(uTime * 3.1 + root.x * 1.3);
          transformed.xy += vec2(0.05, 0.03) * sway * position.z * position.z * 6.0;
          vRise = position.z;
        `,
      );
      // Both faces of a blade are lit from above, as the ground under it is.
      shader.fragmentShader = `varying float vRise;\n${shader.fragmentShader}`
        .replace("#include <color_fragment>", "#include <color_fragment>\ndiffuseColor.rgb *= 0.82 + 1.3 * vRise;")
        .replace(
          "#include <normal_fragment_begin>",
          "float faceDirection = 1.0;\nvec3 normal = normalize(vNormal);\nvec3 nonPerturbedNormal = normal;",
        );
    };
    this.mesh = new THREE.InstancedMesh(tuft(), material, side * side);
    this.mesh.receiveShadow = true;
    this.mesh.frustumCulled = false;
    this.mesh.count = 0;
  }

  /**
   * @param x global metres of the player
   * @param y global metres of the player
   * @param origin what drawn positions are relative to
   */
  update(x: number, y: number, origin: THREE.Vector3, ground: GrassyGround, seconds: number): void {
    this.uniforms.uTime.value = seconds;
    this.uniforms.uCenter.value.set(x - origin.x, y - origin.y, 0);
    if (Math.hypot(x - this.lastX, y - this.lastY) < redoAfter) return;
    this.plant(x, y, origin, ground);
    this.lastX = x;
    this.lastY = y;
  }

  /** Plants anew with the next update: the land has changed, or what positions are relative to. */
  invalidate(): void {
    this.lastX = Number.NaN;
  }

  private plant(x: number, y: number, origin: THREE.Vector3, ground: GrassyGround): void {
    const place = new THREE.Matrix4();
    const turn = new THREE.Quaternion();
    const up = new THREE.Vector3(0, 0, 1);
    const at = new THREE.Vector3();
    const size = new THREE.Vector3();
    const color = new THREE.Color();
    const firstX = Math.round((x - radius) / spacing);
    const firstY = Math.round((y - radius) / spacing);
    let count = 0;
    for (let i = 0; i < side; i++) {
      for (let j = 0; j < side; j++) {
        const roll = scramble(firstX + i, firstY + j);
        if (roll(0) < 0.25) continue;
        const px = (firstX + i + roll(1)) * spacing;
        const py = (firstY + j + roll(2)) * spacing;
        const found = ground.grassAt(px, py);
        if (!found) continue;
        at.set(px - origin.x, py - origin.y, found.height - 0.02);
        turn.setFromAxisAngle(up, roll(3) * Math.PI * 2);
        const tall = 0.55 + 0.75 * roll(4);
        size.set(0.8 + 0.5 * roll(5), 0.8 + 0.5 * roll(5), tall);
        this.mesh.setMatrixAt(count, place.compose(at, turn, size));
        this.mesh.setColorAt(count, color.set(terrainColors[found.type]).multiplyScalar(0.8 + 0.35 * roll(6)));
        count++;
      }
    }
    this.mesh.count = count;
    this.mesh.instanceMatrix.needsUpdate = true;
    if (this.mesh.instanceColor) this.mesh.instanceColor.needsUpdate = true;
  }
}

/** Random numbers that belong to a point of the grid, so that the same tuft grows wherever one comes from. */
function scramble(x: number, y: number): (which: number) => number {
  return (which) => {
    let h = Math.imul(x, 0x27d4eb2d) ^ Math.imul(y, 0x165667b1) ^ Math.imul(which + 1, 0x9e3779b9);
    h = Math.imul(h ^ (h >>> 15), 0x85ebca6b);
    h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
    return ((h ^ (h >>> 16)) >>> 0) / 4294967296;
  };
}

/** A handful of bent blades, lit as the ground is. */
function tuft(): THREE.BufferGeometry {
  const points: number[] = [];
  for (let blade = 0; blade < bladesOfTuft; blade++) {
    const angle = (blade / bladesOfTuft) * Math.PI * 2 + blade * 0.7;
    const lean = 0.05 + 0.05 * (blade % 3);
    const tall = 0.17 + 0.05 * ((blade * 5) % 4);
    const root = 0.05 + 0.05 * (blade % 2);
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const half = 0.011;
    points.push(
      c * root - s * half,
      s * root + c * half,
      0,
      c * root + s * half,
      s * root - c * half,
      0,
      c * (root + lean),
      s * (root + lean),
      tall,
    );
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
  geometry.setAttribute(
    "normal",
    new THREE.Float32BufferAttribute(
      points.map((_, i) => (i % 3 === 2 ? 1 : 0)),
      3,
    ),
  );
  return geometry;
}
