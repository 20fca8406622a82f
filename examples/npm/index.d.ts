/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

/** Numbers one after the other. */
export type Numbers = ArrayLike<number> & Iterable<number>;

/** Three numbers of each vertex or triangle: in one array, as three.js has them, or as an array of rows. */
export type Triples = Numbers | ReadonlyArray<readonly [number, number, number]>;

export interface ScaleOptions {
  /** Lengths change by at most this factor, more than 1; `null`: any. 2 by default. A rho beyond it is replaced
   *  by the nearest one within, and the report tells how much is kept. */
  maxScale?: number | null;
}

export interface EditOptions extends ScaleOptions {
  /** Whether to start from the last result of this surface, which is faster. */
  continues?: boolean;
}

export interface Target {
  vertex: number;
  to: readonly [number, number, number] | Float64Array;
}

/** What was measured on the result, as `conformal --json` writes it. */
export interface Report {
  command: 'spin' | 'deform' | 'flow';
  version: string;
  /** Whether the result is conformal and closes up, within the limits of the program. */
  verified: boolean;
  /** Why it is not verified. */
  error?: string;
  notes: string[];
  result: {
    /** The ratio of the singular values of each triangle's map; 1: no shear. */
    quasi_conformal: {mean: number; p99: number; max: number};
    scale: {min: number; max: number; [name: string]: unknown};
    flipped_faces: number;
    /** `spinTransform`: what the result has of rho. */
    realised_curvature?: {share: number; correlation: number; wrong_sign: number; left_out: number;
                          [name: string]: unknown};
    /** `willmoreFlow`: the integral of H^2 over the area. */
    energy?: {initial: number; final: number};
    converged?: boolean;
    steps?: number;
    [name: string]: unknown;
  };
}

export interface Result {
  /** Three numbers of each vertex. */
  positions: Float64Array;
  /** Those that were given. */
  triangles: Uint32Array;
  /** The quasi-conformal error of each triangle. */
  quality: Float32Array;
  report: Report;
}

/** What the kernels refuse: surfaces that are not connected, oriented manifolds of positive areas, arrays of
 *  the wrong length, numbers that are not finite. */
export class Refusal extends Error {}

/** A surface that was read. */
export interface ReadSurface {
  /** Three numbers of each vertex. */
  positions: Float64Array;
  /** Polygons are cut into triangles, oriented alike and outward. */
  triangles: Uint32Array;
  /** Of each vertex, its number in the file. */
  vertexInFile: Uint32Array;
  /** What was done to it. */
  notes: string[];
}

/** Reads a mesh file: PLY, OBJ, OFF, STL, GLB, glTF or VTK. Throws `Refusal` for what cannot be read, with the line, and for
 *  what is not one oriented manifold of positive areas, which `repair` mends where it can.
 *  @param name of the file, for messages and for its extension */
export function readSurface(bytes: Uint8Array, name: string, options?: {repair?: boolean}): Promise<ReadSurface>;

/** Deforms a surface without shear so that its mean curvature changes by `rho`, a number of each vertex in
 *  1 / length. A constant rho changes nothing. Computes on the thread that calls it. */
export function spinTransform(positions: Triples, triangles: Triples, rho: Numbers,
                              options?: ScaleOptions): Promise<Result>;

/** Moves some vertices to their targets; the surface follows without shear. */
export function deform(positions: Triples, triangles: Triples, targets: readonly Target[],
                       options?: ScaleOptions): Promise<Result>;

/** Smoothes a surface by the conformal Willmore flow, for so many steps (10) or until it has converged. */
export function willmoreFlow(positions: Triples, triangles: Triples,
                             options?: {steps?: number}): Promise<Result>;

/** Many edits of one surface: what depends on the surface alone is computed once. Each result is an edit of
 *  the surface that was opened. */
export class Surface {
  private constructor();
  static open(positions: Triples, triangles: Triples): Promise<Surface>;
  transform(rho: Numbers, options?: ScaleOptions): Result;
  /** Approximates `transform()` quickly, for every frame of a stroke. */
  preview(rho: Numbers, options?: EditOptions): Result;
  deform(targets: readonly Target[], options?: EditOptions): Result;
  /** Takes more steps of the flow of the surface. */
  flow(steps?: number): Result;
}
