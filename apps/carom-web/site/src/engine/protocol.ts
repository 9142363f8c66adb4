// What the engine is asked and answers: the types of `apps/carom-web/src/request.rs` and `reply.rs`.

export type Pair = [number, number];

/** The window of a picture: lower left corner [m], pixels in a metre, size [px]; of an impact pixels for 1 m/s. */
export interface Window {
  low: Pair;
  scale: number;
  size: Pair;
  speed: number;
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

/** What is pulled of an impact; given back as it came. */
export interface Pulled {
  table: string;
  key: "point" | "normal" | "centre" | "velocity";
  from: Pair;
}

export interface LabGrip {
  label: string;
  at: Pair;
  pulled: Pulled;
  contact: number | null;
}

/** What another law or way to share makes of an impact. */
export interface Beside {
  name: string;
  said: string;
  energy: Pair | null;
  asked: boolean;
}

/** An impact on the bench. */
export interface Lab {
  lead: string;
  sketch: string;
  unseen: string;
  centres: Pair[];
  motion: [number, number, number][][];
  grips: LabGrip[];
  walk: string;
  tracks: [number, Pair[]][];
  stages: string[];
  after: string;
  hypotheses: string;
  laws: Beside[];
  sharings: Beside[];
  forces: { headline: string; motions: Pair2[]; rejected: Pair2[] } | null;
  words: string;
}

type Pair2 = [string, string];

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
  about: string;
  choices: string[];
  number: boolean;
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

/** What `[design]` says, and what is wanted on the plates. */
export interface DesignAsked {
  wants: [string, string][];
  free: { path: string; from: number; to: number }[];
  limits: { key: string; label: string; text: string; unit: string }[];
  forbid_walls: boolean;
  aim: string;
  aims: string[];
}

/** A layout to look at and to take. */
export interface Candidate {
  text: string;
  words: string;
  picture: string;
  size: Pair;
  rows: [string, string][];
}

export interface DesignFound {
  verdict: string;
  possible: boolean;
  said: string[];
  candidates: Candidate[];
  forbidden: string[][];
  files: Record<string, string>;
}

export interface Reply {
  elsewhere?: boolean;
  kind?: "scene" | "space" | "impact" | "roll" | "solid";
  text?: string;
  window?: Window;
  seen?: Seen;
  headline?: Headline;
  sections?: Sections;
  quantities?: Quantity[];
  controls?: string;
  html?: string;
  scenes?: { name: string; text: string }[];
  portion?: string;
  again?: boolean;
  limit?: Limit;
  files?: Record<string, string>;
  lab?: Lab;
  solid?: { player: string; motion: unknown; chart: string; words: string };
  design?: DesignAsked;
  found?: DesignFound;
  failure?: Failure;
}

/** A file of Carom and the files beside it; the lesson that it belongs to, where it is one's. */
export interface Doc {
  lesson?: string;
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

/** Where a picture is: a window that is there, or a new one around all of the motion. */
export type Frame = { size: Pair } | { window: Window };

/** A change of a scene. */
export type Change =
  | { drag: { grip: Held; to: Pair; snap: Pair } }
  | { write: { path: string; value: string } }
  | { move: { values: Record<string, number> } }
  | { add: { table: "plate" | "wall"; from: Pair; to: Pair; snap: number } }
  | { remove: { obstacle: number } }
  | { want: { plate: number; want: string } }
  | { pull: { pulled: Pulled; at: Pair; fine: boolean } }
  | { add_contact: { at: Pair } }
  | { remove_contact: { contact: number } }
  | { replace: { table: "part" | "design"; lines: string } };

/** A question about a scene as it stands. */
export type Study =
  | { strike: { number: number } }
  | { limit: { path: string } }
  | { at: { values: Record<string, number> } }
  | { design: { scan: number; samples: number; seed: number } }
  | "files"
  | "drawings"
  | { race: { runs: number } };

/** Long work that several workers share. */
export type Shared =
  | { yield: { samples: number; seed: number } }
  | { map: { axes: [Side, Side]; cells: number; depth: number; accuracy: number } };

export type Ask =
  | { show: { change?: Change; frame: Frame } }
  | { study: Study }
  | { portion: { study: Shared; round: number; number: number; of: number } }
  | { joined: { study: Shared; known: string[][] } };

/** What a worker tells while it works: drops so far, and news of the request. */
export interface Progress {
  steps: number;
  news?: News;
}

/** How far a design is, with the best layout so far. */
export interface News {
  look: number;
  looks: number;
  best: Candidate | null;
}
