import { describe, expect, it } from "vitest";
import { PoseTimeline, ServerClock, wrapAngle } from "./timeline";
import type { Pose } from "./wire";

const pose = (time: number, x: number, more: Partial<Pose> = {}): Pose => ({
  teleports: 0, flags: 3, time, cell: 0xa9b40001, position: { x, y: 10, z: 5 }, yaw: 0, velocity: { x: 10, y: 0, z: 0 }, charge: 0, forward: 1, sidestep: 0, ...more,
});
const blockWest = 0xa9 * 192;

describe("a timeline", () => {
  it("draws between two poses on the line that joins them", () => {
    const line = new PoseTimeline();
    line.push(pose(1, 20));
    line.push(pose(1.04, 24));
    expect(line.at(1.01)?.position.x).toBeCloseTo(blockWest + 21, 9);
    expect(line.at(1.03)?.position.x).toBeCloseTo(blockWest + 23, 9);
  });

  it("joins poses across a landblock's border", () => {
    const line = new PoseTimeline();
    line.push(pose(1, 191));
    line.push(pose(1.04, 1, { cell: 0xaab40001 }));
    expect(line.at(1.02)?.position.x).toBeCloseTo(blockWest + 192, 9);
  });

  it("turns the short way round", () => {
    const line = new PoseTimeline();
    line.push(pose(1, 0, { yaw: 3 }));
    line.push(pose(2, 0, { yaw: -3 }));
    expect(wrapAngle(line.at(1.5)!.yaw)).toBeCloseTo(Math.PI, 9);
  });

  it("goes on at the last velocity for a tenth of a second when poses are late", () => {
    const line = new PoseTimeline();
    line.push(pose(1, 20));
    expect(line.at(1.05)?.position.x).toBeCloseTo(blockWest + 20.5, 9);
    expect(line.at(9)?.position.x).toBeCloseTo(blockWest + 21, 9);
  });

  it("does not draw a line between the two ends of a teleport", () => {
    const line = new PoseTimeline();
    line.push(pose(1, 20));
    line.push(pose(1.04, 150, { teleports: 1 }));
    expect(line.at(1.02)?.position.x).toBe(blockWest + 150);
  });
});

describe("the server's clock", () => {
  it("runs forward at the rate of time, behind by about a quantum", () => {
    const clock = new ServerClock(1 / 30);
    let last = -Infinity;
    for (let frame = 0; frame < 300; frame++) {
      const now = 100 + frame / 60;
      if (frame % 2 === 0) clock.arrived(now - 90, now + (frame % 6 === 0 ? 0.004 : 0));
      const drawn = clock.drawTime(now);
      expect(drawn).toBeGreaterThanOrEqual(last);
      last = drawn;
      if (frame > 120) {
        expect(now - 90 - drawn).toBeGreaterThan(1 / 30);
        expect(now - 90 - drawn).toBeLessThan(0.1);
      }
    }
  });
});
