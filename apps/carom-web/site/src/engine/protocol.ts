// What the engine is asked and answers: the types of `apps/carom-web/src/request.rs` and `reply.rs`.

export type Pair = [number, number];

/** The window of a picture: lower left corner [m], pixels in a metre, size [px]. */
export interface Window {
  low: Pair;
  scale: number;
  size: Pair;
}

/** What is held of a plate, a wall or the part; given back as it came. */
export interface Held {
  obstacle: number | null;
  hold: "first" | "middle" | "last";
  at: Pair;
  ends: [Pair, Pair];
  cut: [boolean, boolean];
}

export interface Grip {
  label: string;
  at: Pair;
  held: Held;
  moves: string[];
}

export interface Motion {
  samples: unknown[];
  stages: unknown[];
  strikes: number[];
}

export interface Seen {
  scene: string;
  motion: Motion;
  grips: Grip[];
  words: string;
}

export interface Headline {
  word: string;
  plate: string | null;
  wanted: boolean | null;
}

export interface Sections {
  verdict: string;
  timeline: string;
  part: string;
  stages: string;
  model: string;
}

export interface Quantity {
  path: string;
  label: string;
  text: string;
  written: boolean;
  value: number;
  allowed: [number | null, number | null];
  unit: string;
  si: number;
}

export interface Limit {
  quantity: string;
  low: number | null;
  high: number | null;
  low_end: "flips" | "no_such_feeder" | "end_of_search";
  low_kept: number;
  high_end: "flips" | "no_such_feeder" | "end_of_search";
  high_kept: number;
}

export interface Problem {
  path: string;
  key: string | null;
  value: string | null;
  message: string;
  allowed: string[];
  help: string | null;
}

export interface Failure {
  message: string;
  problems: Problem[];
  lines: (number | null)[];
}

export interface Reply {
  text?: string;
  window?: Window;
  seen?: Seen;
  headline?: Headline;
  sections?: Sections;
  quantities?: Quantity[];
  controls?: string;
  html?: string;
  scenes?: { name: string; text: string }[];
  limit?: Limit;
  files?: Record<string, string>;
  failure?: Failure;
}

/** A scene and the files beside it. */
export interface Doc {
  name: string;
  text: string;
  files: Record<string, string>;
}

/** An axis of a map: its quantity and its ends, SI. */
export interface Side {
  path: string;
  from: number;
  to: number;
}

export type Ask =
  | { open: { size: Pair } }
  | { show: { window: Window } }
  | { drag: { grip: Held; to: Pair; snap: Pair; window: Window } }
  | { write: { path: string; value: string; window: Window } }
  | { add: { table: "plate" | "wall"; from: Pair; to: Pair; snap: number; window: Window } }
  | { remove: { obstacle: number; window: Window } }
  | { part: { lines: string; size: Pair } }
  | { strike: { number: number } }
  | { limit: { path: string } }
  | { yield: { samples: number; seed: number } }
  | { map: { axes: [Side, Side]; cells: number; depth: number; accuracy: number } }
  | { at: { values: Record<string, number> } }
  | { move: { values: Record<string, number>; window: Window } }
  | "files"
  | "drawings"
  | { race: { runs: number } };
