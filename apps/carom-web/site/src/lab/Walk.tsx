// The walk in impulse space: where each contact is at an instant, and what happens in each stage.

import type { Lab } from "../engine/protocol";
import { at, between, mixed, walking } from "./Lab";

/** Before the first stage, within one, or at the end of one. */
function words(lab: Lab, instant: number): string {
  if (instant === 0) return "before the impact";
  const stage = Math.ceil(instant);
  const what = lab.stages[stage - 1];
  // Springs and sequences have no straight stages.
  if (what === undefined) return instant === 1 ? "after the impact" : "from before to after";
  return `stage ${stage} of ${lab.stages.length}, ${instant === stage ? "its end; " : ""}${what}`;
}

export function Walk({ lab }: { lab: Lab }) {
  const last = lab.motion.length - 1;
  const box = /viewBox="([^"]*)"/.exec(lab.walk)?.[1];
  const go = (to: number) => {
    walking.value = false;
    at.value = Math.min(last, Math.max(0, to));
  };
  const play = () => {
    if (!walking.value && at.value >= last) at.value = 0;
    walking.value = !walking.value;
  };
  return (
    <div class="walk-view">
      <div class="controls" role="group" aria-label="The walk, stage by stage">
        <button type="button" id="walk-play" disabled={last < 1} onClick={play}>
          {walking.value ? "Pause" : "Walk"}
        </button>
        <button type="button" aria-label="One stage back" disabled={at.value <= 0} onClick={() => go(Math.ceil(at.value) - 1)}>
          ◂
        </button>
        <button type="button" id="walk-next" aria-label="One stage on" disabled={at.value >= last} onClick={() => go(Math.floor(at.value) + 1)}>
          ▸
        </button>
        <input type="range" id="walk-at" aria-label="How far the walk is" min={0} max={last} step={0.01} value={at.value} disabled={last < 1} onInput={(event) => go(Number(event.currentTarget.value))} />
        <span role="status">{last < 1 ? (lab.stages.length > 0 ? "" : "there is no walk") : words(lab, at.value)}</span>
      </div>
      {last < 1 && lab.stages.length > 0 && (
        <ol class="stages-told">
          {lab.stages.map((stage) => (
            <li key={stage}>{stage}</li>
          ))}
        </ol>
      )}
      {lab.walk !== "" && (
        <div class={`walk-picture${lab.tracks.length === 1 ? " plane" : ""}`}>
          <div dangerouslySetInnerHTML={{ __html: lab.walk }} />
          {box !== undefined && (
            <svg class="fig markers" viewBox={box} aria-hidden="true">
              {lab.tracks.map(([contact, places], track) => {
                const now = between(places, at.value);
                if (now === undefined) return null;
                const [a, b, share] = now;
                return <circle key={track} class={`marker k${contact % 6}`} cx={mixed(a[0], b[0], share)} cy={mixed(a[1], b[1], share)} r={6} />;
              })}
            </svg>
          )}
        </div>
      )}
    </div>
  );
}
