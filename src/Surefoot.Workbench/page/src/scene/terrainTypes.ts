// Colours of the 32 terrain types, as sRGB. Types 16 to 20 are water.

export const terrainColors: readonly number[] = [
  0x7d746a, // barren rock
  0x6f9443, // grassland
  0xd5e6ee, // ice
  0x4f8a38, // lush grass
  0x63703f, // marsh, sparse swamp
  0x66503a, // mud, rich dirt
  0x33313a, // obsidian plain
  0x8a7050, // packed dirt
  0x84734a, // patchy dirt
  0x7f8f4c, // patchy grassland
  0xd6bd83, // yellow sand
  0xb5ab98, // grey sand
  0xc2aa7d, // rock-strewn sand
  0x97836a, // sedimentary rock
  0x86806b, // semi-barren rock
  0xeef3f7, // snow
  0x3d8fa3, // running water
  0x3f86a0, // standing fresh water
  0x46a3ac, // shallow sea
  0x3b97a8, // shallow still sea
  0x1f5f86, // deep sea
  0x50663a, // forest floor
  0x4b8b92, // faux running water
  0x5a7a4a, // sea slime
  0x9a6a45, // argila
  0x4d3a35, // volcano
  0x5f4038, // volcano
  0xa9cfe4, // blue ice
  0x55793f, // moss
  0x3d5d36, // dark moss
  0x55485c, // olthoi
  0x6c6054, // desolate lands
];

export function terrainType(word: number): number {
  return (word >> 2) & 31;
}

export function isWater(word: number): boolean {
  const type = terrainType(word);
  return type >= 16 && type <= 20;
}

export function isRoad(word: number): boolean {
  return (word & 3) !== 0;
}

const grassy = new Set([1, 3, 4, 9, 21, 28, 29]);

export function isGrassy(type: number): boolean {
  return grassy.has(type);
}
