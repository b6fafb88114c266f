import { describe, expect, it } from "vitest";
import { type Place, searchPlaces } from "./places";

const places = [
  { name: "The meadow", hint: "Walk on level ground; the lake lies behind." },
  { name: "The lake shore", hint: "Wade in." },
  { name: "In the middle of the lake", hint: "Walk on the bed." },
  { name: "Steps of 0.5 m", hint: null },
  { name: "In the shallows", hint: "Stand knee-deep." },
  { name: "In the hall", hint: "Walk through the doorways." },
] as Place[];

describe("a search for places", () => {
  it("finds the name first, then names that begin so, then other names, then hints", () => {
    expect(searchPlaces("in the hall", places)).toEqual([5, 4]);
    expect(searchPlaces("hall", places)).toEqual([5, 4]);
    expect(searchPlaces("lake", places)).toEqual([1, 2, 0]);
    expect(searchPlaces("LAKE  the middle", places)).toEqual([2]);
    expect(searchPlaces("walk", places)).toEqual([0, 2, 5]);
    expect(searchPlaces("0.5", places)).toEqual([3]);
  });

  it("finds all without a word, and none for a word that nobody says", () => {
    expect(searchPlaces(" ", places)).toEqual([0, 1, 2, 3, 4, 5]);
    expect(searchPlaces("attic", places)).toEqual([]);
  });
});
