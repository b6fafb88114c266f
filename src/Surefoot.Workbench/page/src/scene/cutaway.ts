// Cuts away what hides the player: whatever lies between the camera and the player, floors above the room the player is in, and the shell
// of the building that the player or the camera is inside of. Materials discard the fragments; nothing is moved or rebuilt.

import * as THREE from "three";

/**
 * Metres above the feet of the middle of what must be seen, its half width and half height, and by how much the rim of the cut is wider.
 */
const targetHeight = 1.15;
const clearWidth = 0.6;
const clearHeight = 0.8;
const rim = 1.3;

/** From this distance on the cut keeps its size on screen, metres. */
const growsFrom = 8;

/** Cellars that are open at a time, and how far from their walls, metres. */
const mostCellars = 4;
const wall = 0.2;

/** An upright box, relative to the drawing's origin. */
export interface Box {
  min: THREE.Vector3;
  max: THREE.Vector3;
}

/** What a material is, for the cut. */
export type CutKind = "shell" | "room" | "thing" | "ground";

const vertexHead = /* glsl */ `
  varying vec3 vCutPlace;
  #ifdef CUT_ROOM
  attribute float roomFloor;
  varying float vRoomFloor;
  #endif
`;

const vertexBody = /* glsl */ `
  vec4 cutPlace = vec4(transformed, 1.0);
  #ifdef USE_INSTANCING
  cutPlace = instanceMatrix * cutPlace;
  #endif
  vCutPlace = (modelMatrix * cutPlace).xyz;
  #ifdef CUT_ROOM
  vRoomFloor = roomFloor;
  #endif
`;

const fragmentHead = /* glsl */ `
  varying vec3 vCutPlace;
  #ifdef CUT_ROOM
  varying float vRoomFloor;
  #endif
  uniform vec3 uCutEye;
  uniform vec3 uCutTarget;
  uniform float uCutCeiling;
  uniform vec3 uCutMin;
  uniform vec3 uCutMax;
  uniform float uCutOpens;
  uniform vec4 uCutCellars[${mostCellars}];

  bool isInCutBox() {
    return all(greaterThan(vCutPlace, uCutMin)) && all(lessThan(vCutPlace, uCutMax));
  }

  // Interleaved gradient noise: an even grain, so that the rim of the cut fades without blending.
  float cutGrain() {
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  }

  bool isBetween() {
    vec3 way = uCutTarget - uCutEye;
    float far = length(way);
    vec3 from = vCutPlace - uCutEye;
    float along = dot(from, way) / far;
    // What is nearer to the target than its own radius is beside the player and not before it.
    if (along < 0.0 || along > far - 0.35) return false;
    float cone = max(along / far, 0.12);
    vec3 aside = normalize(cross(way, vec3(0.0, 0.0, 1.0)) + vec3(1e-5, 0.0, 0.0));
    vec3 off = from - way * (along / far);
    float across = dot(off, aside);
    vec2 apart = vec2(across / ${clearWidth.toFixed(2)}, length(off - aside * across) / ${clearHeight.toFixed(2)});
    float beside = length(apart) / (cone * max(1.0, far / ${growsFrom.toFixed(1)}));
    float edge = (beside - 1.0) / ${(rim - 1).toFixed(2)};
    return edge < cutGrain();
  }
`;

const fragmentBody: Record<CutKind, string> = {
  shell: /* glsl */ `if ((uCutOpens > 0.5 && isInCutBox()) || isBetween()) discard;`,
  room: /* glsl */ `if (vRoomFloor > uCutCeiling || (uCutOpens > 1.5 && isInCutBox()) || isBetween()) discard;`,
  thing: /* glsl */ `if (isBetween()) discard;`,
  ground: /* glsl */ `
    for (int i = 0; i < ${mostCellars}; i++)
      if (all(greaterThan(vCutPlace.xy, uCutCellars[i].xy)) && all(lessThan(vCutPlace.xy, uCutCellars[i].zw))) discard;
  `,
};

