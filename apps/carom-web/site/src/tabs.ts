// Which view of the scene is shown.

import { signal } from "@preact/signals";

export type Tab = "motion" | "surely" | "map" | "design";

export const TABS: [Tab, string][] = [
  ["motion", "Motion"],
  ["surely", "How surely"],
  ["map", "Map"],
  ["design", "Design"],
];

export const tab = signal<Tab>("motion");
