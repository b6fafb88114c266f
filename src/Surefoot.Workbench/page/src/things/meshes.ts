// What figures, beasts and doors have in common.

import * as THREE from "three";

export function matte(color: THREE.ColorRepresentation): THREE.MeshLambertMaterial {
  return new THREE.MeshLambertMaterial({ color });
}

/** Frees the shapes and materials of all meshes in a group, none of which is used elsewhere. */
export function disposeMeshes(group: THREE.Group): void {
  group.traverse((one) => {
    if (!(one instanceof THREE.Mesh)) return;
    one.geometry.dispose();
    (one.material as THREE.Material).dispose();
  });
}