/** Where the camera is: 0 the player is outdoors, 1 the player is inside, 2 only the camera is inside. */
type Opens = 0 | 1 | 2;

export class Cutaway {
  private readonly uniforms = {
    uCutEye: { value: new THREE.Vector3() },
    uCutTarget: { value: new THREE.Vector3() },
    uCutCeiling: { value: Infinity },
    uCutMin: { value: new THREE.Vector3() },
    uCutMax: { value: new THREE.Vector3() },
    uCutOpens: { value: 0 as Opens },
    uCutCellars: { value: Array.from({ length: mostCellars }, () => new THREE.Vector4()) },
  };

  /** Off, nothing is cut away. */
  enabled = true;

  /** Whether anything was opened in the last frame, and why; see the shader. */
  get opens(): Opens {
    return this.uniforms.uCutOpens.value;
  }

  /** Floors above this are not drawn, metres; infinite outdoors. */
  get ceiling(): number {
    return this.uniforms.uCutCeiling.value;
  }

  /** Makes a material give way. Rooms need an attribute `roomFloor`: the lowest z of the room that a corner belongs to. */
  cut<M extends THREE.Material>(material: M, kind: CutKind): M {
    const before = material.onBeforeCompile.bind(material);
    const key = material.customProgramCacheKey();
    material.onBeforeCompile = (shader, renderer) => {
      before(shader, renderer);
      Object.assign(shader.uniforms, this.uniforms);
      const define = kind === "room" ? "#define CUT_ROOM\n" : "";
      shader.vertexShader =
        define + vertexHead + shader.vertexShader.replace("#include <project_vertex>", `#include <project_vertex>\n${vertexBody}`);
      shader.fragmentShader =
        define +
        fragmentHead +
        shader.fragmentShader.replace("#include <clipping_planes_fragment>", `#include <clipping_planes_fragment>\n${fragmentBody[kind]}`);
    };
    material.customProgramCacheKey = () => `${key} cut ${kind}`;
    return material;
  }

  /** Opens the ground over cellars: the floors above them have holes. */
  openCellars(cellars: Iterable<Box>): void {
    const all = [...cellars];
    for (const [i, open] of this.uniforms.uCutCellars.value.entries()) {
      const cellar = all[i];
      if (cellar) open.set(cellar.min.x + wall, cellar.min.y + wall, cellar.max.x - wall, cellar.max.y - wall);
      else open.set(0, 0, 0, 0);
    }
  }

  /**
   * @param eye the camera
   * @param feet the player's feet
   * @param indoors the player is in a room
   * @param ceiling the top of that room, metres; null when it is not known
   * @param shells boxes around the buildings near by
   */
  update(eye: THREE.Vector3, feet: THREE.Vector3, indoors: boolean, ceiling: number | null, shells: Iterable<Box>): void {
    const u = this.uniforms;
    u.uCutEye.value.copy(eye);
    u.uCutTarget.value.set(feet.x, feet.y, feet.z + targetHeight);
    u.uCutCeiling.value = indoors && ceiling !== null ? ceiling - 0.3 : 1e9;
    u.uCutOpens.value = 0;
    if (!this.enabled) {
      u.uCutTarget.value.copy(eye);
      u.uCutCeiling.value = 1e9;
      return;
    }
    for (const box of shells) {
      const inside = indoors && contains(box, u.uCutTarget.value);
      if (!inside && !(contains(box, eye) && !indoors)) continue;
      u.uCutOpens.value = inside ? 1 : 2;
      u.uCutMin.value.copy(box.min).subScalar(0.05);
      u.uCutMax.value.copy(box.max).addScalar(0.05);
      // Cellars reach below the shell.
      u.uCutMin.value.z = -1e9;
      break;
    }
  }
}

/** Inside the walls, at any depth: cellars lie below the shell. */
function contains(box: Box, point: THREE.Vector3): boolean {
  const { min, max } = box;
  return point.x > min.x && point.y > min.y && point.x < max.x && point.y < max.y && point.z < max.z;
}
