// Which view of the file is shown.

import { signal } from "@preact/signals";
import type { Reply } from "./engine/protocol";

export type Tab = "motion" | "surely" | "map" | "design";
type Kind = NonNullable<Reply["kind"]>;

const MAP: [Tab, string] = ["map", "Map"];

/** The views of each kind of file, the first one first. */
export const TABS: Record<Kind, [Tab, string][]> = {
  scene: [["motion", "Motion"], ["surely", "How surely"], MAP, ["design", "Design"]],
  impact: [["motion", "Impact"], MAP],
  roll: [["motion", "Motion"], MAP],
  space: [["motion", "Motion"], ["surely", "How surely"], MAP],
  solid: [["motion", "Motion"], MAP],
};

export const tab = signal<Tab>("motion");
