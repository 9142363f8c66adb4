declare module "*/carom-figure/src/player.js" {
  interface Player {
    load(numbers: unknown): void;
    goTo(time: number): void;
    press(key: string, fast: boolean): boolean;
  }
  /** The player of the reports: plays the motion that it was given on the elements of a page. */
  export function player(page: Element): Player;
  export type { Player };
}
