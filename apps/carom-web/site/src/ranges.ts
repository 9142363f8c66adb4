// Ranges of quantities to begin with.

import type { Pair, Quantity } from "./engine/protocol";
import { limits } from "./state";

/** A range to begin with: where the verdict holds and as much again, or a half to twice the value. */
export function rangeOf(quantity: Quantity): Pair {
  const limit = limits.peek().get(quantity.path)?.limit;
  const { value } = quantity;
  const size = value === 0 ? 0.5 : Math.abs(value);
  const low = limit?.low_end === "flips" ? limit.low_kept : value - 0.5 * size;
  const high = limit?.high_end === "flips" ? limit.high_kept : value + 0.5 * size;
  const more = 0.5 * Math.min(high - low, 2 * size);
  const from = value >= 0 ? Math.max(low - more, value === 0 ? 0 : 0.05 * size) : low - more;
  const [least, most] = quantity.allowed;
  return [Math.max(from, least ?? from), Math.min(high + more, value + 2 * size, most ?? Number.POSITIVE_INFINITY)];
}
