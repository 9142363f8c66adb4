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

declare module "*/carom-figure/src/solid.js" {
  /** Plays a body in space on the elements of a page; from where it is seen is kept in `view`. */
  export function solidPlayer(page: Element, numbers: unknown, view: object): void;
}
