// Simple materials for walls, floors and ceilings, so that a room can be read: boards and plaster in houses, stone in dungeons, courses of
// stone outside. They are worked out from where a surface is and how it faces; shapes for collisions have no coordinates of textures.

import type * as THREE from "three";

export type Masonry = "house" | "dungeon" | "shell";

/** Shared by all rooms. */
export interface RoomLook {
  /** How light rooms are: more for who is inside, less for who looks in through a doorway. */
  light: { value: number };
  /** Where one looks from, relative to the drawing's origin: the next room is darker, so that its doorway is seen. */
  from: { value: THREE.Vector3 };
}

const vertexHead = /* glsl */ `
  varying vec3 vStone;
`;

const vertexBody = /* glsl */ `
  vStone = (modelMatrix * vec4(transformed, 1.0)).xyz;
`;

const fragmentHead = /* glsl */ `
  varying vec3 vStone;
  uniform float uRoomLight;
  uniform vec3 uRoomFrom;

  float chance(vec2 cell) {
    return fract(sin(dot(cell, vec2(12.9898, 78.233))) * 43758.5453);
  }

  // 1 on a joint of this width every so many metres; none where joints would lie closer than the pixels.
  float joint(float at, float period, float width) {
    float blur = fwidth(at);
    float off = abs(fract(at / period + 0.5) - 0.5) * period;
    return (1.0 - smoothstep(width, width + 1.5 * blur, off)) * (1.0 - smoothstep(0.2 * period, 0.5 * period, blur));
  }

  // Rows of pieces, each row shifted: how light, less on the joints.
  float rows(float along, float across, float reach, float wide, float width, float spread) {
    float row = floor(across / wide);
    float shifted = along + reach * chance(vec2(row, 7.0));
    float seen = 1.0 - smoothstep(0.2 * wide, 0.8 * wide, fwidth(across));
    float tone = 1.0 + spread * (chance(vec2(row, floor(shifted / reach))) - 0.5) * seen;
    return tone * (1.0 - 0.45 * max(joint(across, wide, width), joint(shifted, reach, width)));
  }

  vec3 facing() {
    return normalize(cross(dFdx(vStone), dFdy(vStone)));
  }

  // Along a wall, metres.
  float alongWall(vec3 n) {
    // In coarse steps: the facing is worked out from pixels, and a wall is far from the origin.
    vec2 way = floor(normalize(vec2(-n.y, n.x)) * 32.0 + 0.5) / 32.0;
    // Both sides of a wall have the same joints.
    if (abs(way.x) > abs(way.y) ? way.x < 0.0 : way.y < 0.0) way = -way;
    return dot(vStone.xy, way);
  }
`;

const lightOfRoom = /* glsl */ `
  vec3 roomLight = tint * tone * uRoomLight * mix(1.0, 0.5, smoothstep(3.5, 13.0, distance(vStone, uRoomFrom)));
  diffuseColor.rgb *= roomLight;
  totalEmissiveRadiance *= roomLight;
`;

const surfaces: Record<Masonry, string> = {
  house: /* glsl */ `
    vec3 faces = facing();
    float tone = 1.0;
    vec3 tint = vec3(1.0);
    if (faces.z > 0.6) {
      tone = rows(vStone.x, vStone.y, 2.4, 0.24, 0.006, 0.24);
    } else if (faces.z < -0.6) {
      float beam = abs(fract(vStone.y / 1.2) - 0.5) * 1.2;
      tone = 1.0 - 0.4 * (1.0 - smoothstep(0.08, 0.08 + fwidth(vStone.y), beam));
    } else {
      float height = vStone.z - vRoomFloor;
      float panel = 1.0 - smoothstep(0.95, 0.95 + fwidth(height), height);
      float boards = rows(vStone.z, alongWall(faces), 9.0, 0.3, 0.008, 0.2);
      float rail = 1.0 - smoothstep(0.03, 0.03 + fwidth(height), abs(height - 0.95));
      tint = mix(vec3(1.0), vec3(0.66, 0.55, 0.44), panel);
      tone = mix(1.0, boards, panel) * (1.0 - 0.35 * rail);
    }
    ${lightOfRoom}
  `,
  dungeon: /* glsl */ `
    vec3 faces = facing();
    vec3 tint = vec3(0.72, 0.75, 0.8);
    float tone = abs(faces.z) > 0.6 ? rows(vStone.x, vStone.y, 1.5, 1.0, 0.018, 0.24)
      : rows(alongWall(faces), vStone.z, 1.2, 0.5, 0.016, 0.26);
    ${lightOfRoom}
  `,
  shell: /* glsl */ `
    vec3 faces = facing();
    float tone = faces.z > 0.35 ? rows(vStone.x + vStone.y * 0.37, vStone.z * 1.7 + vStone.y, 0.5, 0.4, 0.012, 0.22)
      : rows(alongWall(faces), vStone.z, 0.9, 0.4, 0.012, 0.16);
    diffuseColor.rgb *= tone;
  `,
};

/** Gives a material its pattern. One of rooms must also be cut away as rooms are, which tells the height of their floors. */
export function lay<M extends THREE.Material>(material: M, kind: Masonry, look: RoomLook): M {
  const before = material.onBeforeCompile.bind(material);
  const key = material.customProgramCacheKey();
  material.onBeforeCompile = (shader, renderer) => {
    before(shader, renderer);
    shader.uniforms.uRoomLight = look.light;
    shader.uniforms.uRoomFrom = look.from;
    shader.vertexShader = vertexHead + shader.vertexShader.replace("#include <project_vertex>", `#include <project_vertex>\n${vertexBody}`);
    shader.fragmentShader =
      fragmentHead + shader.fragmentShader.replace("#include <emissivemap_fragment>", `#include <emissivemap_fragment>\n${surfaces[kind]}`);
  };
  material.customProgramCacheKey = () => `${key} masonry ${kind}`;
  return material;
}

const forward = /* glsl */ `
  gl_Position = projectionMatrix * vec4(mvPosition.xyz * 0.9975, 1.0);
`;

// Out of the picture, and with both its ends: they lie in the same planes.
const turnedAway = /* glsl */ `
  vec3 wayToEye = cameraPosition - (modelMatrix * vec4(position, 1.0)).xyz;
  if (dot(faceA, wayToEye) <= 0.0 && dot(faceB, wayToEye) <= 0.0) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
`;

/**
 * Draws lines a little before the surfaces whose edges they are.
 * @param oneSided the surfaces are seen from one side only, and so are their edges: attributes `faceA` and `faceB` are the normals
 */
export function bringForward<M extends THREE.Material>(material: M, oneSided: boolean): M {
  const before = material.onBeforeCompile.bind(material);
  material.onBeforeCompile = (shader, renderer) => {
    before(shader, renderer);
    const head = oneSided ? "attribute vec3 faceA;\nattribute vec3 faceB;\n" : "";
    shader.vertexShader =
      head + shader.vertexShader.replace("#include <project_vertex>", `#include <project_vertex>\n${forward}${oneSided ? turnedAway : ""}`);
  };
  const key = material.customProgramCacheKey();
  material.customProgramCacheKey = () => `${key} forward ${oneSided}`;
  return material;
}
