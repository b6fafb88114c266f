import { describe, expect, it } from "vitest";
import { WalkPath } from "./walk";
import { type OwnPose, PoseFlag } from "./wire";

/** The pose of a player who walks north. */
function pose(time: number, y: number, speed: number, walks: number, more: Partial<OwnPose> = {}): OwnPose {
  const where = { cell: 0xa9b50032, position: { x: 156, y, z: 20 }, yaw: 0 };
  const how = { flags: PoseFlag.Contact | PoseFlag.OnWalkable, velocity: { x: 0, y: speed, z: 0 }, speed, turn: 0 };
  return { kind: "pose", time, walks, teleports: 0, ...where, ...how, ...more } as OwnPose;
}

describe("the way of the last walk", () => {
  it("begins where the player set off and ends when it stands", () => {
    const walk = new WalkPath();
    walk.receive(pose(10, 24, 0, 1));
    walk.receive(pose(20, 24, 0, 1));
    for (let i = 1; i <= 16; i++) walk.receive(pose(20 + i / 8, 24 + i, 8, 2));
    walk.receive(pose(22.125, 40.5, 3, 2));
    for (let i = 2; i < 30; i++) walk.receive(pose(22 + i / 8, 40.5, 0, 2));
    expect(walk.metres).toBeCloseTo(16.5, 6);
    expect(walk.seconds).toBeCloseTo(2.125, 6);
    expect(walk.path[0].y).toBeCloseTo(walk.path[walk.path.length - 1].y - 16.5, 6);
  });

  it("begins anew with the next walk, and at another place", () => {
    const walk = new WalkPath();
    walk.receive(pose(1, 24, 0, 1));
    walk.receive(pose(2, 34, 10, 2));
    walk.receive(pose(6, 34, 0, 3, { turn: 1 }));
    expect(walk.path).toHaveLength(1);
    walk.receive(pose(7, 39, 5, 3));
    expect(walk.metres).toBeCloseTo(5, 6);
    walk.receive(pose(8, 100, 0, 4, { teleports: 1 }));
    expect(walk.metres).toBe(0);
    expect(walk.seconds).toBe(0);
  });

  it("keeps the whole of a long way, and not more points than it can draw", () => {
    const walk = new WalkPath();
    walk.receive(pose(0, 0, 0, 1));
    for (let i = 1; i <= 10_000; i++) walk.receive(pose(i, i, 1, 1));
    expect(walk.metres).toBeCloseTo(10_000, 6);
    expect(walk.path.length).toBeLessThanOrEqual(3000);
    expect(walk.path[walk.path.length - 1].y - walk.path[0].y).toBeCloseTo(10_000, 0);
  });
});
