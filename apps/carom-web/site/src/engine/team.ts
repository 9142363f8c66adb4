// Several workers for long work: each does a portion, and the first puts them together.

import { Engine } from "./engine";
import type { Doc, Reply, Shared } from "./protocol";

/** More workers than this wait for each other's memory. */
const MOST = 8;

export class Team {
  private readonly engines: Engine[];

  constructor(size = Math.min(MOST, Math.max(1, navigator.hardwareConcurrency))) {
    this.engines = Array.from({ length: size }, () => new Engine("carom-whole.wasm"));
  }

  get size(): number {
    return this.engines.length;
  }

  /** Does the work, in as many rounds as it needs. */
  async study(doc: Doc, study: Shared): Promise<Reply> {
    try {
      const known: string[][] = [];
      for (;;) {
        const asked = { study, round: known.length, of: this.size };
        const replies = await Promise.all(this.engines.map((engine, number) => engine.study(doc, { portion: { ...asked, number } })));
        const failed = replies.find(({ failure }) => failure !== undefined);
        if (failed !== undefined) return failed;
        known.push(replies.map(({ portion }) => portion ?? ""));
        const [first] = this.engines;
        if (first === undefined) throw new Error("there is no worker");
        const reply = await first.study(doc, { joined: { study, known } });
        if (reply.again !== true) return reply;
      }
    } catch (error) {
      // What the others still do is of no use.
      this.stop();
      throw error;
    }
  }

  /** Ends what runs; who waits is told. */
  stop(): void {
    this.engines.forEach((engine) => engine.stop());
  }
}
